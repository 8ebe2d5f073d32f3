import { AXES, type Axis } from '../vec3.ts';
import { type Expr, negative, num, over, plus, times, type VectorExpr } from './expr.ts';
import { along } from './print/leaves.ts';

/** A dot product as the sum that it is: Nx(Ex − Px) + Ny(Ey − Py) + Nz(Ez − Pz). */
const dotAlongAxes = (left: VectorExpr, right: VectorExpr): Expr =>
  plus(...AXES.map((axis) => times(along(left, axis), along(right, axis))));

/**
 * The derivative of a polynomial by x, y or z; null where it is zero. The components of the vector
 * X are x, y and z.
 */
export function derivative(expr: Expr, by: Axis): Expr | null {
  switch (expr.op) {
    case 'scalar':
      return expr.id === by ? num(1) : null;
    case 'component':
      return expr.vector === 'X' && expr.axis === by ? num(1) : null;
    case 'negative': {
      const inner = derivative(expr.of, by);
      return inner && negative(inner);
    }
    case 'sum': {
      const terms = expr.terms.flatMap(({ sign, expr: term }) => {
        const inner = derivative(term, by);
        return inner ? [{ sign, expr: inner }] : [];
      });
      const [only] = terms;
      if (!only) return null;
      return terms.length === 1 && only.sign === 1 ? only.expr : { op: 'sum', terms };
    }
    case 'square': {
      const inner = derivative(expr.of, by);
      return inner && product(num(2), expr.of, inner);
    }
    case 'product':
      return productRule(expr.factors, by);
    case 'dot':
      return derivative(dotAlongAxes(expr.left, expr.right), by);
    default:
      return null;
  }
}

function productRule(factors: readonly Expr[], by: Axis): Expr | null {
  const terms = factors.flatMap((factor, i) => {
    const inner = derivative(factor, by);
    return inner ? [product(...factors.slice(0, i), inner, ...factors.slice(i + 1))] : [];
  });
  if (terms.length === 0) return null;
  return terms.length === 1 ? (terms[0] as Expr) : plus(...terms);
}

/** A product without factors of 1, with one number in front, and with nested products joined. */
function product(...factors: readonly Expr[]): Expr {
  const flat = factors.flatMap((f) => (f.op === 'product' ? f.factors : [f]));
  const count = flat.reduce((n, f) => (f.op === 'number' ? n * f.value : n), 1);
  const rest = flat.filter((f) => f.op !== 'number');
  const all = count === 1 && rest.length > 0 ? rest : [num(count), ...rest];
  return all.length === 1 ? (all[0] as Expr) : times(...all);
}

/** Half of a tree: its even number is halved; without one the tree is divided by 2. */
export function halved(expr: Expr): Expr {
  if (expr.op === 'negative') return negative(halved(expr.of));
  if (expr.op === 'sum') {
    return {
      op: 'sum',
      terms: expr.terms.map(({ sign, expr: term }) => ({ sign, expr: halved(term) })),
    };
  }
  const first = expr.op === 'product' ? expr.factors[0] : undefined;
  const isEven = first?.op === 'number' && first.value % 2 === 0;
  return isEven ? product(num(0.5), expr) : over(expr, num(2));
}
