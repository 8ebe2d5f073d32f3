import type { Vec3 } from '../math/index.ts';
import type { SceneModel } from '../state/scene-model.ts';
import type { View } from '../state/view.ts';
import { type Pose, poseOf } from './camera.ts';
import { Projection } from './projection.ts';
import { along, type Point, type StageUnits, unit } from './stage-units.ts';

/** The frame that the scene fills, in CSS pixels, with the theme's factor on marks. */
export interface Frame {
  readonly width: number;
  readonly height: number;
  readonly scale: number;
}

/** Length of all normal arrows, in stage radii. */
export const NORMAL = 0.2;
/** Width in px below which the view buttons are a column, as in scene.css. */
export const NARROW = 480;

/** px at the frame's edges for the page's buttons and for E's disc. */
const BUTTONS = { top: 40, bottom: 34, side: 8, column: 64 };
const MARK = 18;

/** Least zoom that is chosen to have everything in the frame. */
const LEAST_ZOOM = 0.3;
const ROUNDS = 8;
/** Tolerance in px, so that the iteration ends. */
const PLAY = 0.5;

/**
 * The camera for a view of the model. A view with a zoom is taken as it is. For another the camera
 * is moved back and aside until the important points are in the frame, clear of the buttons. The
 * pose is a continuous function of the points, and does not move while they are in the frame.
 */
export function framedPose(model: SceneModel, units: StageUnits, frame: Frame): Pose {
  const pose = poseOf(model.view, model.ray, units);
  return isAsItIs(model.view) ? pose : moved(pose, points(model, units), frame);
}

const isAsItIs = (view: View): boolean => typeof view !== 'string' && view.zoom !== null;

/** The part of the frame that is free of buttons, with room for a mark. */
function clearOf({ width, height, scale }: Frame): {
  left: number;
  right: number;
  top: number;
  bottom: number;
} {
  const mark = MARK * scale;
  const isNarrow = width < NARROW;
  return {
    left: BUTTONS.side + mark,
    right: width - (isNarrow ? BUTTONS.column : BUTTONS.side) - mark,
    top: BUTTONS.top + mark,
    bottom: height - BUTTONS.bottom - mark,
  };
}

/** The important points: E, the hits with their normals, and the shape's anchor. */
function points({ ray, hits, drawing }: SceneModel, units: StageUnits): Point[] {
  const found: Point[] = [];
  const add = (p: Vec3): Point | null => {
    const place = units.toStage(p);
    if (place) found.push(place);
    return place;
  };
  if (ray.originDrawn) add(ray.origin);
  for (const { at } of drawing.marks) add(at);
  for (const { point, drawn, normal } of hits) {
    const place = drawn ? add(point) : null;
    const n = normal && unit(normal);
    if (place && n) found.push(along(place, n, NORMAL));
  }
  return found;
}

function moved(pose: Pose, all: readonly Point[], frame: Frame): Pose {
  const { left, right, top, bottom } = clearOf(frame);
  const [width, height] = [right - left, bottom - top];
  if (width < 1 || height < 1) return pose;
  let now = pose;
  for (let k = 0; k < ROUNDS; k++) {
    const projection = new Projection(now, frame.width, frame.height);
    const spots = all.flatMap((p) => projection.project(p) ?? []);
    if (spots.length === 0) return now;
    const [xs, ys] = [spots.map(({ x }) => x), spots.map(({ y }) => y)];
    const [x1, x2] = [Math.min(...xs), Math.max(...xs)];
    const [y1, y2] = [Math.min(...ys), Math.max(...ys)];
    const share = Math.min(1, width / Math.max(x2 - x1, 1), height / Math.max(y2 - y1, 1));
    const dx = aside(x1, x2, left, right);
    const dy = aside(y1, y2, top, bottom);
    if (share === 1 && Math.abs(dx) < PLAY && Math.abs(dy) < PLAY) return now;
    const perPixel = projection.distance(now.target) / projection.focal;
    now = {
      ...now,
      zoom: Math.max(now.zoom * share, LEAST_ZOOM * pose.zoom),
      target: along(
        along(now.target, projection.right, -dx * perPixel),
        projection.up,
        dy * perPixel,
      ),
    };
  }
  return now;
}

/** The shift that brings an interval into another one; into its middle if it is longer. */
function aside(from: number, to: number, least: number, most: number): number {
  if (to - from > most - least) return (least + most - from - to) / 2;
  return Math.max(least - from, 0) + Math.min(most - to, 0);
}
