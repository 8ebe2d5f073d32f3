import { describe, expect, test } from 'vitest';
import type { Stage } from '../../../src/math/shapes/drawing.ts';
import {
  drawDisc,
  drawPlane,
  drawSquare,
  inPlaneAxes,
  spanning,
  unitAlong,
} from '../../../src/math/shapes/flat-drawing.ts';
import { drawRevolution } from '../../../src/math/shapes/revolve.ts';
import { multiplesWithin, roundStep } from '../../../src/math/shapes/steps.ts';
import { AXES, type Vec3 } from '../../../src/math/vec3.ts';

const STAGE: Stage = { center: [0, 1, 0], radius: 5, ground: -1, low: -1, high: 4 };
const O: Vec3 = [0, 0, 0];

/** Sines and cosines of whole turns are off by an ε or two, times lengths of at most 10. */
const DIGITS = 13;

function expectNear(a: Vec3, b: Vec3): void {
  a.forEach((x, i) => {
    expect(x).toBeCloseTo(b[i] ?? 0, DIGITS);
  });
}

describe('round steps', () => {
  test.each([
    [1, 1],
    [1.99, 1],
    [2, 2],
    [4.9, 2],
    [5, 5],
    [9.9, 5],
    [10, 10],
    [0.3, 0.2],
    [0.05, 0.05],
    [7e-9, 5e-9],
    [123456, 100000],
  ])('%d → %d', (x, step) => {
    expect(roundStep(x)).toBeCloseTo(step, 12);
  });

  test.each([1e-300, 1e-9, 1e7, 1e300])('never above, never below a half or so: %d', (scale) => {
    for (let lead = 1; lead < 10; lead += 0.37) {
      const ratio = roundStep(lead * scale) / (lead * scale);
      expect(ratio).toBeLessThanOrEqual(1 + 1e-8);
      expect(ratio).toBeGreaterThan(0.39);
    }
  });

  test('multiples lie strictly between', () => {
    expect(multiplesWithin(0, 1, 0.25)).toEqual([0.25, 0.5, 0.75]);
    expect(multiplesWithin(-1, 1, 0.5)).toEqual([-0.5, 0, 0.5]);
    expect(multiplesWithin(0.1, 0.2, 0.5)).toEqual([]);
    expect(multiplesWithin(0, 1e9, 1)).toHaveLength(200);
  });
});

