import { describe, expect, test } from 'vitest';
import { InvalidInput } from '../../../src/math/invalid-input.ts';
import { addThing, changeThing, remove } from '../../../src/scene/edit.ts';
import { sceneFromJson, sceneToJson } from '../../../src/scene/json.ts';
import { everything } from '../../../src/scene/presets/everything.ts';
import { PRESETS } from '../../../src/scene/presets/index.ts';
import { validateScene } from '../../../src/scene/validate.ts';

describe('presets', () => {
  test('each has an id and a reason of its own', () => {
    expect(new Set(PRESETS.map(({ id }) => id)).size).toBe(PRESETS.length);
    expect(new Set(PRESETS.map(({ reason }) => reason)).size).toBe(PRESETS.length);
  });

  test.each(PRESETS)('$id comes back from its file as it was', ({ scene }) => {
    expect(sceneFromJson(sceneToJson(scene))).toEqual(scene);
    expect(validateScene(scene)).toEqual(scene);
  });
});

test('minus zero survives the file', () => {
  const scene = { ...everything.scene, camera: { eye: [-0, 1, 5], target: [0, 0, 0], angle: 30 } };
  const [x] = sceneFromJson(sceneToJson(validateScene(scene))).camera.eye;
  expect(Object.is(x, -0)).toBe(true);
});

type Loose = { [key: string]: unknown };
/** A valid scene with one change. */
function broken(change: (scene: Loose) => void): unknown {
  const scene = structuredClone(everything.scene) as unknown as Loose;
  change(scene);
  return scene;
}
const thing = (scene: Loose, k: number): Loose => (scene.things as Loose[])[k] as Loose;

describe('what is wrong is said, with where and what it was', () => {
  test.each<[string, (scene: Loose) => void]>([
    [
      'things[0].material.mirror must be a number from 0 to 1, got 2',
      (s) => {
        (thing(s, 0).material as Loose).mirror = 2;
      },
    ],
    [
      "things[1].material.paint.colour must be a colour like '#8a5cc2', got 'red'",
      (s) => {
        ((thing(s, 1).material as Loose).paint as Loose).colour = 'red';
      },
    ],
    [
      "things[2].shape: unknown shape 'torus'",
      (s) => {
        thing(s, 2).shape = { kind: 'torus' };
      },
    ],
    [
      'things[3].shape: radius must be ≥ 0, got -1',
      (s) => {
        (thing(s, 3).shape as Loose).radius = -1;
      },
    ],
    [
      "things[3].shape: 'colour' means nothing for a cylinder, which has center, radius",
      (s) => {
        (thing(s, 3).shape as Loose).colour = '#ffffff';
      },
    ],
    [
      'things[2].between must go up, got (3, 1)',
      (s) => {
        thing(s, 2).between = [3, 1];
      },
    ],
    [
      "'hidden' means nothing in things[4]",
      (s) => {
        thing(s, 4).hidden = true;
      },
    ],
    [
      "lights[0].light must be point, sun, sphere, got 'laser'",
      (s) => {
        (s.lights as Loose[])[0] = { light: 'laser' };
      },
    ],
    [
      "two things are called 'mirror'",
      (s) => {
        thing(s, 0).id = 'mirror';
      },
    ],
    [
      'camera.eye.y must be a number from -1000000000000 to 1000000000000, got NaN',
      (s) => {
        s.camera = { eye: [0, Number.NaN, 1], target: [0, 0, 0], angle: 30 };
      },
    ],
    [
      'camera.target must not be the eye, got (1, 2, 3)',
      (s) => {
        s.camera = { eye: [1, 2, 3], target: [1, 2, 3], angle: 30 };
      },
    ],
    [
      'things may have at most 250 entries, got 251',
      (s) => {
        s.things = Array.from({ length: 251 }, () => 0);
      },
    ],
    [
      'ambient is missing',
      (s) => {
        delete s.ambient;
      },
    ],
  ])('%s', (message, change) => {
    const scene = broken(change);
    expect(() => validateScene(scene)).toThrow(InvalidInput);
    expect(() => validateScene(scene)).toThrow(message);
  });

  test.each<[unknown, string]>([
    [null, 'a scene is missing'],
    [[], 'a scene must be an object, got ()'],
    ['x', "a scene must be an object, got 'x'"],
  ])('%j', (value, message) => {
    expect(() => validateScene(value)).toThrow(message);
  });

  test('text that is not JSON, and a file that is too long', () => {
    expect(() => sceneFromJson('{"a":')).toThrow(
      `line 1, column 6: the text ends too early, after '{"a":'`,
    );
    expect(() => sceneFromJson(' '.repeat(400_001))).toThrow('at most 400000 characters');
    expect(() => sceneFromJson('{"graze":"scene"}')).toThrow(InvalidInput);
  });

  test('nothing of a prototype gets in', () => {
    const text = sceneToJson(everything.scene).replace('"title"', '"__proto__": {"x": 1}, "title"');
    expect(() => sceneFromJson(text)).toThrow("'__proto__' means nothing in a scene");
  });
});

test('edits leave what they do not touch', () => {
  const { scene } = everything;
  const again = scene.things.map((thing) => ({ ...thing, id: `${thing.id} again` }));
  const more = again.reduce(addThing, scene);
  expect(more.things.slice(0, again.length)).toEqual(scene.things);
  expect(() => validateScene(more)).not.toThrow();
  expect(remove(more, 'disc again').things).toHaveLength(more.things.length - 1);
  expect(remove(scene, 'sun').lights).toHaveLength(1);
  const moved = changeThing(scene, 'mirror', (thing) => ({ ...thing, capped: true }));
  expect(moved.things[0]).toBe(scene.things[0]);
  expect(moved.things[1]).toEqual({ ...scene.things[1], capped: true });
});
