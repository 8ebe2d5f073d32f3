import { mathml, nothing, type TemplateResult } from 'lit';
import { float64 } from '../math/arithmetic/float64.ts';
import type { Values } from '../math/formula/evaluate.ts';
import { evaluate } from '../math/formula/evaluate.ts';
import type { Expr, Relation, VectorExpr } from '../math/formula/expr.ts';
import { AXES, type Axis, axisIndex } from '../math/vec3.ts';
import { displayParts } from '../text/format.ts';
import { classOf, highlightOf } from './symbols.ts';

/** A typeset piece, and what has to be known to put it next to others. */
interface Piece {
  readonly m: TemplateResult;
  /** How tightly it holds together: 1 a sum, 2 a product or a minus sign, 3 a power, 4 a single thing. */
  readonly rank: 1 | 2 | 3 | 4;
  /** What it begins with: a numeral cannot follow another factor without a dot, a minus sign no plus. */
  readonly starts: Start;
}

type Start = 'numeral' | 'minus' | 'other';

/** How the leaves are written: as symbols, or as the numbers they stand for. */
interface Leaves {
  scalar(id: string): Piece;
  component(vector: string, axis: Axis): Piece;
  vector(expr: VectorExpr): Piece;
  /** A subtree that is shown worked out, or null to go on into it. */
  whole(expr: Expr): Piece | null;
}

const piece = (m: TemplateResult, rank: Piece['rank'], starts: Start = 'other'): Piece => ({
  m,
  rank,
  starts,
});

/** The formula in its symbols. */
export function typesetSymbols(expr: Expr): TemplateResult {
  return set(expr, SYMBOLS).m;
}

/** The same in pieces between which a line may be broken: the terms of a sum, the two sides of a dot product. */
export function typesetNumbersInPieces(
  expr: Expr,
  values: Values<number>,
  digits: number,
): TemplateResult[] {
  const leaves = numbers(values, { worked: false, digits });
  if (expr.op === 'sum') return terms(expr, leaves);
  if (expr.op !== 'dot') return [set(expr, leaves).m];
  return [leaves.vector(expr.left).m, mathml`<mo>·</mo>${leaves.vector(expr.right).m}`];
}

/** The formula with the numbers put in, `digits` significant ones each. */
export function typesetNumbers(
  expr: Expr,
  values: Values<number>,
  options: { readonly worked: boolean; readonly digits: number },
): TemplateResult {
  return set(expr, numbers(values, options)).m;
}

export function typesetRelation({ left, relation, right }: Relation): TemplateResult {
  return mathml`${typesetSymbols(left)}<mo>${relation}</mo>${typesetSymbols(right)}`;
}

/** A number as MathML: true minus as an operator, powers of ten raised. */
export function typesetNumber(x: number, digits = 6): TemplateResult {
  return numberPiece(x, digits).m;
}

function set(expr: Expr, leaves: Leaves): Piece {
  const whole = leaves.whole(expr);
  if (whole) return whole;
  switch (expr.op) {
    case 'number':
      return numberPiece(expr.value, 6);
    case 'scalar':
      return leaves.scalar(expr.id);
    case 'component':
      return leaves.component(expr.vector, expr.axis);
    case 'sum':
      return sum(expr, leaves);
    case 'product':
      return product(expr.factors, leaves);
    case 'quotient':
      return piece(
        mathml`<mfrac><mrow>${set(expr.over, leaves).m}</mrow><mrow>${set(expr.under, leaves).m}</mrow></mfrac>`,
        4,
      );
    case 'negative':
      return piece(mathml`<mo form="prefix">−</mo>${atLeast(set(expr.of, leaves), 2)}`, 2, 'minus');
    case 'square':
      return square(expr.of, leaves);
    case 'root':
      return piece(mathml`<msqrt>${set(expr.of, leaves).m}</msqrt>`, 4);
    case 'plus-minus':
      return piece(
        mathml`${set(expr.left, leaves).m}<mo>±</mo>${atLeast(set(expr.right, leaves), 2)}`,
        1,
      );
    case 'dot':
      return piece(
        mathml`${leaves.vector(expr.left).m}<mo>·</mo>${atLeast(leaves.vector(expr.right), 2)}`,
        2,
      );
    case 'norm':
      return piece(
        mathml`<mo form="prefix" stretchy="false">|</mo>${leaves.vector(expr.of).m}<mo form="postfix" stretchy="false">|</mo>`,
        4,
      );
  }
}

const parens = (m: TemplateResult): TemplateResult =>
  mathml`<mrow><mo stretchy="false">(</mo>${m}<mo stretchy="false">)</mo></mrow>`;

/** In parentheses, unless it holds together at least this tightly. */
function atLeast({ m, rank }: Piece, least: number): TemplateResult {
  return rank >= least ? m : parens(m);
}

type Sum = Extract<Expr, { op: 'sum' }>;

function sum(expr: Sum, leaves: Leaves): Piece {
  return piece(mathml`${terms(expr, leaves)}`, 1);
}

function terms(expr: Sum, leaves: Leaves): TemplateResult[] {
  return expr.terms.map(({ sign, expr: term }, i) => {
    const p = set(term, leaves);
    if (i === 0) return sign === 1 ? p.m : mathml`<mo form="prefix">−</mo>${atLeast(p, 2)}`;
    // A term that begins with a minus sign of its own is told apart from the sum's.
    const inner = p.starts === 'minus' ? parens(p.m) : atLeast(p, 2);
    return mathml`<mo form="infix">${sign === 1 ? '+' : '−'}</mo>${inner}`;
  });
}

