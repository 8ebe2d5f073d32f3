import { describe, expect, test } from 'vitest';
import { createAnswers, packRays } from '../../../src/math/batch.ts';
import { nextDown, nextUp } from '../../../src/math/float/ulp.ts';
import { intersect, METHODS, type Ray, type Shape, type Solid } from '../../../src/math/index.ts';
import { integer, seeded } from '../../../src/math/rng.ts';
import { body } from '../../../src/scene/effects/heights-body.ts';
import { sixShapes } from '../../../src/scene/presets/six-shapes.ts';
import type { Scene } from '../../../src/scene/types.ts';
import { worldOf } from '../../../src/tracer/world.ts';

/*
 * Rays whose roots are at a rim to the last bit, from near and far: the tracer keeps and cuts off
 * what the math module does.
 */

const SHAPES: readonly Shape[] = [
  { kind: 'cylinder', center: [0, 0, 0], radius: 1 },
  { kind: 'cone', vertex: [0, 3, 0], slope: 0.5 },
  { kind: 'sphere', center: [0, 0.5, 0], radius: 1.5 },
  { kind: 'hyperboloid', center: [0, 0, 0], flare: 0.5, radius: 0.75 },
  { kind: 'paraboloid', vertex: [0, -2, 0], width: 0.5 },
];

/** A ray, and heights at the root's own height or a double beside it. */
function* rims(
  seed: number,
  shape: Shape,
  away: number,
): Generator<{ ray: Ray; between: [number, number] }> {
  const random = seeded(seed);
  const part = (): number => integer(random, -9, 9) / 8;
  for (let k = 0; k < 300; k++) {
    const near = [5 * part(), 3 * part(), 5 * part()] as const;
    const direction = [-near[0] + part(), part(), -near[2] + part()] as const;
    const origin = near.map((x, i) => x - away * direction[i as 0]) as [number, number, number];
    if (direction.every((x) => x === 0)) continue;
    const { hits } = intersect(shape, { origin, direction });
    const y = hits[k % 2]?.point[1];
    if (y === undefined || !Number.isFinite(y) || Math.abs(y) > 9) continue;
    const rim = [y, nextUp(y), nextDown(y)][k % 3] ?? y;
    yield { ray: { origin, direction }, between: k % 4 < 2 ? [rim, 99] : [-99, rim] };
  }
}

const CASES = METHODS.flatMap(({ id }) => [0, 2 ** 20].map((away) => [id, away] as const));

describe.each(CASES)('%s, %d lengths of d away', (method, away) => {
  test.each(SHAPES.map((shape) => [shape.kind, shape] as const))('%s', (_, shape) => {
    let close = 0;
    for (const { ray, between } of rims(7, shape, away)) {
      const [thing] = sixShapes.scene.things;
      if (!thing) throw new Error('a thing was expected');
      const { capped: __, ...rest } = thing;
      const scene: Scene = { ...sixShapes.scene, things: [{ ...rest, shape, between }] };
      const [target] = worldOf(scene, method, 'needed').targets;
      if (!target) throw new Error('a target was expected');
      const out = createAnswers(1);
      const rays = packRays([ray]);
      target.kernel.both(rays, out);
      body.choose(rays, out, target, Number.MIN_VALUE, false);
      const kept = intersect({ ...shape, between } as Solid, ray, method).hits.filter(
        ({ fate, t }) => fate === 'hit' && t > 0,
      );
      const about = JSON.stringify({ ray, between });
      expect(Number.isNaN(out.t0[0]), about).toBe(kept.length === 0);
      close += 1;
    }
    expect(close).toBeGreaterThan(50);
  });
});
