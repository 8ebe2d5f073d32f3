import { type Axis, axisIndex } from '../vec3.ts';
import { POINT } from './common.ts';
import { dotAlongAxes } from './derivative.ts';
import {
  type Expr,
  negative,
  num,
  over,
  type Relation,
  scalar,
  squared,
  type Term,
  times,
} from './expr.ts';

/*
 * The small exact algebra of a derivation: put in, expand, collect. It makes new trees and changes
 * none. What holds no t stays together: (Ex − Vx) is one factor.
 */

/** One product of an expanded sum: sign · count · factors · t^power. */
export interface Product {
  readonly sign: 1 | -1;
  /** A whole number, 1 or more. */
  readonly count: number;
  readonly factors: readonly Expr[];
  /** Of t. */
  readonly power: number;
  /** Which of the terms of the sum it comes from, from 0. */
  readonly from: number;
}

/** The surface's equation as one sum that is zero on it: left − right. */
export function asZero({ left, right }: Relation): Expr {
  return { op: 'sum', terms: [...termsOf(left, 1), ...termsOf(right, -1)] };
}

/** The terms of a sum, or the tree itself; zeros are left out. */
function termsOf(expr: Expr, sign: 1 | -1): Term[] {
  if (expr.op === 'number' && expr.value === 0) return [];
  if (expr.op === 'negative') return termsOf(expr.of, sign === 1 ? -1 : 1);
  if (expr.op !== 'sum') return [{ sign, expr }];
  return expr.terms.flatMap((term) => termsOf(term.expr, term.sign === sign ? 1 : -1));
}

/** x, y, z replaced by Ex + t dx, …, and the vector X by E + t d along its axes. */
export function rayPutIn(expr: Expr): Expr {
  switch (expr.op) {
    case 'scalar':
      return /^[xyz]$/.test(expr.id) ? POINT[axisIndex(expr.id as Axis)] : expr;
    case 'component':
      return expr.vector === 'X' ? POINT[axisIndex(expr.axis)] : expr;
    case 'sum':
      return tLast(expr.terms.flatMap(({ sign, expr: term }) => termsOf(rayPutIn(term), sign)));
    case 'product':
      return times(...expr.factors.map(rayPutIn));
    case 'quotient':
      return over(rayPutIn(expr.over), rayPutIn(expr.under));
    case 'negative':
      return negative(rayPutIn(expr.of));
    case 'square':
      return squared(rayPutIn(expr.of));
    case 'dot':
      return rayPutIn(dotAlongAxes(expr.left, expr.right));
    case 'number':
      return expr;
    default:
      throw new RangeError(`no polynomial: ${expr.op}`);
  }
}

/** Ex − Vx + t dx: what holds no t first. */
function tLast(terms: readonly Term[]): Expr {
  const free = terms.filter(({ expr }) => !holdsT(expr));
  return { op: 'sum', terms: [...free, ...terms.filter(({ expr }) => holdsT(expr))] };
}

function holdsT(expr: Expr): boolean {
  return holds(expr, (leaf) => leaf.op === 'scalar' && leaf.id === 't');
}

function holds(expr: Expr, is: (leaf: Expr) => boolean): boolean {
  switch (expr.op) {
    case 'sum':
      return expr.terms.some((term) => holds(term.expr, is));
    case 'product':
      return expr.factors.some((factor) => holds(factor, is));
    case 'quotient':
      return holds(expr.over, is) || holds(expr.under, is);
    case 'negative':
    case 'square':
      return holds(expr.of, is);
    default:
      return is(expr);
  }
}

/**
 * A polynomial in t as a sum of products, each term of the outermost sum for itself and in its
 * order. Throws RangeError for what is no polynomial in t.
 */
export function expanded(expr: Expr): Product[] {
  return termsOf(expr, 1).flatMap(({ sign, expr: term }, from) =>
    products(term, from).map((p) => ({ ...p, sign: p.sign === sign ? 1 : -1 })),
  );
}

function products(expr: Expr, from: number): Product[] {
  const one = { sign: 1, count: 1, factors: [], power: 0, from } as const;
  if (!holdsT(expr)) return freeOfT(expr, one);
  switch (expr.op) {
    case 'scalar':
      return [{ ...one, power: 1 }];
    case 'negative':
      return products(expr.of, from).map((p) => ({ ...p, sign: p.sign === 1 ? -1 : 1 }));
    case 'sum':
      return inPowers(expr.terms).flatMap(({ sign, expr: term }) =>
        products(term, from).map((p) => ({ ...p, sign: p.sign === sign ? 1 : -1 })),
      );
    case 'product':
      return expr.factors
        .map((factor) => products(factor, from))
        .reduce((a, b) => a.flatMap((p) => b.map((q) => multiplied(p, q))));
    case 'square':
      return squareOf(products(expr.of, from));
    default:
      throw new RangeError(`no polynomial in t: ${expr.op}`);
  }
}

/** One term for all that holds no t, and behind it those that do. */
function inPowers(terms: readonly Term[]): readonly Term[] {
  const free = terms.filter(({ expr }) => !holdsT(expr));
  if (free.length < 2) return terms;
  const rest = terms.filter(({ expr }) => holdsT(expr));
  return [{ sign: 1, expr: { op: 'sum', terms: free } }, ...rest];
}

/** A product's numbers go into its count; what else is not a product stays one factor. */
function freeOfT(expr: Expr, one: Product): Product[] {
  if (expr.op === 'number' && Number.isInteger(expr.value) && expr.value > 0) {
    return [{ ...one, count: expr.value }];
  }
  if (expr.op === 'product') {
    return [expr.factors.map((f) => freeOfT(f, one)[0] as Product).reduce(multiplied)];
  }
  return [{ ...one, factors: [expr] }];
}

const multiplied = (p: Product, q: Product): Product => ({
  sign: p.sign === q.sign ? 1 : -1,
  count: p.count * q.count,
  factors: [...p.factors, ...q.factors],
  power: p.power + q.power,
  from: p.from,
});

/** (a + b)² = a² + 2ab + b², and so on for more terms; the highest power of t first. */
function squareOf(parts: readonly Product[]): Product[] {
  const all = parts.flatMap((p, i) => [
    { ...multiplied(p, p), factors: p.factors.map(squared) },
    ...parts.slice(i + 1).map((q) => {
      const both = multiplied(q, p);
      return { ...both, count: 2 * both.count };
    }),
  ]);
  return all.sort((p, q) => q.power - p.power);
}

/** What stands beside t^power in a sum of products; 0 where nothing does. */
export function collected(all: readonly Product[], power: number): Expr {
  const own = all.filter((p) => p.power === power);
  if (own.length === 0) return num(0);
  const [only] = own;
  if (own.length === 1 && only?.sign === 1) return withoutT(only);
  return { op: 'sum', terms: own.map((p) => ({ sign: p.sign, expr: withoutT(p) })) };
}

/** The product without its sign and its power of t. */
function withoutT({ count, factors }: Product): Expr {
  const all = count === 1 && factors.length > 0 ? factors : [num(count), ...factors];
  return all.length === 1 ? (all[0] as Expr) : times(...all);
}

/** The whole sum of products, written out. */
export function writtenOut(all: readonly Product[]): Expr {
  const t = scalar('t');
  const inT = ({ power }: Product): Expr[] => (power === 0 ? [] : power === 1 ? [t] : [squared(t)]);
  return {
    op: 'sum',
    terms: all.map((p) => {
      const own = withoutT(p);
      const factors = own.op === 'product' ? own.factors : [own];
      return { sign: p.sign, expr: p.power === 0 ? own : times(...inT(p), ...factors) };
    }),
  };
}
