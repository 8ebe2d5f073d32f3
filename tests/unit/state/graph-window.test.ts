import { describe, expect, test } from 'vitest';
import { intersect, type Ray, type Shape } from '../../../src/math/index.ts';
import { graphWindowOf } from '../../../src/state/graph-window.ts';

/** A line through the axis of a cylinder, with these two roots as nearly as doubles have them. */
function lineWith(t1: number, t2: number) {
  const shape: Shape = { kind: 'cylinder', center: [0, 0, 0], radius: (t2 - t1) / 2 };
  const ray: Ray = { origin: [(t1 + t2) / 2, 0, 0], direction: [-1, 0, 0] };
  return intersect(shape, ray, 'exact');
}

const windowWith = (t1: number, t2: number) => graphWindowOf(lineWith(t1, t2));
const SCALES = Array.from({ length: 25 }, (_, i) => 10 ** (i - 12));

describe('the stretch of t that the graph shows', () => {
  test('holds E, the roots and the tip of d with room beside, at the size of a hand', () => {
    expect(windowWith(2, 4)).toEqual({ from: -0.56, to: 5.2, note: null });
    const behind = windowWith(-5, -2);
    expect(behind.from).toBeCloseTo(-5.84, 12);
    expect(behind.to).toBeCloseTo(2.8, 12);
    expect(windowWith(0.25, 0.5).to).toBeGreaterThan(1);
  });

  test.each(SCALES)('takes its scale from the roots: two of them at %d and its triple', (scale) => {
    for (const sign of [1, -1]) {
      const roots = [sign * scale, 3 * sign * scale].sort((a, b) => a - b);
      const { from, to, note } = windowWith(roots[0] ?? 0, roots[1] ?? 0);
      const share = roots.map((t) => (t - from) / (to - from));
      // Both inside, and far enough apart to be told from one another.
      expect(Math.min(...share)).toBeGreaterThan(0.02);
      expect(Math.max(...share)).toBeLessThan(0.98);
      expect((share[1] ?? 0) - (share[0] ?? 0)).toBeGreaterThan(0.019);
      expect(from).toBeLessThan(0);
      expect(to).toBeGreaterThan(0);
      expect(note).toBeNull();
    }
  });

  test.each(SCALES.filter((scale) => scale < 1e-3))(
    'scaled with E and the radius, where the tip of d is left out: %d',
    (scale) => {
      const [one, other] = [windowWith(scale, 3 * scale), windowWith(2 * scale, 6 * scale)];
      expect(other.from / one.from).toBeCloseTo(2, 9);
      expect(other.to / one.to).toBeCloseTo(2, 9);
    },
  );

  test('two roots far away and close together are looked at alone, which is said', () => {
    const { from, to, note } = windowWith(1000, 1002);
    expect([from, to]).toEqual([998.8, 1003.2]);
    expect(note).toBe('E, at t = 0, is far to the left');
    expect(windowWith(-1002, -1000).note).toBe('E, at t = 0, is far to the right');
  });

  test('closer than a pixel they are shown with E, and that is said', () => {
    const { from, to, note } = windowWith(1e6, 1e6 + 1);
    expect(from).toBeLessThan(0);
    expect(to).toBeGreaterThan(1e6);
    expect(note).toBe('t₁ and t₂ lie too close together to be told apart here');
  });

  test('a root that is a thousand times nearer than the other one is shown with E, alone', () => {
    const far = windowWith(2, 2e9);
    expect(far.note).toBe('t₂ is far to the right');
    expect(far.to).toBeLessThan(4);
    const left = windowWith(-2e9, 2);
    expect(left.note).toBe('t₁ is far to the left');
    expect(left.from).toBeGreaterThan(-4);
  });

  test('a line that misses is shown to where it is nearest, unless that is far off', () => {
    const miss = (x: number) =>
      graphWindowOf(
        intersect(
          { kind: 'cylinder', center: [0, 0, 0], radius: 1 },
          { origin: [x, 0, 2], direction: [-1, 0, 0] },
          'exact',
        ),
      );
    expect(miss(40).to).toBeGreaterThan(40);
    expect(miss(400).to).toBeLessThan(2);
  });
});
