import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from 'vitest';
import { FAMILIES, type Question } from '../../../src/math/families.ts';
import { exponentOf } from '../../../src/math/float/bits.ts';
import { type Random, seeded } from '../../../src/math/rng.ts';
import { disagreement, misplaced } from './against-exact.ts';
import { exactHits } from './exact-hits.ts';
import { aimed, inUnits, scaled } from './whole-scenes.ts';

/* Whole scenes in other units: as `npm run fuzz`, a few of them. */

const hard = (k: number, random: Random): Question => {
  const family = FAMILIES()[k % FAMILIES().length] as ReturnType<typeof FAMILIES>[number];
  return scaled(family.make(random), random);
};

test.each<[string, number, number, (k: number, random: Random) => Question]>([
  ['hard rays, near the thresholds of the source', 17, 400, hard],
  ['rays for which C, which cancels, is near one', 18, 400, (_, random) => aimed(random)],
])('%s: class, roots, points and normals (seed %i)', (_, seed, count, make) => {
  const random = seeded(seed);
  for (let k = 0; k < count; k++) {
    const question = make(k, random);
    const { shape, ray } = question;
    const truth = exactHits(shape, ray);
    expect(disagreement(shape, ray, truth)).toBeNull();
    expect(misplaced(question, truth), JSON.stringify(question)).toEqual([]);
  }
});

describe('in other units', () => {
  const cone: Question = {
    shape: { kind: 'cone', vertex: [1, -2, 3], slope: 0.5 },
    ray: { origin: [5, 0.25, 1], direction: [-3, 1, 0.5] },
  };
  test('lengths, d and nothing else are multiplied', () => {
    expect(inUnits(cone, 12, -9)).toEqual({
      shape: { kind: 'cone', vertex: [1024, -2048, 3072], slope: 0.5 },
      ray: { origin: [5120, 256, 1024], direction: [-3 / 1024, 1 / 1024, 0.5 / 1024] },
    });
  });
  test('a number that would leave the doubles stays the largest one, and d stays', () => {
    const { ray } = inUnits(cone, 1023, 1023);
    expect(exponentOf(ray.origin[0])).toBe(1023);
    expect(exponentOf(ray.direction[0])).toBe(1023);
    const tiny: Question = { ...cone, ray: { ...cone.ray, direction: [0, 0, 1] } };
    expect(inUnits(tiny, 0, -1080).ray.direction).toEqual([0, 0, 1]);
  });
});

test('what a stage hands on is its own: no module reads scratch that it does not fill', () => {
  const room = join(import.meta.dirname, '../../../src/math');
  const files = readdirSync(room, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.ts'))
    .map((file) => ({ file, text: readFileSync(join(room, file), 'utf8') }));
  const scratch =
    /^export (?:const|let) (\w+)(?:: [^=]+)? = (?:new \w+Array\(|create[A-Z]\w*\(|\w+Slot\()/gm;
  const shared = files.flatMap(({ file, text }) =>
    [...text.matchAll(scratch)].flatMap(([, name]) => {
      const from = new RegExp(`import [^;]*\\b${name}\\b[^;]*/${file.split('/').at(-1)}'`);
      return files
        .filter((other) => from.test(other.text))
        .map((other) => `${name} in ${other.file}`);
    }),
  );
  expect(shared).toEqual([]);
});
