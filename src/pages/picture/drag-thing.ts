import type { Vec3 } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import { changeThing, isPlace } from '../../scene/edit.ts';
import { surfacesOf } from '../../scene/surfaces.ts';
import type { Placed, Scene } from '../../scene/types.ts';
import { withParam } from '../../state/picture/edits.ts';
import { cameraAxes } from '../../tracer/camera.ts';
import type { Picture } from '../../tracer/compare.ts';

/** A thing that is held in the picture, by the point that was seen there. */
export interface DraggedThing {
  readonly scene: Scene;
  readonly id: string;
  readonly width: number;
  readonly height: number;
  readonly from: readonly [x: number, y: number];
  /** Distance of that point from the eye along the line of sight; a drag keeps it. */
  readonly depth: number;
}

/** What is seen at a pixel; null for the background. */
export function thingAt(scene: Scene, seen: Picture, x: number, y: number): DraggedThing | null {
  const { width, height } = seen;
  const pixel = Math.floor(y) * width + Math.floor(x);
  const surface = surfacesOf(scene)[seen.surface[pixel] ?? -1];
  const thing = surface && scene.things[surface.thing];
  const t = seen.t[pixel] ?? Number.NaN;
  if (!thing || Number.isNaN(t)) return null;
  const { ahead, right, up } = cameraAxes(scene.camera, width / height);
  const u = (2 * (Math.floor(x) + 0.5)) / width - 1;
  const v = 1 - (2 * (Math.floor(y) + 0.5)) / height;
  const way = ahead.map((a, i) => a + u * (right[i] ?? 0) + v * (up[i] ?? 0));
  return { scene, id: thing.id, width, height, from: [x, y], depth: t / Math.hypot(...way) };
}

/**
 * Drags the thing to another place of the picture: from where it was taken, whatever else has
 * changed since.
 */
export function dragTo(held: DraggedThing, x: number, y: number): (now: Scene) => Scene {
  const { scene, id, width, height, from, depth } = held;
  const { right, up } = cameraAxes(scene.camera, width / height);
  const du = (2 * (x - from[0]) * depth) / width;
  const dv = (-2 * (y - from[1]) * depth) / height;
  const pixel = (2 * depth * Math.hypot(...up)) / height;
  // Coordinates are rounded to a power of ten below one pixel, so that they stay short.
  const grid = 10 ** Math.floor(Math.log10(pixel));
  const by = right.map((r, i) => Math.round((du * r + dv * (up[i] ?? 0)) / grid) * grid);
  const taken = scene.things.find((thing) => thing.id === id);
  return (now) =>
    changeThing(now, id, (thing) => (taken ? movedBy(thing, taken, by, grid) : thing));
}

function movedBy(thing: Placed, taken: Placed, by: readonly number[], grid: number): Placed {
  const param = definitionOf(taken.shape).params.find(isPlace);
  if (!param) return thing;
  const place = (taken.shape as unknown as Readonly<Record<string, Vec3>>)[param.key];
  if (!place) return thing;
  const digits = Math.max(0, -Math.floor(Math.log10(grid)));
  const next = (i: 0 | 1 | 2): number => {
    const step = by[i] ?? 0;
    if (step === 0) return place[i];
    const x = place[i] + step;
    // Removes the rounding noise of sums such as 0.1 + 0.2.
    return digits <= 15 && Math.abs(x) < 1e6 ? Number(x.toFixed(digits + 2)) : x;
  };
  return withParam(thing, param, [next(0), next(1), next(2)]);
}
