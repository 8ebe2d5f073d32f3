import { describe, expect, test } from 'vitest';
import { intersect } from '../../../src/math/intersect.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';

/*
 * The answer is data: whoever spreads, clones, saves or compares it gets all of it, whichever stage
 * decided.
 */

const sphere: Shape = { kind: 'hyperboloid', center: [0, 0, 0], flare: -1, radius: 3 };
const cylinder: Shape = { kind: 'cylinder', center: [0, 7, 0], radius: 1 };
const cone: Shape = { kind: 'cone', vertex: [0, 0, 0], slope: 0.5 };
const circle: Shape = { kind: 'circle', normal: [0, 0, 2], center: [0, 0, 0], radius: 5 };
const square: Shape = { kind: 'square', corner: [0, 0, 0], side: 2, axis: 'y' };
const plane: Shape = { kind: 'plane', normal: [1, 2, 3], point: [0, 0, 1] };
const CASES: [string, Shape, Ray][] = [
  ['two hits, every number by twice the digits', sphere, ray([-5, 1, 0.5], [1, 0.25, 0.1])],
  ['a miss', sphere, ray([-5, 4, 0.5], [1, 0.25, 0.1])],
  ['two hits, E on the surface', cylinder, ray([1, 2, 0], [-1, 3, 0.5])],
  ['grazing', cylinder, ray([-3, 0, 1 - 2 ** -45], [1, 0.3, 0])],
  ['far away', cylinder, ray([-3e9, 0, 0.3], [1, 0.25, 0])],
  ['a tangent', cylinder, ray([-3, 0, 1], [1, 0.3, 0])],
  ['one hit, parallel to a generator', cone, ray([1, 0, 0], [0.5, 1, 0])],
  ['contained', cone, ray([1, 2, 0], [0.5, 1, 0])],
  ['the vertex', cone, ray([1, 0, 0], [-1, 0, 0])],
  ['beyond the doubles', cylinder, ray([0, 0, 0], [1e-310, 0, 0])],
  ['a circle', circle, ray([1, 2, 3], [0.1, 0.2, -1])],
  ['a rim', circle, ray([3, 4, 3], [0, 0, -1])],
  ['beside a circle', circle, ray([3, 4.5, 3], [0, 0, -1])],
  ['a square', square, ray([1, 2, 0.3], [0.1, -1, 0.2])],
  ['along a square', square, ray([1, 0, 0.3], [0.1, 0, 0.2])],
  ['a plane', plane, ray([1, 2, 3], [0.1, 0.7, -1])],
];

function ray(origin: Ray['origin'], direction: Ray['direction']): Ray {
  return { origin, direction };
}

describe('a certified answer is plain data', () => {
  test.each(CASES)('%s', (_, shape, asked) => {
    const found = intersect(shape, asked, 'certified');
    const { details } = found;
    expect(Object.keys(found).sort()).toEqual(['class', 'decidedBy', 'details', 'hits', 'method']);
    expect({ ...found }.details).toEqual(details);
    expect(structuredClone(found)).toEqual(found);
    expect(JSON.parse(JSON.stringify(found)).details).toEqual(JSON.parse(JSON.stringify(details)));
    expect(found).toEqual({ ...found });
    for (const hit of found.hits) {
      expect(Object.entries(hit)).toEqual([
        ['t', hit.t],
        ['point', hit.point],
        ['normal', hit.normal],
        ['singular', hit.singular],
      ]);
      expect(Object.getPrototypeOf(hit)).toBe(Object.prototype);
    }
  });

  test('a comparison sees the details', () => {
    const [a, b] = [3, 4.5].map((x) => intersect(circle, ray([9, x, 3], [0, 0, -1]), 'certified'));
    expect([a?.class, b?.class]).toEqual(['none', 'none']);
    expect(a).not.toEqual(b);
  });

  test.each(CASES)('%s: details and signs are those of the exact method', (_, shape, asked) => {
    const { details } = intersect(shape, asked, 'certified');
    expect(details).toEqual(intersect(shape, asked, 'exact').details);
  });

  test.each(CASES)('%s: what becomes of the question later does not matter', (_, shape, asked) => {
    const [ourShape, ourRay] = structuredClone([shape, asked]);
    const before = structuredClone(intersect(ourShape, ourRay, 'certified'));
    const found = intersect(ourShape, ourRay, 'certified');
    for (const numbers of [ourRay.origin, ourRay.direction, ...Object.values(ourShape)]) {
      if (Array.isArray(numbers)) numbers.fill(17);
    }
    Object.assign(ourShape, { radius: 9, side: 9, slope: 9 });
    expect(structuredClone(found)).toEqual(before);
  });
});
