import type { Vec3 } from '../math/index.ts';
import type { View } from '../state/camera-view.ts';
import type { SceneModel } from '../state/scene-model.ts';
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
export const BUTTONS = { top: 40, bottom: 34, side: 8, column: 64 };
const MARK = 18;
/** px above the buttons for two lines of notes, which lie across a narrow frame. */
const NOTES = 46;

/** px of the frame's edges that the shape leaves free. */
const EDGE = 4;
/** Samples of a patch along u and v, for its extent. */
const SAMPLES = { u: 24, v: 4 };

/** Least zoom, as a part of the view's, that is chosen to have everything in the frame. */
const LEAST_ZOOM = { points: 0.3, shape: 0.75 };
const ROUNDS = 8;
/** Tolerance in px, so that the iteration ends. */
const PLAY = 0.5;

/**
 * The camera for a view of the model. A view with a zoom is taken as it is. For another the camera
 * is moved back and aside until the important points are in the frame, clear of the buttons, and
 * the shape as far as it is drawn, unless that makes it too small. The pose is a continuous
 * function of the points, and does not move while they are in the frame.
 */
export function framedPose(model: SceneModel, units: StageUnits, frame: Frame): Pose {
  const pose = poseOf(model.view, model.ray, units);
  if (isAsItIs(model.view)) return pose;
  const clear = clearOf(frame, model.notes.length > 0);
  return moved(pose, points(model, units), extent(model, units), frame, clear);
}

const isAsItIs = (view: View): boolean => typeof view !== 'string' && view.zoom !== null;

interface Box {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** The part of the frame that is free of buttons and notes, with room for a mark. */
function clearOf({ width, height, scale }: Frame, hasNotes: boolean): Box {
  const mark = MARK * scale;
  const isNarrow = width < NARROW;
  return {
    left: BUTTONS.side + mark,
    right: width - (isNarrow ? BUTTONS.column : BUTTONS.side) - mark,
    top: BUTTONS.top + mark,
    bottom: height - BUTTONS.bottom - mark - (isNarrow && hasNotes ? NOTES : 0),
  };
}

const inside = ({ width, height }: Frame): Box => ({
  left: EDGE,
  right: width - EDGE,
  top: EDGE,
  bottom: height - EDGE,
});

/** The important points: E, the hits with their normals, the shape's, and what the model adds. */
function points({ ray, hits, drawing, framed = [] }: SceneModel, units: StageUnits): Point[] {
  const found: Point[] = [];
  const add = (p: Vec3): Point | null => {
    const place = units.toStage(p);
    if (place) found.push(place);
    return place;
  };
  if (ray.originDrawn) add(ray.origin);
  for (const at of [...drawing.marks.map((mark) => mark.at), ...framed]) add(at);
  for (const { point, drawn, normal } of hits) {
    const place = drawn ? add(point) : null;
    const n = normal && unit(normal);
    if (place && n) found.push(along(place, n, NORMAL));
  }
  return found;
}

/** Points all over the shape, but for what goes on to all sides, as a plane does. */
function extent({ drawing }: SceneModel, units: StageUnits): Point[] {
  const { u, v } = SAMPLES;
  return drawing.patches
    .filter(({ closed, sides }) => closed || sides === 'edge')
    .flatMap((patch) =>
      Array.from({ length: (u + 1) * (v + 1) }, (_, k) =>
        units.toStage(patch.at((k % (u + 1)) / u, Math.floor(k / (u + 1)) / v)),
      ),
    )
    .filter((point) => point !== null);
}
function moved(
  pose: Pose,
  all: readonly Point[],
  shape: readonly Point[],
  frame: Frame,
  clear: Box,
): Pose {
  const whole = inside(frame);
  if (clear.right - clear.left < 1 || clear.bottom - clear.top < 1) return pose;
  let now = pose;
  for (let k = 0; k < ROUNDS; k++) {
    const projection = new Projection(now, frame.width, frame.height);
    const needed = { box: boxOf(all, projection), into: clear };
    const drawn = { box: boxOf(shape, projection), into: whole };
    const share = shareOf(needed, needed);
    const shareDrawn = Math.min(
      shareOf(drawn, drawn),
      shareOf(needed, drawn),
      shareOf(drawn, needed),
    );
    const zoom = Math.min(
      Math.max(now.zoom * share, Math.min(now.zoom, LEAST_ZOOM.points * pose.zoom)),
      Math.max(now.zoom * shareDrawn, Math.min(now.zoom, LEAST_ZOOM.shape * pose.zoom)),
    );
    const [dx, dy] = shift(needed, shift(drawn, [0, 0]));
    if (zoom === now.zoom && Math.abs(dx) < PLAY && Math.abs(dy) < PLAY) return now;
    const perPixel = projection.distance(now.target) / projection.focal;
    now = {
      ...now,
      zoom,
      target: along(
        along(now.target, projection.right, -dx * perPixel),
        projection.up,
        dy * perPixel,
      ),
    };
  }
  return now;
}

/** The box around points on the screen; null where none is seen. */
function boxOf(points: readonly Point[], projection: Projection): Box | null {
  const spots = points.flatMap((p) => projection.project(p) ?? []);
  if (spots.length === 0) return null;
  const [xs, ys] = [spots.map(({ x }) => x), spots.map(({ y }) => y)];
  return {
    left: Math.min(...xs),
    right: Math.max(...xs),
    top: Math.min(...ys),
    bottom: Math.max(...ys),
  };
}

/** A box on the screen, null where nothing is seen, and the one it should be in. */
interface Fit {
  readonly box: Box | null;
  readonly into: Box;
}

/**
 * The factor, at most 1, with which what is between the left and upper sides of one box and the
 * right and lower sides of another fits between where these should be.
 */
function shareOf(one: Fit, other: Fit): number {
  if (!one.box || !other.box) return 1;
  return Math.min(
    1,
    (other.into.right - one.into.left) / Math.max(other.box.right - one.box.left, 1),
    (other.into.bottom - one.into.top) / Math.max(other.box.bottom - one.box.top, 1),
  );
}

/** The least shift, beside the one given, that brings a box into another. */
function shift({ box, into }: Fit, [dx, dy]: [number, number]): [number, number] {
  if (!box) return [dx, dy];
  return [
    dx + aside(box.left + dx, box.right + dx, into.left, into.right),
    dy + aside(box.top + dy, box.bottom + dy, into.top, into.bottom),
  ];
}

/** The shift that brings an interval into another one; into its middle if it is longer. */
function aside(from: number, to: number, least: number, most: number): number {
  if (to - from > most - least) return (least + most - from - to) / 2;
  return Math.max(least - from, 0) + Math.min(most - to, 0);
}
