import { expect, test } from 'vitest';
import { PRESETS } from '../../../src/scene/presets/index.ts';
import { secondPicture } from './second-tracer.ts';
import { picture } from './tracing.ts';

const SIZE = { width: 96, height: 54, lightSamples: 4 };

test.each(PRESETS)(
  '$id by a second, plain tracer: the same to the last level',
  async ({ scene }) => {
    const { rgba } = await picture(scene, SIZE);
    const first = [...rgba].filter((_, k) => k % 4 !== 3);
    const second = secondPicture(scene, SIZE.width, SIZE.height, Math.sqrt(SIZE.lightSamples));
    const apart = first.flatMap((x, k) => (x === second[k] ? [] : [[k, x, second[k]]]));
    const why = `${apart.length} values differ: second-tracer.ts has to know each effect`;
    expect(apart.slice(0, 5), why).toEqual([]);
  },
);