describe('a surface of revolution', () => {
  const patches = (a: number, r: number, center: Vec3 = O) =>
    drawRevolution({ center, a, r }, 'C', STAGE).patches;
  const ends = (a: number, r: number, center: Vec3 = O) =>
    patches(a, r, center).map(({ start, end }) => `${start}…${end}`);

  test('cylinder: one piece from the bottom of the stage to its top', () => {
    const [patch] = patches(0, 2);
    expect(ends(0, 2)).toEqual(['rim…goes-on']);
    expectNear(patch?.at(0, 0) ?? O, [0, -1, 2]);
    expectNear(patch?.at(0.25, 1) ?? O, [2, 4, 0]);
    expectNear(patch?.normal(0.25, 1) ?? O, [2, 0, 0]);
  });

  test('cone: two nappes that meet in the vertex', () => {
    expect(ends(0.25, 0)).toEqual(['rim…point', 'point…goes-on']);
    const [lower, upper] = patches(0.25, 0);
    expectNear(lower?.at(0.3, 1) ?? [1, 1, 1], O);
    expectNear(upper?.at(0.3, 0) ?? [1, 1, 1], O);
    // |c h| = ½·4 at the top.
    expectNear(upper?.at(0.25, 1) ?? O, [2, 4, 0]);
    expectNear(lower?.at(0.25, 0) ?? O, [0.5, -1, 0]);
  });

  test('at the vertex each generator still has a side: the normal of its nappe', () => {
    const [lower, upper] = patches(0.25, 0);
    expectNear(lower?.normal(0.25, 1) ?? O, [1, 0.5, 0]);
    expectNear(upper?.normal(0.25, 0) ?? O, [1, -0.5, 0]);
  });

  test('a vertex above or below the stage leaves one nappe', () => {
    expect(ends(0.25, 0, [0, 6, 0])).toEqual(['rim…goes-on']);
    expect(ends(0.25, 0, [0, -3, 0])).toEqual(['rim…goes-on']);
    expect(ends(0.25, 0, [0, 4, 0])).toEqual(['rim…point']);
    expect(ends(0.25, 0, [0, -1, 0])).toEqual(['point…goes-on']);
  });

  test('hyperboloid: its waist, and √(ah² + r²) above', () => {
    const [patch] = patches(1, 3, [0, 0, 1]);
    expect(ends(1, 3)).toEqual(['rim…goes-on']);
    // h = 4 at the top: √(16 + 9) = 5.
    expectNear(patch?.at(0, 1) ?? O, [0, 4, 6]);
  });

  test('one that grows wide is cut where it leaves the stage', () => {
    // Radius √(100 h² + 1) reaches 1.15·5 at h ≈ ±0.566.
    const [patch] = patches(100, 1);
    expect(patch?.at(0, 0)[1]).toBeCloseTo(-Math.sqrt((5.75 ** 2 - 1) / 100), 12);
    expect(patch?.at(0, 1)[1]).toBeCloseTo(Math.sqrt((5.75 ** 2 - 1) / 100), 12);
  });

  test('ellipsoid: closed at both poles within the stage, cut where it is larger', () => {
    expect(ends(-4, 2, [0, 1, 0])).toEqual(['point…point']);
    const [patch] = patches(-4, 2, [0, 1, 0]);
    expectNear(patch?.at(0.1, 0) ?? O, [0, 0, 0]);
    expectNear(patch?.at(0.1, 1) ?? O, [0, 2, 0]);
    expectNear(patch?.at(0.25, 0.5) ?? O, [2, 1, 0]);
    // Whole below the ground too, where a ring would look like a hole.
    expect(ends(-1, 2, [0, -2, 0])).toEqual(['point…point']);
    expect(ends(-1, 2, [0, 6, 0])).toEqual(['point…goes-on']);
    expect(ends(-1, 2, [0, -4, 0])).toEqual(['rim…point']);
    expect(ends(-1, 2, [0, 9, 0])).toEqual([]);
    expect(ends(-1e-3, 2)).toEqual(['rim…goes-on']);
  });

  test('ellipsoid: its ends move with its size and place without a jump', () => {
    const STEP = 0.01;
    for (const [y, least] of [
      [1, 1],
      [-1, 3],
      [4, 0.5],
    ] as const) {
      const reach = (half: number) => {
        const [patch] = patches(-1, half, [0, y, 0]);
        return [patch?.at(0, 0)[1] ?? y, patch?.at(0, 1)[1] ?? y] as const;
      };
      for (let half = least; half < 12; half += STEP) {
        const [a, b] = [reach(half), reach(half + STEP)];
        for (const i of [0, 1] as const) expect(Math.abs(a[i] - b[i])).toBeLessThan(5 * STEP);
      }
    }
  });

  test('what is only a line or a point has no patch', () => {
    expect(ends(0, 0)).toEqual([]);
    expect(ends(-1, 0)).toEqual([]);
  });

  test('rings lie at round heights', () => {
    const [patch] = patches(0, 2);
    const heights = (patch?.rings ?? []).map((v) => patch?.at(0, v)[1] ?? 0);
    heights.forEach((y, i) => {
      expect(y).toBeCloseTo(i, DIGITS);
    });
    expect(heights).toHaveLength(4);
    const [round] = patches(-1, 2, [0, 1, 0]);
    const levels = (round?.rings ?? []).map((v) => round?.at(0, v)[1] ?? 0);
    [0, 1, 2].forEach((y, i) => {
      expect(levels[i]).toBeCloseTo(y, DIGITS);
    });
  });

  test('its axis runs through the centre, a little beyond the top', () => {
    const { lines, marks } = drawRevolution({ center: [1, 2, 3], a: 0, r: 1 }, 'V', STAGE);
    expect(lines).toEqual([{ from: [1, -1, 3], to: [1, 4.2, 3] }]);
    expect(marks).toEqual([{ symbol: 'V', at: [1, 2, 3] }]);
  });

  test('the mark of a centre above or below the stage stays in the picture', () => {
    const at = (y: number) =>
      drawRevolution({ center: [1, y, 3], a: 0, r: 1 }, 'C', STAGE).marks[0]?.at;
    expect(at(100)).toEqual([1, 4, 3]);
    expect(at(-100)).toEqual([1, -1, 3]);
  });
});

