import type { Expr, Term } from '../math/formula.ts';

/** A sum with one more term; nested sums become one, since they are evaluated from the left. */
export function sumOf(left: Expr, term: Term): Expr {
  const terms = left.op === 'sum' ? left.terms : [{ sign: 1 as const, expr: left }];
  return { op: 'sum', terms: [...terms, term] };
}

export function productOf(left: Expr, right: Expr): Expr {
  const factors = left.op === 'product' ? left.factors : [left];
  return { op: 'product', factors: [...factors, right] };
}

/** Equal for trees that are written alike. */
export const keyOf = (expr: Expr): string => JSON.stringify(expr);
