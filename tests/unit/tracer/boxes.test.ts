import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createRays } from '../../../src/math/batch.ts';
import type { Box } from '../../../src/math/drawing.ts';
import { BUNDLE, bundle, createBundles, meetBox } from '../../../src/tracer/boxes.ts';
import { askBoxed, groupsOf } from '../../../src/tracer/groups.ts';
import { createScratch } from '../../../src/tracer/scratch.ts';
import type { Target } from '../../../src/tracer/world.ts';
import { many } from '../many.ts';

/** Small whole numbers, so that rays run in planes of sides and through corners, and any others. */
const coordinate = fc.oneof(
  fc.integer({ min: -3, max: 3 }),
  fc.constantFrom(-0, 1e-300, -1e300, 2 ** -1074, 1 / 3),
  fc.double({ min: -5, max: 5, noNaN: true }),
);
const point = fc.tuple(coordinate, coordinate, coordinate);
const ray = fc.record({ E: point, d: point, limit: fc.constantFrom(0.5, 3, 1e308, Infinity) });
const box = fc.tuple(point, point).map(([a, b]): Box => {
  const [low, high] = [Math.min, Math.max].map((pick) => a.map((x, k) => pick(x, b[k] as number)));
  return { low, high } as unknown as Box;
});
/** Rays beside each other, as a bundle mostly has them. */
const bunch = fc
  .tuple(
    ray,
    fc.constantFrom(0, 1e-3, 0.3),
    fc.array(fc.tuple(point, point), { maxLength: 2 * BUNDLE }),
  )
  .map(([first, spread, others]) => [
    first,
    ...others.map(([E, d]) => ({
      E: first.E.map((x, k) => x + spread * (E[k] as number)) as typeof E,
      d: first.d.map((x, k) => x + spread * (d[k] as number)) as typeof d,
      limit: first.limit,
    })),
  ]);
const several = fc.oneof(bunch, fc.array(ray, { minLength: 1, maxLength: 3 * BUNDLE }));
type OneRay = typeof ray extends fc.Arbitrary<infer T> ? T : never;

function packed(list: readonly OneRay[]) {
  const rays = createRays(list.length);
  list.forEach(({ E, d }, i) => {
    [rays.Ex[i], rays.Ey[i], rays.Ez[i]] = E;
    [rays.dx[i], rays.dy[i], rays.dz[i]] = d;
  });
  rays.count = list.length;
  return { rays, count: list.length, limit: Float64Array.from(list, ({ limit }) => limit) };
}

/** For each box the rays that the hierarchy of all boxes asks it about. */
function asked(boxes: readonly Box[], list: readonly OneRay[]): readonly number[][] {
  const targets = boxes.map((one, surface) => ({ box: one, surface }) as unknown as Target);
  const scratch = createScratch({ rule: 'from' }, undefined);
  scratch.need(list.length);
  const found: number[][] = boxes.map(() => []);
  askBoxed(groupsOf(targets, true), packed(list), scratch, (surface, those, n) => {
    found[surface] = [...those.subarray(0, n)];
  });
  return found;
}

/** The same for one box alone. */
function meeting(one: Box, list: readonly OneRay[]): readonly number[] {
  const { rays, count, limit } = packed(list);
  const bundles = createBundles(count);
  bundle(rays, count, bundles);
  const those = Int32Array.from({ length: count }, (_, i) => i);
  return [...those.subarray(0, meetBox(one, rays, bundles, limit, those, count, those))];
}

describe('boxes', () => {
  it('a hierarchy of bundles asks each box about the same rays as one by one', () => {
    fc.assert(
      fc.property(fc.array(box, { minLength: 1, maxLength: 9 }), several, (boxes, list) => {
        expect(asked(boxes, list)).toEqual(boxes.map((one) => meeting(one, list)));
      }),
      { numRuns: many(8000) },
    );
  });

  it('a ray through a point of a box before its limit meets it, also along its sides', () => {
    const small = fc.integer({ min: -4, max: 4 });
    const whole = fc.tuple(small, small, small);
    fc.assert(
      fc.property(whole, whole, whole, whole, (E, P, a, b) => {
        fc.pre(E.some((x, k) => x !== P[k]));
        const d = P.map((x, k) => x - (E[k] as number)) as [number, number, number];
        const [low, high] = [Math.min, Math.max].map((pick) =>
          P.map((x, k) => pick(x, a[k] as number, b[k] as number)),
        );
        expect(asked([{ low, high } as unknown as Box], [{ E, d, limit: 1 }])).toEqual([[0]]);
      }),
      { numRuns: many(8000) },
    );
  });
});
