import { describe, expect, test } from 'vitest';
import { dragTo, thingAt } from '../../../../src/pages/picture/drag-thing.ts';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import { surfacesOf } from '../../../../src/scene/surfaces.ts';
import { picture } from '../../tracer/tracing.ts';

/** The pixel in the middle of what is seen of a thing, or null if it is hardly seen. */
function middleOf(
  thing: number,
  scene: (typeof PRESETS)[number]['scene'],
  seen: Awaited<ReturnType<typeof picture>>,
) {
  const surfaces = surfacesOf(scene);
  const own = [...seen.surface.keys()].filter(
    (i) => surfaces[seen.surface[i] ?? -1]?.thing === thing,
  );
  const mean = (f: (i: number) => number) => own.reduce((sum, i) => sum + f(i), 0) / own.length;
  return own.length < 12
    ? null
    : {
        count: own.length,
        x: mean((i) => i % seen.width),
        y: mean((i) => Math.floor(i / seen.width)),
      };
}

describe('a thing dragged in the picture', () => {
  test('comes along with the pointer', async () => {
    const preset = PRESETS.find(({ id }) => id === 'cone-on-mirror');
    if (!preset) throw new Error('no preset');
    const before = await picture(preset.scene);
    const index = preset.scene.things.findIndex(({ id }) => id === 'ball');
    const at = middleOf(index, preset.scene, before);
    if (!at) throw new Error('not seen');
    const held = thingAt(preset.scene, before, Math.round(at.x), Math.round(at.y));
    expect(held?.id).toBe('ball');
    if (!held) throw new Error('not held');
    const moved = dragTo(held, held.from[0] - 4, held.from[1] - 3)(preset.scene);
    const after = middleOf(index, moved, await picture(moved));
    // Its middle is known to a pixel: it is cut off by what stands before it, and grows as it comes
    // nearer.
    expect(Math.abs((after?.x ?? 0) - at.x + 4)).toBeLessThan(1);
    expect(Math.abs((after?.y ?? 0) - at.y + 3)).toBeLessThan(1);
  });

  test('brought back, the scene is what it was', async () => {
    for (const { scene } of PRESETS) {
      const seen = await picture(scene);
      const held = thingAt(scene, seen, 24, 14);
      if (held) expect(dragTo(held, 24, 14)(scene)).toEqual(scene);
    }
  });

  test('the background is no thing', async () => {
    const [{ scene }] = PRESETS as readonly [(typeof PRESETS)[number]];
    const seen = await picture({ ...scene, things: [] });
    expect(thingAt({ ...scene, things: [] }, seen, 3, 3)).toBeNull();
  });
});
