import {
  batchOf,
  createAnswers,
  createRays,
  kernelArray,
  type Rays,
  verdictsOfRoots,
} from '../../src/math/batch.ts';
import { exactMethod } from '../../src/math/exact.ts';
import type { Family } from '../../src/math/families.ts';
import type { Ray, Shape } from '../../src/math/index.ts';
import type { Random } from '../../src/math/rng.ts';

/*
 * Rays to be timed on: so many that no processor knows by heart which of them hit. A batch of a
 * few hundred, asked again and again, is learned, and branches then cost nothing.
 */

/** As their family draws them; or those that hit before those that do not. */
export const ORDERS = ['random', 'sorted'] as const;
export type Order = (typeof ORDERS)[number];

/** A shape and its rays, in one of the orders. */
export interface Drawn {
  readonly shape: Shape;
  readonly rays: Readonly<Record<Order, readonly Ray[]>>;
}

/** The hits stand in the same order among themselves, and so do the misses. */
export function draw(family: Family, random: Random, count: number): Drawn {
  const { shape, rays: list } = family.batch(random, count);
  const rays = createRays(count);
  put(rays, list);
  const out = createAnswers(count);
  batchOf(exactMethod, shape).both(rays, out);
  const verdicts = verdictsOfRoots(out, count);
  const where = (hit: boolean): readonly Ray[] =>
    list.filter((_, i) => (verdicts[i] !== 'none') === hit);
  return { shape, rays: { random: list, sorted: [...where(true), ...where(false)] } };
}

/** One set of arrays for all shapes in turn: each of them has the same place in the caches. */
export const room = (count: number): Rays => createRays(count, kernelArray);

export function put(into: Rays, list: readonly Ray[]): void {
  into.count = list.length;
  list.forEach(({ origin, direction }, i) => {
    [into.Ex[i], into.Ey[i], into.Ez[i]] = origin;
    [into.dx[i], into.dy[i], into.dz[i]] = direction;
  });
}
