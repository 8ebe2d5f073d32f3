import { type Axis, axisIndex } from '../vec3.ts';
import { POINT } from './common.ts';
import {
  dot,
  type Expr,
  negative,
  num,
  over,
  type Relation,
  scalar,
  squared,
  type Term,
  times,
  type VectorExpr,
  vecMinus,
} from './expr.ts';

/*
 * The algebra of a derivation: the ray is substituted into a surface's equation, which is then
 * expanded and collected by powers of t. Trees are never changed: each step makes new ones. A term
 * without t stays one factor, as (Ex − Vx).
 */

/** One product of an expanded sum: sign · count · factors · t^power. */
export interface Product {
  readonly sign: 1 | -1;
  /** A whole number, 1 or more. */
  readonly count: number;
  readonly factors: readonly Expr[];
  /** The power of t. */
  readonly power: number;
  /** Which of the terms of the sum it comes from, from 0. */
  readonly from: number;
}

/** The surface's equation as one sum that is zero on it: left − right. */
export function asZero({ left, right }: Relation): Expr {
  return { op: 'sum', terms: [...termsOf(left, 1), ...termsOf(right, -1)] };
}

/** The terms of a sum, or the tree itself; zeros are left out. */
export function termsOf(expr: Expr, sign: 1 | -1): Term[] {
  if (expr.op === 'number' && expr.value === 0) return [];
  if (expr.op === 'negative') return termsOf(expr.of, sign === 1 ? -1 : 1);
  if (expr.op !== 'sum') return [{ sign, expr }];
  return expr.terms.flatMap((term) => termsOf(term.expr, term.sign === sign ? 1 : -1));
}

/** x, y, z replaced by Ex + t dx, …, and the vector X by E + t d. Outer terms keep their order. */
export function substituteRay(expr: Expr): Expr {
  if (expr.op !== 'sum') return substitute(expr);
  return {
    op: 'sum',
    terms: expr.terms.map(({ sign, expr: term }) => ({ sign, expr: substitute(term) })),
  };
}

function substitute(expr: Expr): Expr {
  switch (expr.op) {
    case 'scalar':
      return /^[xyz]$/.test(expr.id) ? POINT[axisIndex(expr.id as Axis)] : expr;
    case 'component':
      return expr.vector === 'X' ? POINT[axisIndex(expr.axis)] : expr;
    case 'sum':
      return tLast(expr.terms.flatMap(({ sign, expr: term }) => termsOf(substitute(term), sign)));
    case 'product':
      return times(...expr.factors.map(substitute));
    case 'quotient':
      return over(substitute(expr.over), substitute(expr.under));
    case 'negative':
      return negative(substitute(expr.of));
    case 'square':
      return squared(substitute(expr.of));
    case 'dot':
      return {
        op: 'dot',
        left: substituteInVector(expr.left),
        right: substituteInVector(expr.right),
      };
    case 'number':
      return expr;
    default:
      throw new RangeError(`no polynomial: ${expr.op}`);
  }
}

const RAY: VectorExpr = {
  op: 'moved',
  from: { op: 'vector', id: 'E' },
  by: 't',
  step: { op: 'vector', id: 'd' },
};

function substituteInVector(v: VectorExpr): VectorExpr {
  if (v.op === 'vector') return v.id === 'X' ? RAY : v;
  return v.op === 'difference'
    ? vecMinus(substituteInVector(v.left), substituteInVector(v.right))
    : v;
}

/** Ex − Vx + t dx: terms without t first. */
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
    case 'dot':
      return [expr.left, expr.right].some((v) => byPower(v).length > 1);
    default:
      return is(expr);
  }
}

/**
 * A polynomial in t as a sum of products, each term of the outermost sum for itself and in its
 * order. Throws RangeError for what is no polynomial in t.
 */
export function expanded(expr: Expr): Product[] {
  const outer: readonly Term[] = expr.op === 'sum' ? expr.terms : [{ sign: 1, expr }];
  return outer.flatMap(({ sign, expr: term }, from) =>
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
    case 'dot':
      return byPower(expr.left).flatMap((p) =>
        byPower(expr.right).map((q) => ({
          ...one,
          sign: p.sign === q.sign ? 1 : -1,
          factors: [dot(p.of, q.of)],
          power: p.power + q.power,
        })),
      );
    default:
      throw new RangeError(`no polynomial in t: ${expr.op}`);
  }
}

interface VectorTerm {
  readonly sign: 1 | -1;
  readonly power: 0 | 1;
  readonly of: VectorExpr;
}

/** E + t d − P as E − P and t d. */
function byPower(v: VectorExpr): VectorTerm[] {
  if (v.op === 'vector') return [{ sign: 1, power: 0, of: v }];
  if (v.op === 'moved') {
    return [
      { sign: 1, power: 0, of: v.from },
      { sign: 1, power: 1, of: v.step },
    ];
  }
  const [left, right] = [byPower(v.left), byPower(v.right)];
  return ([0, 1] as const).flatMap((power): VectorTerm[] => {
    const [these, those] = [left, right].map((terms) => terms.filter((p) => p.power === power));
    const [a, b, ...more] = [...(these ?? []), ...(those ?? [])];
    const isPair = a?.sign === 1 && b?.sign === 1 && these?.length === 1 && more.length === 0;
    if (isPair) return [{ ...a, of: vecMinus(a.of, b.of) }];
    const less = (those ?? []).map((p): VectorTerm => ({ ...p, sign: p.sign === 1 ? -1 : 1 }));
    return [...(these ?? []), ...less];
  });
}

/** All terms without t as one term, and behind it those with t. */
function inPowers(terms: readonly Term[]): readonly Term[] {
  const free = terms.filter(({ expr }) => !holdsT(expr));
  if (free.length < 2) return terms;
  const rest = terms.filter(({ expr }) => holdsT(expr));
  return [{ sign: 1, expr: { op: 'sum', terms: free } }, ...rest];
}

/** The numbers of a product go into `count`; any other tree without t is one factor. */
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

/** The coefficient of t^power in a sum of products; 0 if there is none. */
export const collected = (all: readonly Product[], power: number): Expr =>
  summed(all.filter((p) => p.power === power).map((p) => ({ sign: p.sign, expr: withoutT(p) })));

/** A sum of its terms, one of them as it is; 0 for none. */
export function summed(terms: readonly Term[]): Expr {
  const [only] = terms;
  if (!only) return num(0);
  return terms.length === 1 && only.sign === 1 ? only.expr : { op: 'sum', terms };
}

/** The product without its sign and its power of t. */
export const withoutT = ({ count, factors }: Product): Expr => product(count, factors);

/** 2 t dx (Ex − Vx): its number, then its power of t. */
export function withT({ count, factors, power }: Product): Expr {
  const t = scalar('t');
  const inT = power === 0 ? [] : [power === 1 ? t : squared(t)];
  return product(count, [...inT, ...factors]);
}

function product(count: number, factors: readonly Expr[]): Expr {
  const all = count === 1 && factors.length > 0 ? factors : [num(count), ...factors];
  return all.length === 1 ? (all[0] as Expr) : times(...all);
}
