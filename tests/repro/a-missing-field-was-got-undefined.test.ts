import { deflateSync, strFromU8, strToU8 } from 'fflate';
import { describe, expect, test } from 'vitest';
import { SHAPES } from '../../src/math/index.ts';
import { sceneFromJson, sceneToJson } from '../../src/scene/json.ts';
import { everything } from '../../src/scene/presets/everything.ts';
import { validateScene } from '../../src/scene/validate.ts';
import { fromFile, toFile } from '../../src/state/file.ts';
import { readPicture } from '../../src/state/picture/settings.ts';
import { INITIAL } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';

/*
 * "things[0].shape must be an object, got undefined": such words are of no message, whatever is
 * missing or put in its place.
 */

type Json = unknown;
const COMPUTER_WORDS = /undefined|null|NaN|\[object/;

/** Every place in a value, as the keys that lead there. */
function placesIn(value: Json, path: readonly string[] = []): (readonly string[])[] {
  if (typeof value !== 'object' || value === null) return [path];
  return [path, ...Object.entries(value).flatMap(([key, one]) => placesIn(one, [...path, key]))];
}

const GONE = Symbol('taken out');
const INSTEAD: readonly Json[] = [
  GONE,
  null,
  {},
  [],
  [null],
  '',
  'x',
  true,
  Infinity,
  -Infinity,
  -1,
];

/** The value with something else at a place. */
function changed(value: Json, [key, ...rest]: readonly string[], to: Json): Json {
  if (key === undefined) return to === GONE ? null : to;
  const copy = (Array.isArray(value) ? [...value] : { ...(value as object) }) as Record<
    string,
    Json
  >;
  if (rest.length === 0 && to === GONE) {
    if (Array.isArray(copy)) copy.splice(Number(key), 1);
    else delete copy[key];
  } else copy[key] = changed(copy[key], rest, to);
  return copy;
}

const messageOf = (run: () => unknown): string => {
  try {
    run();
    return '';
  } catch (error) {
    return (error as Error).message;
  }
};

describe('no refusal speaks of undefined, null or NaN', () => {
  test('scenes: everything taken out, and everything replaced', () => {
    const scene = structuredClone(everything.scene) as Json;
    let refusals = 0;
    for (const path of placesIn(scene)) {
      for (const to of INSTEAD) {
        const message = messageOf(() => validateScene(changed(scene, path, to)));
        expect(message).not.toMatch(COMPUTER_WORDS);
        refusals += message === '' ? 0 : 1;
      }
    }
    expect(refusals).toBeGreaterThan(1000);
  });

  test('what is missing is said to be missing', () => {
    const scene = JSON.parse(sceneToJson(everything.scene)).scene as Json;
    const without = (path: string): string =>
      messageOf(() => validateScene(changed(scene, path.split('.'), GONE)));
    expect(without('things.0.shape')).toBe('things[0].shape is missing');
    expect(without('camera.eye')).toBe('camera.eye is missing');
    expect(without('things.0.shape.kind')).toBe('things[0].shape: kind is missing');
  });

  test('saved states', () => {
    const saved = JSON.parse(toFile({ ...INITIAL, page: 'picture' })) as Json;
    for (const path of placesIn(saved)) {
      for (const to of INSTEAD) {
        const opened = fromFile(JSON.stringify(changed(saved, path, to)) ?? '');
        const messages = opened.ok ? opened.state.problems : [opened.reason];
        for (const message of messages) expect(message).not.toMatch(COMPUTER_WORDS);
      }
    }
  });

  test('links: every key with nothing, too little, too much', () => {
    const keys = SHAPES.flatMap(({ kind, params }) =>
      params.map(({ symbol }) => [kind, symbol] as const),
    );
    const all = [
      ...keys,
      ...['E', 'd', 'unit', 'method', 'view', 't', 'shape'].map((key) => ['cone', key]),
    ];
    for (const [kind, key] of all) {
      for (const value of [
        '',
        ',',
        ',,',
        '1',
        '1,2',
        '1,2,',
        '1,2,3,4',
        'x',
        '0,0,0',
        '1e999',
        '()',
      ]) {
        const { problems } = decode(`#/explore?shape=${kind}&${key}=${value}`, INITIAL);
        for (const problem of problems) expect(problem).not.toMatch(COMPUTER_WORDS);
      }
    }
  });
});

test('a packed scene is not unpacked beyond what a scene may have', () => {
  const bytes = deflateSync(strToU8(' '.repeat(20_000_000)), { level: 9 });
  const letters = btoa(strFromU8(bytes, true)).replace(/\+/g, '-').replace(/\//g, '_');
  expect(letters.length).toBeLessThan(30_000);
  const { problems } = readPicture({ scene: `~${letters}` });
  expect(problems).toEqual(['opened without scene: a packed scene has at most 400000 characters']);
  expect(messageOf(() => sceneFromJson(' '.repeat(400_001)))).toMatch('at most 400000 characters');
});
