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

export interface Term {
  readonly sign: 1 | -1;
  readonly expr: Expr;
}

export type VectorExpr =
  | { readonly op: 'vector'; readonly id: string }
  | { readonly op: 'difference'; readonly left: VectorExpr; readonly right: VectorExpr };

/** left = right, or left ≤ right. */
export interface Relation {
  readonly left: Expr;
  readonly relation: '=' | '≤';
  readonly right: Expr;
}

export type ExprTriple = readonly [Expr, Expr, Expr];

export const num = (value: number): Expr => ({ op: 'number', value });
export const scalar = (id: string): Expr => ({ op: 'scalar', id });
export const comp = (vector: string, axis: Axis): Expr => ({ op: 'component', vector, axis });
export const plus = (...terms: Expr[]): Expr => ({
  op: 'sum',
  terms: terms.map((expr) => ({ sign: 1, expr })),
});
/** first − second − … */
export const minus = (first: Expr, ...rest: Expr[]): Expr => ({
  op: 'sum',
  terms: [{ sign: 1, expr: first }, ...rest.map((expr): Term => ({ sign: -1, expr }))],
});
export const signedSum = (...terms: readonly (readonly [1 | -1, Expr])[]): Expr => ({
  op: 'sum',
  terms: terms.map(([sign, expr]) => ({ sign, expr })),
});
export const times = (...factors: Expr[]): Expr => ({ op: 'product', factors });
export const over = (top: Expr, under: Expr): Expr => ({ op: 'quotient', over: top, under });
export const negative = (of: Expr): Expr => ({ op: 'negative', of });
export const squared = (of: Expr): Expr => ({ op: 'square', of });
export const root = (of: Expr): Expr => ({ op: 'root', of });
/** One tree for both roots: which sign is taken is said when it is evaluated. */
export const plusMinus = (left: Expr, right: Expr): Expr => ({ op: 'plus-minus', left, right });
export const vec = (id: string): VectorExpr => ({ op: 'vector', id });
export const vecMinus = (left: VectorExpr, right: VectorExpr): VectorExpr => ({
  op: 'difference',
  left,
  right,
});
export const dot = (left: VectorExpr, right: VectorExpr): Expr => ({ op: 'dot', left, right });
export const norm = (of: VectorExpr): Expr => ({ op: 'norm', of });
