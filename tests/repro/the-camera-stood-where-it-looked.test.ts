import { expect, test } from 'vitest';
import { Projection } from '../../src/canvas/projection.ts';
import { restaged } from '../../src/canvas/viewpoint.ts';
import type { Stage } from '../../src/math/shapes/drawing.ts';

/*
 * A centre dragged in a scene of size 1e308 and let go in one of size 1: the camera's way from the
 * one to the other began with a zoom of Infinity, at no distance from what it looked at, and
 * handles were put at NaN. Found by the random user (seed 11), now and then.
 */
const pose = { target: [0, 0, 0], azimuth: 16, elevation: 14, zoom: 1 } as const;
const stage = (radius: number): Stage => ({
  center: [0, 0, radius / 2],
  radius,
  ground: 0,
  low: -radius,
  high: radius,
});

test.each([
  [1, 1e308],
  [1e308, 1],
  [1, 1e300],
  [1e-300, 1e300],
  [1, 1e5],
])('from a stage of size %f to one of %f there is no way', (from, to) => {
  expect(restaged(pose, stage(from), stage(to))).toBeNull();
});

test('from one of size 1 to one of 4 there is', () => {
  const there = restaged(pose, stage(1), stage(4));
  expect(there?.zoom).toBe(4);
  const { near, eye } = new Projection({ ...pose, ...there }, 720, 440);
  expect(near).toBeGreaterThan(0);
  expect(eye.every(Number.isFinite)).toBe(true);
});
