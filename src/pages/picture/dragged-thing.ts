import type { Vec3 } from '../../math/index.ts';
import { surfacesOf } from '../../scene/surfaces.ts';
import type { Scene } from '../../scene/types.ts';
import {
  type CameraFrame,
  type DragPlane,
  dragged,
  movedFrom,
  rayThrough,
} from '../../state/picture/drag.ts';
import { cameraAxes } from '../../tracer/camera.ts';
import type { Picture } from '../../tracer/compare.ts';

/** A thing or a light that is being dragged in the picture. */
export interface DraggedThing {
  /** The scene at the start of the drag. */
  readonly scene: Scene;
  readonly id: string;
  /** The dragged point at the start, in the world and in the picture. */
  readonly at: Vec3;
  readonly from: readonly [x: number, y: number];
  readonly frame: CameraFrame;
}

/** The scene's camera for a picture of this size. */
export const cameraFrameOf = ({ camera }: Scene, width: number, height: number): CameraFrame => ({
  ...cameraAxes(camera, width / height),
  width,
  height,
});

/** The thing at a place of the picture; null for the background. */
export function thingAt(scene: Scene, seen: Picture, x: number, y: number): DraggedThing | null {
  const { width, height } = seen;
  const pixel = Math.floor(y) * width + Math.floor(x);
  const surface = surfacesOf(scene)[seen.surface[pixel] ?? -1];
  const thing = surface && scene.things[surface.thing];
  const t = seen.t[pixel] ?? Number.NaN;
  if (!thing || Number.isNaN(t)) return null;
  const cameraFrame = cameraFrameOf(scene, width, height);
  const middle = rayThrough(cameraFrame, [Math.floor(x) + 0.5, Math.floor(y) + 0.5]);
  const way = rayThrough(cameraFrame, [x, y]);
  const depth = t / Math.hypot(...middle);
  const at = (i: 0 | 1 | 2): number => cameraFrame.eye[i] + depth * way[i];
  return { scene, id: thing.id, at: [at(0), at(1), at(2)], from: [x, y], frame: cameraFrame };
}

/** The edit of the scene that drags to another place of the picture. */
export const dragTo = (
  { scene, id, at, from, frame }: DraggedThing,
  x: number,
  y: number,
  along: DragPlane,
): ((now: Scene) => Scene) => movedFrom(scene, id, dragged(frame, at, from, [x, y], along));
