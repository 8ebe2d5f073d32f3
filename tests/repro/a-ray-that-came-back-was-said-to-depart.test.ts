import { expect, test } from 'vitest';
import { packRays } from '../../src/math/batch/batch.ts';
import { quadricOf } from '../../src/math/batch/quadric.ts';
import type { Ray, Shape } from '../../src/math/index.ts';
import { intersect } from '../../src/math/intersect.ts';
import { departs } from '../../src/tracer/departs.ts';

const shape: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare: 2 ** -600, radius: 2 ** 10 };
const q = quadricOf(shape);

/** a·dy was 0 in doubles, and times py it decides: found by deriving the bound again. */
test('a·dy below the doubles, times a height far above them', () => {
  const ray: Ray = {
    origin: [2 ** 700, 2 ** 1000, 0],
    direction: [2 ** -810, 2 ** -500, 2 ** -449],
  };
  expect(intersect(shape, ray, 'exact').hits.some(({ t }) => t > 0)).toBe(true);
  expect(q && departs(q, q.flare, packRays([ray]), 0)).toBe(false);
});

test('a·dy among the least doubles, where it loses bits', () => {
  for (let n = 1; n < 50; n++) {
    // dx·px is a little less than a·dy·py, unless a·dy was rounded down.
    const up = 1 + n / 50;
    const ray: Ray = {
      origin: [2 ** 700, 2 ** 1000, 0],
      direction: [up * (1 - 2 ** -45) * 2 ** -735, up * 2 ** -435, 2 ** -449],
    };
    expect(intersect(shape, ray, 'exact').hits.some(({ t }) => t > 0)).toBe(true);
    expect(q && departs(q, q.flare, packRays([ray]), 0)).toBe(false);
  }
});
