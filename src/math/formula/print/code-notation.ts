import { AXES, type Axis } from '../../vec3.ts';
import { type Expr, plus, root, squared, times, type VectorExpr } from '../expr.ts';
import { along } from './leaves.ts';
import { type Notation, print } from './printer.ts';

/** How a programming language writes the leaves and functions of a formula. */
export interface CodeSyntax {
  number(x: number): string;
  component(vector: string, axis: Axis): string;
  sqrt(of: string): string;
  /** Null where dot products and lengths are written out by components. */
  readonly vectors: VectorSyntax | null;
}

interface VectorSyntax {
  dot(left: string, right: string): string;
  norm(of: string): string;
}

/** Names of symbols in the program: the centre C and the coefficient C cannot both be C there. */
export interface Names {
  scalar(id: string): string;
  vector(id: string): string;
}

interface CodeOptions {
  /** The sign taken at ±. */
  readonly branch?: 1 | -1;
  /** Names of subtrees that the program has computed before. */
  readonly known?: ReadonlyMap<Expr, string>;
}

interface Code {
  readonly text: string;
  readonly rank: Rank;
}

type Rank = (typeof RANK)[keyof typeof RANK];
const RANK = { sum: 1, product: 2, minus: 3, single: 4 } as const;

/**
 * The tree as an expression of a programming language that does every operation in the order of the
 * tree, so that in doubles the program has the tree's float64 value to the last bit. A square is x
 * * x: a power function may round otherwise.
 *
 * @param expr the tree.
 * @param syntax TYPESCRIPT, PYTHON, GLSL or another.
 * @param names what symbols are called in the program.
 * @param options `branch`: the sign taken at ±, + unless told otherwise; `known`: subtrees that
 *   have a name there already.
 * @throws RangeError where the language has no literal for a number.
 * @example
 * const names = { scalar: (id: string) => id.toLowerCase(), vector: (id: string) => id };
 * printCode(ROOTS, TYPESCRIPT, names, { branch: -1 }); // → '(-b - Math.sqrt(d)) / (2 * a)'
 */
export function printCode(
  expr: Expr,
  syntax: CodeSyntax,
  names: Names,
  options: CodeOptions = {},
): string {
  return print(expr, codeNotation(syntax, names, options)).text;
}

function codeNotation(syntax: CodeSyntax, names: Names, options: CodeOptions): Notation<Code> {
  const { branch = 1, known } = options;
  const single = (text: string): Code => ({ text, rank: RANK.single });
  const writtenOut = (expr: Expr): Code => print(expr, notation);
  const notation: Notation<Code> = {
    number: (x) => signedNumber(syntax.number(x)),
    scalar: (id) => single(names.scalar(id)),
    component: (id, axis) => single(syntax.component(names.vector(id), axis)),
    sum: (terms) => ({
      text: terms.map(({ sign, of }, i) => term(of, sign, i)).join(''),
      rank: RANK.sum,
    }),
    product,
    quotient: (over, under) => ({
      text: `${atLeast(over, RANK.product)} / ${atLeast(under, RANK.minus)}`,
      rank: RANK.product,
    }),
    negative: (of) => ({ text: `-${atLeast(of, RANK.single)}`, rank: RANK.minus }),
    square: (of) => product([of, of]),
    root: (of) => single(syntax.sqrt(of.text)),
    plusMinus: (left, right) => ({
      text: left.text + term(right, branch, 1),
      rank: RANK.sum,
    }),
    dot: (left, right) =>
      syntax.vectors
        ? single(syntax.vectors.dot(vectorCode(left, names), vectorCode(right, names)))
        : writtenOut(dotByComponents(left, right)),
    norm: (of) =>
      syntax.vectors
        ? single(syntax.vectors.norm(vectorCode(of, names)))
        : writtenOut(normByComponents(of)),
    whole: (expr) => {
      const name = known?.get(expr);
      return name === undefined ? null : single(name);
    },
  };
  return notation;
}

function atLeast({ text, rank }: Code, least: Rank): string {
  return rank >= least ? text : `(${text})`;
}

/**
 * Languages read sums and products from the left, as the tree does; the first operand of a kind
 * needs no parentheses.
 */
function term(of: Code, sign: 1 | -1, i: number): string {
  if (i > 0) return ` ${sign === 1 ? '+' : '-'} ${atLeast(of, RANK.product)}`;
  return sign === 1 ? of.text : `-${atLeast(of, RANK.single)}`;
}

function product(factors: readonly Code[]): Code {
  const text = factors.map((f, i) => atLeast(f, i === 0 ? RANK.product : RANK.minus)).join(' * ');
  return { text, rank: RANK.product };
}

function signedNumber(text: string): Code {
  return { text, rank: text.startsWith('-') ? RANK.minus : RANK.single };
}

function vectorCode(expr: VectorExpr, names: Names): string {
  if (expr.op === 'vector') return names.vector(expr.id);
  if (expr.op === 'moved') {
    const [from, step] = [expr.from, expr.step].map((e) => vectorCode(e, names));
    return `${from} + ${names.scalar(expr.by)} * ${step}`;
  }
  const right = vectorCode(expr.right, names);
  return `${vectorCode(expr.left, names)} - ${expr.right.op === 'vector' ? right : `(${right})`}`;
}

function dotByComponents(left: VectorExpr, right: VectorExpr): Expr {
  return plus(...AXES.map((axis) => times(along(left, axis), along(right, axis))));
}

function normByComponents(of: VectorExpr): Expr {
  return root(plus(...AXES.map((axis) => squared(along(of, axis)))));
}
