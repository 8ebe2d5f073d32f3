import { describe, expect, test } from 'vitest';
import { SHAPES, type Vec3 } from '../../../src/math/index.ts';
import { definitionOf } from '../../../src/math/shapes.ts';
import { addThing } from '../../../src/scene/edit.ts';
import { boxWithin, viewSize } from '../../../src/scene/place.ts';
import { PRESETS } from '../../../src/scene/presets/index.ts';
import { boxOf } from '../../../src/scene/surfaces.ts';
import type { Scene, Thing } from '../../../src/scene/types.ts';
import { newThing } from '../../../src/state/picture/edits.ts';
import { cameraAxes } from '../../../src/tracer/camera.ts';

/** The height of the scene's floor, which has the highest level top below the eye. */
const FLOORS: Readonly<Record<string, number>> = Object.fromEntries(
  PRESETS.flatMap(({ id, scene }) => {
    const heights = scene.things.flatMap(({ shape }) => {
      const { normal, point, center } = shape as unknown as Readonly<Record<string, Vec3>>;
      const isLevel = normal?.[0] === 0 && normal[2] === 0;
      return isLevel ? ((point ?? center)?.[1] ?? []) : [];
    });
    return heights.length > 0 ? [[id, Math.max(...heights)]] : [];
  }),
);

const bounded = (thing: Thing) => {
  const box = boxOf(thing);
  if (!box) throw new Error(`${thing.id} has no box`);
  return box;
};

/** Things stand on round floors, whose boxes they are in. */
const isFloor = (other: Thing, { low, high }: ReturnType<typeof bounded>): boolean => {
  const box = boxOf(other);
  return !box || box.high[0] - box.low[0] > 20 * (high[0] - low[0]);
};

/** Each kind of shape that ends, one after the other, twice. */
function filled(scene: Scene): { readonly scene: Scene; readonly added: readonly Thing[] } {
  const kinds = SHAPES.map(({ kind }) => kind).filter((kind) => boxOf(newThing(scene, kind)));
  let now = scene;
  const added: Thing[] = [];
  for (const kind of [...kinds, ...kinds]) {
    const thing = newThing(now, kind);
    added.push(thing);
    now = addThing(now, thing);
  }
  return { scene: now, added };
}

describe.each(PRESETS.map(({ id, scene }) => [id, scene] as const))('new in %s', (id, scene) => {
  const { added } = filled(scene);

  test('stands on the floor, or beside it at its height', () => {
    const floor = FLOORS[id];
    if (floor === undefined) return;
    for (const thing of added) {
      const low = bounded(thing).low[1];
      expect
        .soft(Math.abs(low - floor), `${thing.id} at ${low}`)
        .toBeLessThan(1e-9 * viewSize(scene));
    }
  });

  test('has short coordinates', () => {
    for (const { shape } of added.filter(() => FLOORS[id] === 0)) {
      for (const text of JSON.stringify(shape).match(/-?[\d.]+(e-?\d+)?/g) ?? []) {
        expect.soft(text.length, `${text} in ${JSON.stringify(shape)}`).toBeLessThan(11);
      }
    }
  });

  test('meets no box of what was there, and none of what was added', () => {
    const slack = 1e-9 * viewSize(scene);
    for (const thing of added) {
      const a = bounded(thing);
      for (const other of [...scene.things, ...added]) {
        const b = other === thing ? null : boxWithin(other, [a.low[1], a.high[1]]);
        if (!b || isFloor(other, a)) continue;
        const isApart = [0, 1, 2].some((k) => {
          const [p, q] = [a.low[k] as number, b.low[k] as number];
          return p > (b.high[k] as number) - slack || q > (a.high[k] as number) - slack;
        });
        expect.soft(isApart, `${thing.id} and ${other.id}`).toBe(true);
      }
    }
  });

  test('is in the picture', () => {
    const first = added[0];
    if (!first) return;
    const { eye, ahead, right, up } = cameraAxes(scene.camera, 16 / 9);
    const at = definitionOf(first.shape).anchor(first.shape).at;
    const by = at.map((x, k) => x - (eye[k] as number));
    const dot = (v: Vec3): number => v.reduce((sum, x, k) => sum + x * (by[k] as number), 0);
    const depth = dot(ahead);
    const u = dot(right) / (depth * dot2(right));
    const v = dot(up) / (depth * dot2(up));
    expect([depth > 0, Math.abs(u) < 1, Math.abs(v) < 1], `${u} ${v}`).toEqual([true, true, true]);
  });
});

const dot2 = (v: Vec3): number => v.reduce((sum, x) => sum + x * x, 0);
