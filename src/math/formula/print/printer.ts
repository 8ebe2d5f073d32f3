import type { Axis } from '../../vec3.ts';
import type { Expr, VectorExpr } from '../expr.ts';

/**
 * How each operation is written, its operands being written already. P is what a written operand is
 * known by: its text, and how tightly it holds together.
 */
export interface Notation<P> {
  number(value: number): P;
  scalar(id: string): P;
  component(vector: string, axis: Axis): P;
  sum(terms: readonly WrittenTerm<P>[]): P;
  product(factors: readonly P[]): P;
  quotient(over: P, under: P): P;
  negative(of: P): P;
  square(of: P): P;
  root(of: P): P;
  plusMinus(left: P, right: P): P;
  dot(left: VectorExpr, right: VectorExpr): P;
  norm(of: VectorExpr): P;
  /**
   * A subtree that is written in a way of its own (by a name, by its value), or null to go on into
   * it.
   */
  whole(expr: Expr): P | null;
}

/** A part of a sum that is written already. */
export interface WrittenTerm<P> {
  readonly sign: 1 | -1;
  readonly of: P;
}

/**
 * The tree, written from the leaves upwards.
 *
 * @param expr the tree.
 * @param notation how each operation is written, its operands being written already.
 * @example
 * print(num(2), { number: String, whole: () => null } as never); // → '2'
 */
export function print<P>(expr: Expr, notation: Notation<P>): P {
  const whole = notation.whole(expr);
  if (whole !== null) return whole;
  const of = (e: Expr): P => print(e, notation);
  switch (expr.op) {
    case 'number':
      return notation.number(expr.value);
    case 'scalar':
      return notation.scalar(expr.id);
    case 'component':
      return notation.component(expr.vector, expr.axis);
    case 'sum':
      return notation.sum(expr.terms.map((term) => ({ sign: term.sign, of: of(term.expr) })));
    case 'product':
      return notation.product(expr.factors.map(of));
    case 'quotient':
      return notation.quotient(of(expr.over), of(expr.under));
    case 'negative':
      return notation.negative(of(expr.of));
    case 'square':
      return notation.square(of(expr.of));
    case 'root':
      return notation.root(of(expr.of));
    case 'plus-minus':
      return notation.plusMinus(of(expr.left), of(expr.right));
    case 'dot':
      return notation.dot(expr.left, expr.right);
    case 'norm':
      return notation.norm(expr.of);
  }
}
