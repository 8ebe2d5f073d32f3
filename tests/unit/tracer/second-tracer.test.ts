import { expect, test } from 'vitest';
import { PRESETS } from '../../../src/scene/presets/index.ts';
import { secondPicture } from './second-tracer.ts';
import { picture } from './tracing.ts';

/** Those that the second tracer has formulas for: lights without size, and nothing far away. */
const plain = PRESETS.filter(({ scene: { lights, camera, effects } }) => {
  const near = Math.hypot(...camera.eye) < 1000;
  return near && !effects && lights.every(({ light }) => light !== 'sphere');
});

test.each(plain)('$id by a second, plain tracer: the same to the last level', async ({ scene }) => {
  const { rgba } = await picture(scene, { width: 96, height: 54 });
  const first = [...rgba].filter((_, k) => k % 4 !== 3);
  const second = secondPicture(scene, 96, 54);
  const apart = first.flatMap((x, k) => (x === second[k] ? [] : [[k, x, second[k]]]));
  expect(apart).toEqual([]);
});
