import type { Quadric } from '../../../src/math/batch/quadric.ts';
import type { Dyadic } from '../../../src/math/exact/dyadic.ts';
import * as dy from '../../../src/math/exact/dyadic.ts';
import { bracket } from '../../../src/math/exact/faithful.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { type ExactSolution, solveExact } from './exact/solve-exact.ts';

const n = dy.fromNumber;

/** a, exactly. */
export const flareOf = (q: Quadric): Dyadic => (q.squared ? dy.sqr(n(q.flare)) : n(q.flare));

/** x·x' + z·z' − a·y·y', exactly. */
export const form = (
  a: Dyadic,
  [x, y, z]: readonly Dyadic[],
  [u, v, w]: readonly Dyadic[],
): Dyadic =>
  dy.sub(
    dy.add(dy.mul(x as Dyadic, u as Dyadic), dy.mul(z as Dyadic, w as Dyadic)),
    dy.mul(a, dy.mul(y as Dyadic, v as Dyadic)),
  );

/** The ray's quadratic, solved exactly. */
export function solved(q: Quadric, { origin: E, direction: d }: Ray): ExactSolution {
  const a = q.hasY ? flareOf(q) : dy.ZERO;
  const center = [q.Cx, q.Cy, q.Cz];
  const p = E.map((x, k) => dy.sub(n(x), n(center[k] as number)));
  const v = d.map(n);
  const C = dy.sub(form(a, p, p), dy.sqr(n(q.r)));
  return solveExact(form(a, v, v), dy.shift(form(a, v, p), 1), C);
}

/**
 * What is wrong with these roots, NaN where there is none; null if each is one of the two doubles
 * around its root, or the root itself.
 */
export function unfaithful(q: Quadric, ray: Ray, t0: number, t1: number): string | null {
  const { class: verdict, roots } = solved(q, ray);
  const found = [t0, t1].filter((t) => !Number.isNaN(t));
  const right =
    found.length === roots.length &&
    (verdict === 'two' || verdict === 'none') &&
    roots.every((root, k) => bracket(root).includes(found[k] as number));
  return right
    ? null
    : `${JSON.stringify({ q, ray })}: ${found}, but ${verdict} ${roots.map(bracket)}`;
}
