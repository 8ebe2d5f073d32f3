import type { Axis } from '../vec3.ts';

/**
 * A formula as a small tree, in the course's symbols. It is a notation, not a computer algebra
 * system: a tree is never rewritten, and it is evaluated in the order in which it is written (sums
 * and products from the left), so that its float64 value is the value that a student's program
 * gets.
 */
export type Expr =
  | { readonly op: 'number'; readonly value: number }
  | { readonly op: 'scalar'; readonly id: string }
  | { readonly op: 'component'; readonly vector: string; readonly axis: Axis }
  | { readonly op: 'sum'; readonly terms: readonly Term[] }
  | { readonly op: 'product'; readonly factors: readonly Expr[] }
  | { readonly op: 'quotient'; readonly over: Expr; readonly under: Expr }
  | { readonly op: 'negative'; readonly of: Expr }
  | { readonly op: 'square'; readonly of: Expr }
  | { readonly op: 'root'; readonly of: Expr }
  | { readonly op: 'plus-minus'; readonly left: Expr; readonly right: Expr }
  | { readonly op: 'dot'; readonly left: VectorExpr; readonly right: VectorExpr }
  | { readonly op: 'norm'; readonly of: VectorExpr };

/** A part of a sum, and whether it is added or subtracted. */
export interface Term {
  readonly sign: 1 | -1;
  readonly expr: Expr;
}

/** A vector by its symbol, or the difference of two: what dot products and lengths are made of. */
export type VectorExpr =
  | { readonly op: 'vector'; readonly id: string }
  | { readonly op: 'difference'; readonly left: VectorExpr; readonly right: VectorExpr }
  /** from + by · step, by the name of a scalar: E + t d. */
  | {
      readonly op: 'moved';
      readonly from: VectorExpr;
      readonly by: string;
      readonly step: VectorExpr;
    };

/** left = right, or left ≤ right. */
export interface Relation {
  readonly left: Expr;
  readonly relation: '=' | '≤';
  readonly right: Expr;
}

/** A tree for each component. */
export type ExprTriple = readonly [Expr, Expr, Expr];

/**
 * A number of the formula itself, as the 4 of 4AC.
 *
 * @param value any double, of any unit; in another arithmetic it is taken over by `of`.
 * @example
 * evaluate(num(4), float64, { scalars: {}, vectors: {} }); // → 4
 */
export const num = (value: number): Expr => ({ op: 'number', value });

/**
 * A number by its symbol.
 *
 * @param id the course's letter: A, r, t.
 * @example
 * evaluate(scalar('r'), float64, { scalars: { r: 2 }, vectors: {} }); // → 2
 */
export const scalar = (id: string): Expr => ({ op: 'scalar', id });

/**
 * A component of a vector.
 *
 * @param vector the vector's letter: E, d, C.
 * @param axis which of its components.
 * @example
 * evaluate(comp('E', 'y'), float64, { scalars: {}, vectors: { E: [4, 1, 0] } }); // → 1
 */
export const comp = (vector: string, axis: Axis): Expr => ({ op: 'component', vector, axis });

/**
 * A sum, added from the left.
 *
 * @param terms at least one, of the same unit.
 * @example
 * inSymbols(plus(scalar('a'), scalar('b')), LATEX); // → 'a + b'
 */
export const plus = (...terms: Expr[]): Expr => ({
  op: 'sum',
  terms: terms.map((expr) => ({ sign: 1, expr })),
});

/**
 * first − second − …, from the left.
 *
 * @param first what the others are taken from; all have the same unit.
 * @param rest what is taken from it, one after the other.
 * @example
 * inSymbols(minus(scalar('a'), scalar('b')), LATEX); // → 'a - b'
 */
export const minus = (first: Expr, ...rest: Expr[]): Expr => ({
  op: 'sum',
  terms: [{ sign: 1, expr: first }, ...rest.map((expr): Term => ({ sign: -1, expr }))],
});
export const signedSum = (...terms: readonly (readonly [1 | -1, Expr])[]): Expr => ({
  op: 'sum',
  terms: terms.map(([sign, expr]) => ({ sign, expr })),
});

/**
 * A product, multiplied from the left.
 *
 * @param factors at least one.
 * @example
 * inSymbols(times(num(2), scalar('A')), LATEX); // → '2A'
 */
export const times = (...factors: Expr[]): Expr => ({ op: 'product', factors });

/**
 * A quotient.
 *
 * @param top what is divided.
 * @param under what it is divided by; a value of 0 is the arithmetic's affair.
 * @example
 * inSymbols(over(scalar('C'), scalar('B')), LATEX); // → '\\frac{C}{B}'
 */
export const over = (top: Expr, under: Expr): Expr => ({ op: 'quotient', over: top, under });

/**
 * The opposite.
 *
 * @param of any tree.
 * @example
 * inSymbols(negative(scalar('B')), LATEX); // → '-B'
 */
export const negative = (of: Expr): Expr => ({ op: 'negative', of });

/**
 * A square, x · x.
 *
 * @param of any tree.
 * @example
 * inSymbols(squared(scalar('B')), LATEX); // → 'B^{2}'
 */
export const squared = (of: Expr): Expr => ({ op: 'square', of });

/**
 * A square root.
 *
 * @param of any tree; what its value is below 0 is the arithmetic's affair.
 * @example
 * inSymbols(root(scalar('D')), LATEX); // → '\\sqrt{D}'
 */
export const root = (of: Expr): Expr => ({ op: 'root', of });

/**
 * One tree for both roots: which sign is taken is said when it is evaluated.
 *
 * @param left what stands before the ±.
 * @param right what stands behind it, of the same unit.
 * @example
 * const both = plusMinus(num(3), num(2));
 * const none = { scalars: {}, vectors: {} };
 * [evaluate(both, float64, none, -1), evaluate(both, float64, none, 1)]; // → [1, 5]
 */
export const plusMinus = (left: Expr, right: Expr): Expr => ({ op: 'plus-minus', left, right });

/**
 * A vector by its symbol.
 *
 * @param id the vector's letter.
 * @example
 * inSymbols(norm(vec('d')), LATEX); // → '\\lvert d \\rvert'
 */
export const vec = (id: string): VectorExpr => ({ op: 'vector', id });

/**
 * A difference of vectors.
 *
 * @param left and `right` have the same unit.
 * @example
 * inSymbols(norm(vecMinus(vec('X'), vec('C'))), LATEX); // → '\\lvert X - C \\rvert'
 */
export const vecMinus = (left: VectorExpr, right: VectorExpr): VectorExpr => ({
  op: 'difference',
  left,
  right,
});
export const dot = (left: VectorExpr, right: VectorExpr): Expr => ({ op: 'dot', left, right });

/**
 * The length of a vector, in its unit.
 *
 * @param of the vector.
 * @example
 * evaluate(norm(vec('d')), float64, { scalars: {}, vectors: { d: [3, 0, 4] } }); // → 5
 */
export const norm = (of: VectorExpr): Expr => ({ op: 'norm', of });
