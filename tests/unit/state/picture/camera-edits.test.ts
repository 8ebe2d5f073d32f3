import { describe, expect, test } from 'vitest';
import { seeded } from '../../../../src/math/rng.ts';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import type { Camera } from '../../../../src/scene/types.ts';
import { nearer, onGrid, shifted, turned } from '../../../../src/state/picture/camera-edits.ts';
import { cameraAxes } from '../../../../src/tracer/camera.ts';

const distance = ({ eye, target }: Camera): number =>
  Math.hypot(eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]);

/** Where a camera sees a point, in halves of the picture's height from its middle. */
function seen(camera: Camera, point: readonly number[]): readonly [number, number] {
  const { eye, ahead, right, up } = cameraAxes(camera, 1);
  const way = point.map((x, i) => x - (eye[i] ?? 0));
  const dot = (v: readonly number[]): number => way.reduce((sum, x, i) => sum + x * (v[i] ?? 0), 0);
  const half = Math.tan((camera.angle * Math.PI) / 360);
  return [dot(right) / dot(ahead) / half ** 2, dot(up) / dot(ahead) / half ** 2];
}

describe.each(PRESETS)('the camera of $id in the hand', ({ scene: { camera } }) => {
  const random = seeded(7);
  const some = Array.from({ length: 20 }, () => 4 * random() - 2);

  test('turns about its target, at its distance, never beyond the poles', () => {
    for (const by of some) {
      const now = turned(by, some[0] ?? 0)(turned(0, by)(camera));
      expect(now.target).toEqual(camera.target);
      expect(distance(now) / distance(camera)).toBeCloseTo(1, 12);
      expect(now.eye[0] !== now.target[0] || now.eye[2] !== now.target[2]).toBe(true);
    }
    const there = turned(0.3, 0.01)(camera);
    const back = turned(-0.3, -0.01)(there);
    expect(back.eye.map((x, i) => (x - (camera.eye[i] ?? 0)) / distance(camera))).toEqual([
      expect.closeTo(0, 9),
      expect.closeTo(0, 9),
      expect.closeTo(0, 9),
    ]);
  });

  test('shifts what is at the target by as much of the picture as the hand', () => {
    for (const by of some) {
      const now = shifted(by / 8, 0.1)(camera);
      const [x, y] = seen(now, camera.target);
      expect(x).toBeCloseTo(-by / 4, 6);
      expect(y).toBeCloseTo(-0.2, 6);
      expect(distance(now) / distance(camera)).toBeCloseTo(1, 9);
    }
  });

  test('comes nearer, and at rest has short coordinates less than a pixel away', () => {
    expect(distance(nearer(0.5)(camera)) / distance(camera)).toBeCloseTo(0.5, 9);
    for (const by of some) {
      const moved = shifted(by / 9, 0)(turned(by, 0.1)(camera));
      const rest = onGrid(moved, 424);
      const [x, y] = seen(rest, moved.target);
      expect(Math.hypot(x, y)).toBeLessThan(2 * (2 / 424));
      expect(onGrid(rest, 424)).toEqual(rest);
    }
  });
});
