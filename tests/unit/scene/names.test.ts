import { describe, expect, test } from 'vitest';
import { SHAPES, type Shape } from '../../../src/math/index.ts';
import { addThing, changeThing } from '../../../src/scene/edit.ts';
import { nameIn, wordFor } from '../../../src/scene/names.ts';
import { PRESETS } from '../../../src/scene/presets/index.ts';
import { GREY, type Scene } from '../../../src/scene/types.ts';
import { newThing, thingWords } from '../../../src/state/picture/edits.ts';

const named = (scene: Scene): string[] =>
  [...scene.things, ...scene.lights].map(({ id }) => nameIn(scene, id));

const [{ scene: FIRST }] = PRESETS as readonly [(typeof PRESETS)[number]];
const EMPTY: Scene = { ...FIRST, things: [] };
const round = (flare: number): Shape => ({
  ...{ kind: 'hyperboloid', center: [0, 1, 0] },
  ...{ flare, radius: 1 },
});
const holding = (...things: readonly (readonly [id: string, shape: Shape])[]): Scene => ({
  ...EMPTY,
  things: things.map(([id, shape]) => ({ id, shape, material: GREY })),
});

describe('a thing is called what it is', () => {
  test('in every scene that comes with Graze, as it is named there', () => {
    for (const { scene } of PRESETS) {
      expect(named(scene)).toEqual([...scene.things, ...scene.lights].map(({ id }) => id));
      for (const thing of scene.things) {
        const last = thing.id.replace(/ \d+$/, '').split(' ').at(-1) ?? '';
        const isWord = SHAPES.some(({ kind }) => kind === last) || last === 'ball';
        if (isWord) expect([scene.title, last]).toEqual([scene.title, wordFor(thing.shape)]);
      }
    }
  });

  test('a sphere is a ball, by whatever formula, and the second one has a number', () => {
    expect(wordFor({ kind: 'sphere', center: [0, 0, 0], radius: 1 })).toBe('ball');
    expect(wordFor(round(-1))).toBe('ball');
    const scene = holding(['hyperboloid', round(-1)], ['hyperboloid 2', round(-1)]);
    expect(named(scene).slice(0, 2)).toEqual(['ball', 'ball 2']);
    expect(newThing(scene, 'sphere').id).toBe('ball 3');
  });

  test('also after its shape has changed; no two have one name', () => {
    const added = addThing(EMPTY, newThing(EMPTY, 'hyperboloid'));
    const { id } = added.things[0] ?? { id: '' };
    const as = (flare: number) =>
      changeThing(added, id, (thing) => ({ ...thing, shape: round(flare) }));
    expect([1, -1, -0.5].map((flare) => nameIn(as(flare), id))).toEqual([
      ...['hyperboloid', 'ball', 'ellipsoid'],
    ]);
    const crossed = holding(
      ['ball', round(0.5)],
      ['hyperboloid', round(-1)],
      ['ball 2', round(-1)],
    );
    const names = named(crossed);
    expect(new Set(names).size).toBe(names.length);
    expect(names.slice(0, 3)).toEqual(['hyperboloid', 'ball', 'ball 2']);
  });

  test('a name that somebody gave stays', () => {
    const scene = holding(['moon', round(-1)], ['my cone', round(0.5)]);
    expect(named(scene).slice(0, 2)).toEqual(['moon', 'my cone']);
    expect(thingWords(scene, scene.things[0] as (typeof scene.things)[number])).toBe('sphere');
  });

  test('new things of every kind have names of their own, which say their shape', () => {
    for (const { scene } of PRESETS) {
      for (const { kind } of SHAPES) {
        const thing = newThing(scene, kind);
        const next = addThing(scene, thing);
        expect(nameIn(next, thing.id)).toBe(thing.id);
        expect(thing.id.replace(/ \d+$/, '')).toBe(wordFor(thing.shape));
        expect(thingWords(next, thing)).toBe('');
        expect(named(next).filter((name) => name === thing.id)).toHaveLength(1);
      }
    }
  });
});
