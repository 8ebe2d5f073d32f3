import fc from 'fast-check';
import { expect, test } from 'vitest';
import type { createRays } from '../../../src/math/batch.ts';
import { cameraNumbers, pixelNumbers } from '../../../src/scene/camera-ray.ts';
import { PRESETS } from '../../../src/scene/presets/index.ts';
import type { Camera } from '../../../src/scene/types.ts';
import { cameraAxes, fireCamera } from '../../../src/tracer/camera.ts';
import { createWave } from '../../../src/tracer/wave.ts';
import { TINY } from './tracing.ts';

/* The rays that are traced are those that the page writes down: every pixel's, bit for bit. */

function apart(camera: Camera, width: number, height: number, samples: number): unknown[] {
  const pixels = Array.from({ length: width * height }, (_, k) => k);
  const wave = createWave(pixels.length * samples);
  fireCamera(cameraAxes(camera, width / height), { ...TINY, width, height, samples }, pixels, wave);
  const { Ex, Ey, Ez, dx, dy, dz } = wave.rays as ReturnType<typeof createRays>;
  const common = cameraNumbers(camera, width, height);
  return pixels.flatMap((pixel) =>
    Array.from({ length: samples }, (_, s) => {
      const place = [pixel % width, Math.floor(pixel / width)] as const;
      const { E, d } = pixelNumbers(common, place, s, samples).vectors;
      const k = pixel * samples + s;
      const fired = [Ex[k], Ey[k], Ez[k], dx[k], dy[k], dz[k]];
      const written = [...(E ?? []), ...(d ?? [])];
      return fired.every((x, at) => x === written[at]) ? [] : [{ pixel, s, fired, written }];
    }).flat(),
  );
}

test.each(PRESETS)('$id: every pixel, one ray and four', ({ scene: { camera } }) => {
  expect(apart(camera, 48, 27, 1)).toEqual([]);
  expect(apart(camera, 32, 18, 4)).toEqual([]);
});

test('any camera and size, also straight down, from very far and very near', () => {
  const coordinate = fc.oneof(
    fc.constantFrom(0, 1, -1),
    fc.double({ min: -10, max: 10, noNaN: true }),
    fc.double({ min: -1e300, max: 1e300, noNaN: true }),
    fc.double({ min: -1e-300, max: 1e-300, noNaN: true }),
  );
  const point = fc.tuple(coordinate, coordinate, coordinate);
  const size = fc.integer({ min: 1, max: 5 });
  const angle = fc.double({ min: 0.000001, max: 170, noNaN: true });
  fc.assert(
    fc.property(point, point, angle, size, size, (eye, target, degrees, width, height) => {
      fc.pre(eye.some((x, k) => x !== target[k]));
      const camera = { eye, target, angle: degrees };
      expect(apart(camera, width, height, 9)).toEqual([]);
      const { g = [0, 0, 0] } = cameraNumbers(camera, width, height).vectors;
      expect(Math.hypot(...g)).toBeCloseTo(1, 14);
    }),
  );
});
