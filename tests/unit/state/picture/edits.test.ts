import { describe, expect, test } from 'vitest';
import { SHAPES } from '../../../../src/math/index.ts';
import { definitionOf } from '../../../../src/math/shapes.ts';
import { addLight, addThing } from '../../../../src/scene/edit.ts';
import { sceneFromJson, sceneToJson } from '../../../../src/scene/json.ts';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import type { Light, Thing } from '../../../../src/scene/types.ts';
import { validateScene } from '../../../../src/scene/validate.ts';
import {
  asLight,
  canBeCapped,
  LIGHT_KINDS,
  materialWords,
  newLight,
  newThing,
  refusalOf,
  withGlass,
  withHeights,
  withParam,
  withPattern,
} from '../../../../src/state/picture/edits.ts';

const CONE: Thing = {
  id: 'cone',
  shape: { kind: 'cone', vertex: [1, 2, 3], slope: 0.5 },
  material: {
    paint: { pattern: 'plain', colour: '#123456' },
    shine: { strength: 0, exponent: 20 },
    mirror: 0,
  },
  between: [0, 2],
  capped: true,
};
const param = (thing: Thing, key: string) => {
  const found = definitionOf(thing.shape).params.find((p) => p.key === key);
  if (!found) throw new Error(key);
  return found;
};

/** What would be added, of every kind. Looking for room takes most of the time here. */
const ADDED = PRESETS.map(({ id, scene }) => ({
  ...{ id, scene },
  things: SHAPES.map(({ kind }) => newThing(scene, kind)),
}));

describe('what is added', () => {
  test.each(ADDED)('fits into $id', ({ scene, things }) => {
    const lights = LIGHT_KINDS.map((kind) => newLight(scene, kind));
    let next = scene;
    for (const thing of things) next = addThing(next, { ...thing, id: `new ${thing.id}` });
    for (const [i, light] of lights.entries()) next = addLight(next, { ...light, id: `new ${i}` });
    expect(sceneFromJson(sceneToJson(next))).toEqual(next);
  });

  test('is whole where it ends by itself: only what goes on for ever is cut off', () => {
    for (const { shape, between } of ADDED.flatMap(({ things }) => things)) {
      const ends = definitionOf(shape).body().box(shape, null) !== null;
      if (ends) expect([shape.kind, between]).toEqual([shape.kind, undefined]);
    }
  });

  test('is called something that nothing else is called', () => {
    for (const { scene, things } of ADDED) {
      const ids = [...scene.things, ...scene.lights].map(({ id }) => id);
      for (const { id } of things) expect(ids).not.toContain(id);
      for (const kind of LIGHT_KINDS) expect(ids).not.toContain(newLight(scene, kind).id);
    }
  });
});

describe('a thing', () => {
  test('that is moved takes its heights along', () => {
    const moved = withParam(CONE, param(CONE, 'vertex'), [5, 2.5, 3]);
    expect(moved.shape).toEqual({ kind: 'cone', vertex: [5, 2.5, 3], slope: 0.5 });
    expect(moved.between).toEqual([0.5, 2.5]);
  });

  test('moved to the side keeps them, and so does another slope', () => {
    expect(withParam(CONE, param(CONE, 'vertex'), [5, 2, 0]).between).toBe(CONE.between);
    expect(withParam(CONE, param(CONE, 'slope'), 2).between).toBe(CONE.between);
  });

  test('a normal is no place', () => {
    const circle: Thing = {
      ...CONE,
      shape: { kind: 'circle', normal: [0, 1, 0], center: [0, 0, 0], radius: 1 },
    };
    expect(withParam(circle, param(circle, 'normal'), [0, 5, 0]).between).toEqual([0, 2]);
    expect(withParam(circle, param(circle, 'center'), [0, 5, 0]).between).toEqual([5, 7]);
  });

  test('cut off about where it is, and whole again', () => {
    const whole = withHeights(CONE, false);
    expect(Object.keys(whole).toSorted()).toEqual(['id', 'material', 'shape']);
    const cut = withHeights(whole, true);
    const [low = 0, high = 0] = cut.between ?? [];
    expect(low).toBeLessThan(2);
    expect(high).toBeGreaterThan(2);
    expect(cut.capped).toBe(true);
  });

  test('round shapes have ends to close, flat ones have none', () => {
    const [{ scene }] = PRESETS as readonly [(typeof PRESETS)[number]];
    const capped = SHAPES.filter(({ kind }) => canBeCapped(newThing(scene, kind).shape));
    expect(capped.map(({ kind }) => kind)).toEqual(expect.arrayContaining(['cylinder', 'cone']));
    const families = capped.map(({ kind }) => {
      const { shape } = newThing(scene, kind);
      return definitionOf(shape).formula(shape).family;
    });
    expect(new Set(families)).toEqual(new Set(['curved']));
  });

  test('keeps its colours from pattern to pattern', () => {
    const checker = withPattern(CONE.material, 'checker');
    expect(checker.paint).toMatchObject({ pattern: 'checker', colour: '#123456' });
    const other = {
      ...checker,
      paint: { ...checker.paint, other: '#abcdef', size: 3 },
    } as typeof checker;
    expect(withPattern(other, 'stripes').paint).toEqual({
      ...{ pattern: 'stripes', colour: '#123456', other: '#abcdef' },
      ...{ size: 3, axis: 'y' },
    });
    expect(withPattern(other, 'plain').paint).toEqual({ pattern: 'plain', colour: '#123456' });
  });

  test('glass on and off', () => {
    const glass = withGlass(CONE.material, true);
    expect(materialWords(glass)).toBe('glass, index 1.5');
    expect(withGlass(glass, false)).toEqual(CONE.material);
    expect(materialWords({ ...CONE.material, mirror: 0.25 })).toBe('mirror, 25 %');
  });
});

test('a light of every kind becomes one of every other, and keeps its colour', () => {
  const scene = PRESETS[0]?.scene;
  if (!scene) throw new Error('no scene');
  for (const from of LIGHT_KINDS) {
    for (const to of LIGHT_KINDS) {
      const before: Light = { ...newLight(scene, from), colour: '#112233', strength: 0.7 };
      const after = asLight(before, to, scene.camera.target);
      expect(after).toMatchObject({ light: to, id: before.id, colour: '#112233', strength: 0.7 });
      if (from === to) expect(after).toEqual(before);
      const bare = { ...scene, lights: [after] };
      expect(validateScene(JSON.parse(JSON.stringify(bare)))).toEqual(bare);
    }
  }
});

test('a lamp at the target becomes a sun from above, not from nowhere', () => {
  const lamp: Light = { light: 'point', id: 'l', colour: '#ffffff', strength: 1, at: [1, 2, 3] };
  expect(asLight(lamp, 'sun', [1, 2, 3])).toMatchObject({ towards: [0, 1, 0] });
});

test.each([
  [{ ambient: 7 }, 'ambient must be a number from 0 to 1, got 7'],
  [{ things: [{ ...CONE, between: [2, 1] as const }] }, 'between must go up, got (2, 1)'],
  [
    { things: [{ ...CONE, material: { ...CONE.material, mirror: 2 } }] },
    'mirror must be a number from 0 to 1, got 2',
  ],
])('%o is refused without its path', (change, words) => {
  const scene = PRESETS[0]?.scene;
  if (!scene) throw new Error('no scene');
  expect(refusalOf({ ...scene, ...change })).toBe(words);
  expect(refusalOf(scene)).toBeNull();
});
