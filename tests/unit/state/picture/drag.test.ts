import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../../../src/math/index.ts';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import {
  arrowMove,
  arrowStep,
  type CameraFrame,
  DRAG_PLANES,
  dragged,
  movedFrom,
  projectedPoint,
  rayThrough,
} from '../../../../src/state/picture/drag.ts';
import { refusalOf } from '../../../../src/state/picture/edits.ts';
import { cameraAxes } from '../../../../src/tracer/camera.ts';

const SIZE = { width: 320, height: 180 };
const within = (min: number, max: number) => fc.double({ min, max, noNaN: true });
const at = fc.tuple(within(5, 315), within(5, 175));
const point = (): fc.Arbitrary<Vec3> => fc.tuple(within(-6, 6), within(-6, 6), within(-6, 6));
const frame = fc
  .record({ eye: point(), target: point(), angle: within(10, 90) })
  .filter(({ eye, target }) => Math.hypot(...eye.map((x, i) => x - (target[i] as number))) > 1)
  .map((camera): CameraFrame => ({ ...cameraAxes(camera, 16 / 9), ...SIZE }));
const along = fc.constantFrom(...DRAG_PLANES);
const plus = (p: Vec3, by: Vec3, s = 1): Vec3 => [
  p[0] + s * by[0],
  p[1] + s * by[1],
  p[2] + s * by[2],
];

describe('a drag', () => {
  test('keeps to its plane, whatever the camera', () => {
    fc.assert(
      fc.property(frame, point(), at, at, along, (camera, p, from, to, which) => {
        const by = dragged(camera, p, from, to, which);
        expect(by.every(Number.isFinite)).toBe(true);
        if (which === 'floor') expect(by[1]).toBe(0);
        else {
          const [x, z] = [camera.ahead[0], camera.ahead[2]];
          const off = Math.abs(by[0] * x + by[2] * z);
          // Coordinates are rounded to a grid below a pixel.
          expect(off).toBeLessThanOrEqual(0.02 * Math.hypot(...by) + 0.2);
        }
      }),
    );
  });

  test('moves nothing where the pointer has come back', () => {
    fc.assert(
      fc.property(frame, point(), at, along, (camera, p, from, which) => {
        expect(dragged(camera, p, from, from, which)).toEqual([0, 0, 0]);
      }),
    );
  });

  test('keeps what is held under the pointer, where its plane is seen there', () => {
    let followed = 0;
    fc.assert(
      fc.property(frame, at, at, along, (camera, from, to, which) => {
        const depth = 5;
        const held = plus(camera.eye, rayThrough(camera, from), depth);
        const spot = projectedPoint(camera, plus(held, dragged(camera, held, from, to, which)));
        const way = rayThrough(camera, to);
        const normal: Vec3 = which === 'floor' ? [0, 1, 0] : [camera.ahead[0], 0, camera.ahead[2]];
        const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        const rate = dot(way, normal) / Math.hypot(...normal);
        const height = (dot(held, normal) - dot(camera.eye, normal)) / Math.hypot(...normal);
        const t = height / rate;
        if (!(t > 0.5 && t < 7.5 * depth && Math.abs(rate) > 0.1)) return;
        followed += 1;
        expect(Math.hypot(spot.x - to[0], spot.y - to[1])).toBeLessThan(12);
      }),
    );
    expect(followed).toBeGreaterThan(20);
  });
});

test('arrow keys move along axes of the world, there and back', () => {
  fc.assert(
    fc.property(frame, along, (camera, which) => {
      const move = (key: string) => arrowMove(camera, key, 0.5, which) as Vec3;
      for (const [one, other] of [
        ['ArrowLeft', 'ArrowRight'],
        ['ArrowUp', 'ArrowDown'],
        ['PageUp', 'PageDown'],
      ] as const) {
        expect(move(one).filter((x) => x !== 0)).toHaveLength(1);
        expect(plus(move(one), move(other))).toEqual([0, 0, 0]);
      }
      const all = ['ArrowRight', 'ArrowUp', 'PageUp'].map((key) => move(key));
      expect(all.reduce((sum, by) => plus(sum, by.map(Math.abs) as never), [0, 0, 0])).toEqual([
        ...[0.5, 0.5, 0.5],
      ]);
      expect(arrowMove(camera, 'a', 1, which)).toBeNull();
    }),
  );
});

test('things and lights of every scene are moved, with their heights, and stay in order', () => {
  for (const { scene } of PRESETS) {
    for (const { id } of [...scene.things, ...scene.lights]) {
      const step = arrowStep(scene, id, false);
      const moved = movedFrom(scene, id, [step, 0, -step])(scene);
      // Hills a million million times as large are moved by nothing.
      if (!id.endsWith('hill')) expect(moved).not.toEqual(scene);
      expect(refusalOf(moved)).toBeNull();
      // From where it was taken: a second one does not add up.
      expect(movedFrom(scene, id, [step, 0, -step])(moved)).toEqual(moved);
      const back = movedFrom(moved, id, [-step, 0, step])(moved);
      expect(JSON.stringify(back).length).toBeLessThan(JSON.stringify(scene).length + 60);
    }
  }
});

test('a step turns the sun of every scene by a few degrees', () => {
  for (const { scene } of PRESETS) {
    for (const light of scene.lights) {
      if (light.light !== 'sun') continue;
      const turn = arrowStep(scene, light.id, false) / Math.hypot(...light.towards);
      expect.soft(Math.abs(turn - 1 / 30), scene.title).toBeLessThan(1 / 60);
    }
  }
});
