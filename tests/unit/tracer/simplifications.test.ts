import { describe, expect, test } from 'vitest';
import { PRESETS } from '../../../src/scene/presets/index.ts';
import { SIMPLIFICATIONS } from '../../../src/scene/simplifications.ts';
import type { Light, Material, Scene } from '../../../src/scene/types.ts';
import { samePicture } from './tracing.ts';

/*
 * Whether what is left out would show in a scene: where it would, a change of the numbers that
 * stand for it changes the picture, and where it would not, none does.
 */

const SIZE = { width: 40, height: 22 };

const shows = (title: string, scene: Scene): string => {
  const found = SIMPLIFICATIONS.find((one) => one.title === title);
  if (!found) throw new Error(title);
  return found.shows(scene);
};

const withMaterials = (scene: Scene, change: (material: Material) => Material): Scene => ({
  ...scene,
  things: scene.things.map((thing) => ({ ...thing, material: change(thing.material) })),
});

/** Blue is bent more than red, by a few per cent. */
const bent = (scene: Scene): Scene =>
  withMaterials(scene, ({ glass, ...rest }) =>
    glass ? { ...rest, glass: { ...glass, index: 1 + (glass.index - 1) * 1.05 } } : rest,
  );

const dimmer = (scene: Scene): Scene =>
  withMaterials(scene, (material) => ({
    ...material,
    mirror: material.mirror < 1 ? material.mirror * 0.8 : 1,
  }));

/** Points become spheres; suns stay, since no sun has a size here. */
const wide = (scene: Scene): Scene => ({
  ...scene,
  lights: scene.lights.map((light): Light => {
    if (light.light !== 'point') return light;
    const far = Math.hypot(...light.at.map((x, k) => x - (scene.camera.target[k] ?? 0)));
    return { ...light, light: 'sphere', radius: far / 4 };
  }),
});

const brighter = (scene: Scene): Scene => ({ ...scene, ambient: scene.ambient + 0.05 });

const CHANGES: readonly (readonly [title: string, change: (scene: Scene) => Scene])[] = [
  ['dispersion', bent],
  ['mirrors', dimmer],
  ['light from the background', brighter],
];

describe.each(PRESETS)('$id', ({ scene }) => {
  test.each(CHANGES)('%s would show where its numbers count', async (title, change) => {
    const [before, after] = await Promise.all(
      [scene, change(scene)].map((one) => samePicture(one, SIZE)),
    );
    const differs = before?.rgba.some((x, k) => x !== after?.rgba[k]);
    expect(differs).toBe(shows(title, scene) === 'yes');
  });

  test('lights without a size: where it would not show, a size changes nothing', async () => {
    const [before, after] = await Promise.all(
      [scene, wide(scene)].map((one) => samePicture(one, SIZE)),
    );
    const differs = before?.rgba.some((x, k) => x !== after?.rgba[k]);
    const suns = scene.lights.every(({ light }) => light !== 'point');
    expect(differs).toBe(shows('lights without a size', scene) === 'yes' && !suns);
  });

  test('rays that are left out, and light that is cut off, only where they may be', async () => {
    const { ledger, rgba } = await samePicture(scene, SIZE);
    if (shows('weak rays', scene) === 'no') expect(ledger.saved).toBe(0);
    if (shows('endless reflections', scene) === 'no') expect(ledger.cut).toBe(0);
    const white = rgba.some((x, k) => k % 4 !== 3 && x === 255);
    if (shows('more light than white', scene) === 'no') expect(white).toBe(false);
  });

  test('each is told in one of three words; in an empty scene but a lamp could be seen', () => {
    const empty: Scene = { ...scene, things: [] };
    for (const one of SIMPLIFICATIONS) {
      expect(['yes', 'perhaps', 'no']).toContain(one.shows(scene));
      if (one.title === 'lamps themselves') continue;
      expect([one.title, one.shows(empty)]).toEqual([one.title, 'no']);
    }
  });
});