describe('flat figures', () => {
  test.each<Vec3[]>([
    [[0, 1, 0]],
    [[1, 0, 0]],
    [[0, 0, -3]],
    [[1, 1, 0.5]],
    [[-2, 1, 5]],
    [[1e-9, 1, 0]],
    [[3e300, -4e300, 0]],
    [[3e-310, 4e-310, 0]],
  ])('%j: e1, e2 and the unit normal are a right-handed frame', (normal) => {
    const { e1, e2, unit } = spanning(normal);
    const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    expect(dot(e1, e1)).toBeCloseTo(1, DIGITS);
    expect(dot(e2, e2)).toBeCloseTo(1, DIGITS);
    expect(dot(unit, unit)).toBeCloseTo(1, DIGITS);
    // √ε of slack: e1 is taken level where the normal is almost upright.
    expect(dot(e1, unit)).toBeCloseTo(0, 7);
    expect(dot(e2, unit)).toBeCloseTo(0, 7);
    const largest = Math.max(...normal.map(Math.abs));
    expect(dot(unit, normal.map((c) => c / largest) as unknown as Vec3)).toBeGreaterThan(0.99);
  });

  test('a plane is drawn about its point nearest to the middle of the stage', () => {
    const { patches, marks, normals } = drawPlane([0, 2, 0], [9, -3, 9], STAGE);
    expectNear(patches[0]?.at(0.5, 0.5) ?? O, [0, -3, 0]);
    expect(marks).toEqual([{ symbol: 'P', at: [9, -3, 9] }]);
    expect(normals).toEqual([{ at: [9, -3, 9], direction: [0, 1, 0] }]);
    // A square about it, not far beyond the ball that the camera frames.
    const far = [0, 1].flatMap((u) =>
      [0, 1].map((v) => {
        const [x, y, z] = patches[0]?.at(u, v) ?? O;
        return Math.hypot(x, y + 3, z);
      }),
    );
    for (const corner of far) expect(corner).toBeCloseTo(far[0] ?? 0, DIGITS);
    expect(far[0]).toBeGreaterThan(STAGE.radius / 2);
    expect(far[0]).toBeLessThan(STAGE.radius * 1.3);
  });

  test('a disc: its rim is r away from its centre, in its plane', () => {
    const [patch] = drawDisc([0, 0, 3], [1, 2, 3], 2).patches;
    for (const u of [0, 0.2, 0.7, 1]) {
      const [x, y, z] = patch?.at(u, 1) ?? O;
      expect(Math.hypot(x - 1, y - 2)).toBeCloseTo(2, DIGITS);
      expect(z).toBe(3);
    }
    expect(patch?.at(0.4, 0)).toEqual([1, 2, 3]);
    expect(patch?.end).toBe('edge');
  });

  test.each([
    ['x', [1, 2, 3], [1, 4, 3], [1, 2, 5], [1, 4, 5]],
    ['y', [1, 2, 3], [1, 2, 5], [3, 2, 3], [3, 2, 5]],
    ['z', [1, 2, 3], [3, 2, 3], [1, 4, 3], [3, 4, 3]],
  ] as const)('a square with normal %s: its four corners', (axis, at00, at10, at01, at11) => {
    const { patches, normals } = drawSquare(axis, [1, 2, 3], 2);
    const [patch] = patches;
    expect([patch?.at(0, 0), patch?.at(1, 0), patch?.at(0, 1), patch?.at(1, 1)]).toEqual([
      at00,
      at10,
      at01,
      at11,
    ]);
    expect(normals[0]?.direction).toEqual(unitAlong(axis));
  });

  test.each(AXES)('the axes of a plane with normal %s turn right-handed about it', (axis) => {
    const [first, second] = inPlaneAxes(axis).map(unitAlong) as [Vec3, Vec3];
    const cross = [
      first[1] * second[2] - first[2] * second[1],
      first[2] * second[0] - first[0] * second[2],
      first[0] * second[1] - first[1] * second[0],
    ].map((c) => c + 0);
    expect(cross).toEqual([...unitAlong(axis)]);
  });
});
