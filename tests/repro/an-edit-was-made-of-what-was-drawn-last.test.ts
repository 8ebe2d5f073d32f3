import { expect, test } from 'vitest';
import { SHAPES } from '../../src/math/index.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { pictureActions } from '../../src/pages/picture/page-actions.ts';
import { rayHandles, shapeHandles } from '../../src/panels/params-of.ts';
import { addThing, changeThing } from '../../src/scene/edit.ts';
import { EFFECTS } from '../../src/scene/effects/index.ts';
import type { Scene } from '../../src/scene/types.ts';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { newThing, withParam } from '../../src/state/picture/edits.ts';
import { pictureSettings } from '../../src/state/picture/settings.ts';
import { INITIAL, paramValue, shapeOf } from '../../src/state/state.ts';
import { createStore } from '../../src/state/store.ts';

/*
 * Two controls were moved within one frame: the first edit was lost, since the second one carried
 * everything as it was drawn.
 */

const onPicture = () => {
  const store = createStore({ ...INITIAL, page: 'picture' });
  const now = () => pictureSettings(store.get().settings.picture);
  return { now, tools: pictureActions(store.dispatch) };
};

test('a square is added, and its side and its mirror are set at once', () => {
  const { now, tools } = onPicture();
  const edit =
    (what: (thing: Scene['things'][number]) => Scene['things'][number]) => (scene: Scene) =>
      changeThing(scene, 'square', what);
  const side = SHAPES.find(({ kind }) => kind === 'square')?.params.find(
    ({ key }) => key === 'side',
  );
  if (!side) throw new Error('no side');
  tools.scene((scene) => addThing(scene, newThing(scene, 'square')));
  tools.scene(edit((thing) => withParam(thing, side, 1.25)));
  tools.scene(edit((thing) => ({ ...thing, material: { ...thing.material, mirror: 0.5 } })));
  const square = now().scene.things.find(({ id }) => id === 'square');
  expect(square).toMatchObject({ shape: { side: 1.25 }, material: { mirror: 0.5 } });
});

test('an edit that is refused leaves the one before it', () => {
  const { now, tools } = onPicture();
  tools.scene((scene) => ({ ...scene, ambient: 0.5 }));
  tools.scene((scene) => ({ ...scene, camera: { ...scene.camera, angle: 1000 } }));
  expect(now().scene.ambient).toBe(0.5);
});

test('every effect is forced off, and the divider goes two steps', () => {
  const { now, tools } = onPicture();
  for (const { id } of EFFECTS) tools.force(id, 'off');
  const step = () => tools.edit(({ split }) => ({ split: String(split + 5) }));
  step();
  step();
  expect(Object.keys(now().forced)).toHaveLength(EFFECTS.length);
  expect(now().split).toBe(60);
});

test.each(SHAPES.map(({ kind }) => kind))(
  '%s: every component of every vector, in one frame',
  (kind) => {
    const store = createStore({ ...INITIAL, kind });
    // Made of one drawing of the page, and used until the end.
    const drawn = createDerive(() => exploreDetails)(store.get());
    const handles = [...rayHandles(drawn, store.dispatch), ...shapeHandles(drawn, store.dispatch)];
    const vectors = handles.filter(({ param }) => param.type === 'vector');
    const wanted = (i: number): number => 0.25 + i;
    for (const { send } of vectors) {
      for (const axis of [0, 1, 2]) {
        send((now) => (now as Vec3).map((x, i) => (i === axis ? wanted(i) : x)) as unknown as Vec3);
      }
    }
    const { E, d } = store.get();
    const shape = shapeOf(store.get());
    const own = vectors.slice(2).map(({ param }) => paramValue(shape, param.key));
    for (const vector of [E, d, ...own]) expect(vector).toEqual([0.25, 1.25, 2.25]);
  },
);
