import type { Expr, Relation, Term } from '../math/formula.ts';

/** The replacement of a subtree, or null to keep it and look at its parts. */
type Edit = (expr: Expr) => Expr | null;

/** The tree with subtrees replaced by the edit, outermost first. The same object if none was. */
export function rewrite(expr: Expr, edit: Edit): Expr {
  const replaced = edit(expr);
  if (replaced) return replaced;
  const of = (e: Expr): Expr => rewrite(e, edit);
  switch (expr.op) {
    case 'sum': {
      const terms = expr.terms.map((term): Term => ({ sign: term.sign, expr: of(term.expr) }));
      return terms.some((term, i) => term.expr !== expr.terms[i]?.expr) ? { ...expr, terms } : expr;
    }
    case 'product': {
      const factors = expr.factors.map(of);
      return factors.some((factor, i) => factor !== expr.factors[i]) ? { ...expr, factors } : expr;
    }
    case 'quotient': {
      const [over, under] = [of(expr.over), of(expr.under)];
      return over === expr.over && under === expr.under ? expr : { ...expr, over, under };
    }
    case 'negative':
    case 'square':
    case 'root': {
      const inner = of(expr.of);
      return inner === expr.of ? expr : { ...expr, of: inner };
    }
    case 'plus-minus': {
      const [left, right] = [of(expr.left), of(expr.right)];
      return left === expr.left && right === expr.right ? expr : { ...expr, left, right };
    }
    default:
      return expr;
  }
}

/** A relation with both sides rewritten. */
export function rewriteRelation(relation: Relation, edit: Edit): Relation {
  const left = rewrite(relation.left, edit);
  const right = rewrite(relation.right, edit);
  return left === relation.left && right === relation.right
    ? relation
    : { ...relation, left, right };
}

/** Whether a subtree satisfies `wanted`. */
export function occurs(expr: Expr, wanted: (e: Expr) => boolean): boolean {
  return rewrite(expr, (e) => (wanted(e) ? { op: 'number', value: Number.NaN } : null)) !== expr;
}

export const isScalar = (expr: Expr, id: string): boolean => expr.op === 'scalar' && expr.id === id;

export const isNumber = (expr: Expr | undefined, value: number): boolean =>
  expr?.op === 'number' && expr.value === value;

/** Whether a vector's component along this axis occurs. */
export const mentionsAxis = (expr: Expr, axis: string): boolean =>
  occurs(expr, (e) => e.op === 'component' && e.axis === axis);