function product(factors: readonly Expr[], leaves: Leaves): Piece {
  const pieces = factors.map((factor) => set(factor, leaves));
  const parts = pieces.map((p, i) => {
    // N·d t would read as N·(d t).
    const loose = p.rank < 2 || factors[i]?.op === 'dot';
    const bare = p.rank >= 3 || (i === 0 && !loose);
    const dot = i > 0 && bare && p.starts === 'numeral';
    return mathml`${dot ? mathml`<mo>·</mo>` : nothing}${bare ? p.m : parens(p.m)}`;
  });
  return piece(mathml`${parts}`, 2, pieces[0]?.starts);
}

function square(of: Expr, leaves: Leaves): Piece {
  const base = set(of, leaves);
  if (of.op === 'component' && base.rank === 4 && base.starts !== 'numeral') {
    const symbol = highlightOf(of.vector, 'vector');
    return piece(
      mathml`<msubsup class=${classOf(of.vector, 'vector')} data-symbol=${symbol}><mi>${of.vector}</mi><mi>${of.axis}</mi><mn>2</mn></msubsup>`,
      3,
    );
  }
  const inner = base.rank >= 4 ? mathml`<mrow>${base.m}</mrow>` : parens(base.m);
  return piece(mathml`<msup>${inner}<mn>2</mn></msup>`, 3, base.rank >= 4 ? base.starts : 'other');
}

const SYMBOLS: Leaves = {
  scalar: (id) =>
    piece(
      mathml`<mi class=${classOf(id, 'scalar')} data-symbol=${highlightOf(id, 'scalar')}>${id}</mi>`,
      4,
    ),
  component: (vector, axis) =>
    piece(
      mathml`<msub class=${classOf(vector, 'vector')} data-symbol=${highlightOf(vector, 'vector')}><mi>${vector}</mi><mi>${axis}</mi></msub>`,
      4,
    ),
  vector(expr): Piece {
    if (expr.op === 'vector') {
      return piece(
        mathml`<mi class=${classOf(expr.id, 'vector')} data-symbol=${highlightOf(expr.id, 'vector')}>${expr.id}</mi>`,
        4,
      );
    }
    return piece(
      mathml`${SYMBOLS.vector(expr.left).m}<mo>−</mo>${SYMBOLS.vector(expr.right).m}`,
      1,
    );
  },
  whole: () => null,
};

function numbers(
  values: Values<number>,
  { worked, digits }: { readonly worked: boolean; readonly digits: number },
): Leaves {
  const numeric = (x: number, cls: string, symbol: string): Piece => {
    const { m, rank, starts } = numberPiece(x, digits);
    return piece(mathml`<mrow class=${cls} data-symbol=${symbol}>${m}</mrow>`, rank, starts);
  };
  const leaves: Leaves = {
    scalar: (id) =>
      numeric(values.scalars[id] ?? Number.NaN, classOf(id, 'scalar'), highlightOf(id, 'scalar')),
    component: (vector, axis) =>
      numeric(
        values.vectors[vector]?.[axisIndex(axis)] ?? Number.NaN,
        classOf(vector, 'vector'),
        highlightOf(vector, 'vector'),
      ),
    vector: (expr) => piece(parens(triple(expr, leaves)), 4),
    whole: (expr) =>
      worked && isWorked(expr) ? numberPiece(evaluate(expr, float64, values), digits) : null,
  };
  return leaves;
}

/** (3 − 0, 1 − 1, 1 − 0) */
function triple(expr: VectorExpr, leaves: Leaves): TemplateResult {
  const along = (e: VectorExpr, axis: Axis): TemplateResult => {
    if (e.op === 'vector') return leaves.component(e.id, axis).m;
    const right = e.right.op === 'vector' ? leaves.component(e.right.id, axis) : null;
    const inner = right ? atLeast(right, 3) : parens(along(e.right, axis));
    return mathml`${along(e.left, axis)}<mo>−</mo>${inner}`;
  };
  const parts = AXES.map(
    (axis, i) => mathml`${i > 0 ? mathml`<mo>,</mo>` : nothing}${along(expr, axis)}`,
  );
  return mathml`${parts}`;
}

/** −B, √D, 2A and N·d: in the last line they stand as the numbers that were just found. */
function isWorked({ op }: Expr): boolean {
  return op === 'negative' || op === 'root' || op === 'product' || op === 'dot';
}

function numberPiece(x: number, digits: number): Piece {
  const { mantissa, exponent } = displayParts(x, digits);
  const negative = mantissa.startsWith('−');
  const figures = negative ? mantissa.slice(1) : mantissa;
  const minus = negative ? mathml`<mo form="prefix">−</mo>` : nothing;
  const power =
    exponent === null
      ? nothing
      : mathml`<mo>·</mo><msup><mn>10</mn>${typesetNumber(exponent)}</msup>`;
  const m = mathml`${minus}<mn>${figures}</mn>${power}`;
  return piece(
    mathml`<mrow>${m}</mrow>`,
    negative || exponent !== null ? 2 : 4,
    negative ? 'minus' : 'numeral',
  );
}
