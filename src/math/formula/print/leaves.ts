import { type DisplayParts, displayParts, MINUS } from '../../../text/format.ts';
import { float64 } from '../../arithmetic/float64.ts';
import { AXES, axisIndex } from '../../vec3.ts';
import { evaluate, type Values } from '../evaluate.ts';
import { comp, type Expr, minus, plus, scalar, times, type VectorExpr } from '../expr.ts';
import { type Leaves, type Marks, mathNotation, type Piece, RANK } from './math-notation.ts';
import { print } from './printer.ts';

/**
 * The formula in its symbols.
 *
 * @param expr the tree.
 * @param marks the medium: LATEX, MATHML, templates of a page.
 * @example
 * inSymbols(DISCRIMINANT, LATEX); // → 'B^{2} - 4AC'
 */
export function inSymbols<M>(expr: Expr, marks: Marks<M>): M {
  return print(expr, mathNotation(marks, symbols(marks))).m;
}

/**
 * The formula with the numbers put in; what has none stays a symbol.
 *
 * @param expr the tree.
 * @param marks the medium, as for `inSymbols`.
 * @param values doubles by symbol, in the units of the formula.
 * @param options `worked`: with −B, √D, 2A and N·d already worked out; `digits`: significant digits
 *   of each number, a whole number from 1 on.
 * @example
 * const values = { scalars: { A: 1, B: -20, C: 84 }, vectors: {} };
 * inNumbers(DISCRIMINANT, LATEX, values, { worked: false, digits: 6 });
 * // → '(-20)^{2} - 4 \\cdot 1 \\cdot 84'
 */
export function inNumbers<M>(
  expr: Expr,
  marks: Marks<M>,
  values: Values<number>,
  options: { readonly worked: boolean; readonly digits: number },
): M {
  return print(expr, mathNotation(marks, numbers(marks, values, options))).m;
}

/**
 * A number as it is typeset: true minus, powers of ten raised.
 *
 * @param x any double, of any unit: none is written.
 * @param marks the medium, as for `inSymbols`.
 * @param digits significant digits, a whole number from 1 on.
 * @example
 * numberPiece(-1.5e-9, LATEX).m; // → '-1.5 \\cdot 10^{-9}'
 */
export function numberPiece<M>(x: number, marks: Marks<M>, digits = 6): Piece<M> {
  return partsPiece(displayParts(x, digits), marks);
}

/**
 * The same of a number whose digits are chosen already.
 *
 * @param parts its mantissa, with a true minus, and its exponent of ten or null.
 * @param marks the medium, as for `inSymbols`.
 * @example
 * partsPiece({ mantissa: '1.5', exponent: 3 }, LATEX).m; // → '1.5 \\cdot 10^{3}'
 */
export function partsPiece<M>({ mantissa, exponent }: DisplayParts, marks: Marks<M>): Piece<M> {
  const negative = mantissa.startsWith(MINUS);
  const sign = negative ? [marks.minus] : [];
  const figures = marks.numeral(negative ? mantissa.slice(MINUS.length) : mantissa);
  const power =
    exponent === null
      ? []
      : [marks.operator('·'), marks.power(marks.numeral('10'), numberPiece(exponent, marks).m)];
  return {
    m: marks.join([...sign, figures, ...power]),
    rank: negative || exponent !== null ? RANK.product : RANK.single,
    starts: negative ? 'minus' : 'numeral',
  };
}

/** (3, 1, −0.5) */
function triple<M>(parts: readonly M[], marks: Marks<M>): M {
  return marks.parens(
    marks.join(parts.flatMap((m, i) => (i > 0 ? [marks.operator(','), m] : [m]))),
  );
}

/**
 * A vector as it is typeset.
 *
 * @param v its components, in one unit.
 * @param marks the medium, as for `inSymbols`.
 * @param digits significant digits of each, a whole number from 1 on.
 * @example
 * numberTriple([3, 1, -0.5], LATEX); // → '(3, 1, -0.5)'
 */
export function numberTriple<M>(v: readonly number[], marks: Marks<M>, digits = 6): M {
  return triple(
    v.map((x) => numberPiece(x, marks, digits).m),
    marks,
  );
}

function symbols<M>(marks: Marks<M>): Leaves<M> {
  const single = (m: M): Piece<M> => ({ m, rank: RANK.single, starts: 'other' });
  const vector = (expr: VectorExpr): Piece<M> => {
    if (expr.op === 'vector') return single(marks.symbol(expr.id, 'vector'));
    if (expr.op === 'moved') {
      const step = marks.join([marks.symbol(expr.by, 'scalar'), vector(expr.step).m]);
      const m = marks.join([vector(expr.from).m, marks.operator('+'), step]);
      return { m, rank: RANK.sum, starts: 'other' };
    }
    const right = vector(expr.right);
    const inner = right.rank === RANK.sum ? marks.parens(right.m) : right.m;
    const m = marks.join([vector(expr.left).m, marks.operator('−'), inner]);
    return { m, rank: RANK.sum, starts: 'other' };
  };
  return {
    number: (value) => numberPiece(value, marks),
    scalar: (id) => single(marks.symbol(id, 'scalar')),
    component: (id, axis) => ({
      ...single(marks.component(id, axis)),
      squared: marks.componentSquared(id, axis),
    }),
    vector,
    whole: () => null,
  };
}

function numbers<M>(
  marks: Marks<M>,
  values: Values<number>,
  { worked, digits }: { readonly worked: boolean; readonly digits: number },
): Leaves<M> {
  const put = (x: number | undefined, id: string, sort: 'scalar' | 'vector'): Piece<M> => {
    const piece = numberPiece(x ?? Number.NaN, marks, digits);
    return { ...piece, m: marks.put(piece.m, id, sort) };
  };
  const leaves: Leaves<M> = {
    number: (value) => numberPiece(value, marks, digits),
    // What has no number yet stays a symbol: t, x.
    scalar: (id) =>
      values.scalars[id] === undefined
        ? { m: marks.symbol(id, 'scalar'), rank: RANK.single, starts: 'other' }
        : put(values.scalars[id], id, 'scalar'),
    component: (id, axis) =>
      values.vectors[id] === undefined
        ? { m: marks.component(id, axis), rank: RANK.single, starts: 'other' }
        : put(values.vectors[id][axisIndex(axis)], id, 'vector'),
    /** (3 − 0, 1 − 1, 1 − 0) */
    vector: (expr) => {
      const parts = AXES.map((axis) => print(along(expr, axis), mathNotation(marks, leaves)).m);
      return { m: triple(parts, marks), rank: RANK.single, starts: 'other' };
    },
    whole: (expr) =>
      worked && isWorked(expr) ? numberPiece(evaluate(expr, float64, values), marks, digits) : null,
  };
  return leaves;
}

/** One component of a vector, as a formula of its own. */
export function along(expr: VectorExpr, axis: (typeof AXES)[number]): Expr {
  if (expr.op === 'vector') return comp(expr.id, axis);
  if (expr.op === 'moved') {
    return plus(along(expr.from, axis), times(scalar(expr.by), along(expr.step, axis)));
  }
  return minus(along(expr.left, axis), along(expr.right, axis));
}

/**
 * Whether this part of a formula is printed as one number where −B, √D, 2A and N·d are worked out.
 */
export function isWorked({ op }: Expr): boolean {
  return op === 'negative' || op === 'root' || op === 'product' || op === 'dot';
}
