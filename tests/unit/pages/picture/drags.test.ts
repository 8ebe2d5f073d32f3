import { describe, expect, test } from 'vitest';
import type { Vec3 } from '../../../../src/math/index.ts';
import { dragTo, thingAt } from '../../../../src/pages/picture/dragged-thing.ts';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import { surfacesOf } from '../../../../src/scene/surfaces.ts';
import { DRAG_PLANES, type DragPlane } from '../../../../src/state/picture/drag.ts';
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

/** The middle of what is seen of a thing after it was dragged by so many pixels. */
async function afterDrag(along: DragPlane, dx: number, dy: number) {
  const preset = PRESETS.find(({ id }) => id === 'cone-on-mirror');
  if (!preset) throw new Error('no preset');
  const before = await picture(preset.scene);
  const index = preset.scene.things.findIndex(({ id }) => id === 'ball');
  const at = middleOf(index, preset.scene, before);
  if (!at) throw new Error('not seen');
  const held = thingAt(preset.scene, before, Math.round(at.x), Math.round(at.y));
  expect(held?.id).toBe('ball');
  if (!held) throw new Error('not held');
  const moved = dragTo(held, held.from[0] + dx, held.from[1] + dy, along)(preset.scene);
  const [a, b] = [preset.scene, moved].map((scene) => scene.things[index]?.shape);
  if (a?.kind !== 'sphere' || b?.kind !== 'sphere') throw new Error('no ball');
  const by = b.center.map((x, i) => x - (a.center[i] as number)) as unknown as Vec3;
  const there = middleOf(index, moved, await picture(moved));
  return { by, dx: (there?.x ?? 0) - at.x, dy: (there?.y ?? 0) - at.y };
}

describe('a thing dragged in the picture', () => {
  test.each([
    ['wall', -4, -3],
    ['floor', -4, 1],
  ] as const)('along the %s comes along with the pointer', async (along, dx, dy) => {
    const moved = await afterDrag(along, dx, dy);
    // Its middle is known to a pixel: it is cut off by what stands before it, and grows as it comes
    // nearer.
    expect(Math.abs(moved.dx - dx)).toBeLessThan(1);
    expect(Math.abs(moved.dy - dy)).toBeLessThan(1);
  });

  test('keeps to the floor, or to the wall', async () => {
    const floor = await afterDrag('floor', 3, 2);
    expect(floor.by[1]).toBe(0);
    expect(floor.by[2]).toBeGreaterThan(0.1);
    const wall = await afterDrag('wall', 0, -3);
    expect(wall.by[1]).toBeGreaterThan(0.1);
    // The camera looks along −z, a little to the side.
    expect(Math.hypot(wall.by[0], wall.by[2])).toBeLessThan(wall.by[1] / 5);
  });

  test('brought back, the scene is what it was', async () => {
    for (const { scene } of PRESETS) {
      const seen = await picture(scene);
      const held = thingAt(scene, seen, 24, 14);
      for (const along of DRAG_PLANES) {
        if (held) expect(dragTo(held, 24, 14, along)(scene)).toEqual(scene);
      }
    }
  });

  test('the background is no thing', async () => {
    const [{ scene }] = PRESETS as readonly [(typeof PRESETS)[number]];
    const seen = await picture({ ...scene, things: [] });
    expect(thingAt({ ...scene, things: [] }, seen, 3, 3)).toBeNull();
  });
});
