import { AXES } from '../math/shapes.ts';
import { coordinate } from '../text/coordinate.ts';
import { italic } from './captions.ts';
import type { HandlePlace } from './handle-place.ts';
import type { Segment } from './labels.ts';
import type { Layer } from './layer.ts';
import { isInside } from './off-screen-pointer.ts';
import type { Projection, ScreenPoint } from './projection.ts';
import { along, type Point } from './stage-units.ts';
import type { Theme } from './theme.ts';

/** Length of an arrow where it is seen in full, in pixels at scale 1. */
export const ARROW_LENGTH = 50;
/** Least drawn length, in px at scale 1, of an arrow that is foreshortened. */
const MIN_LENGTH = 34;
/** An arrow whose true length on the screen is less, in px at scale 1, is not drawn. */
const HIDDEN_BELOW = 9;
/** Distance of an arrow's start from the handle's centre, in px at scale 1. */
const START = 12;

interface AxisArrow {
  readonly from: ScreenPoint;
  readonly dx: number;
  readonly dy: number;
  readonly length: number;
}

/** The arrows that can be shown, by axis. */
function axisArrows(place: Point, projection: Projection, scale: number): (AxisArrow | null)[] {
  const from = projection.project(place);
  return AXES.map((_, axis) => {
    if (!from) return null;
    const end = endOf(place, axis, from, projection, scale);
    const seen = Math.hypot(end.x - from.x, end.y - from.y);
    if (seen < HIDDEN_BELOW * scale) return null;
    const length = Math.max(seen, MIN_LENGTH * scale);
    const grow = length / seen;
    return { from, dx: (end.x - from.x) * grow, dy: (end.y - from.y) * grow, length };
  });
}

/** The arrows and the boxes of their letters, which labels must not cover. */
export function axisArrowSegments(
  { place }: HandlePlace,
  projection: Projection,
  { scale, label }: Theme,
): Segment[] {
  if (!place) return [];
  return axisArrows(place, projection, scale).flatMap((arrow): Segment[] => {
    if (!arrow) return [];
    const { from, dx, dy, length } = arrow;
    const reach = 1 + (0.8 * label) / length;
    return [[from.x, from.y, from.x + dx * reach, from.y + dy * reach]];
  });
}

/**
 * Draws three arrows along the world's axes. Dragging one moves the handle along that axis only.
 */
export function drawAxisArrows(
  layer: Layer,
  { handle, place }: HandlePlace,
  projection: Projection,
  theme: Theme,
): void {
  const { scale, label } = theme;
  if (!place) return;
  for (const [i, arrow] of axisArrows(place, projection, scale).entries()) {
    const axis = AXES[i];
    if (!arrow || !axis) continue;
    const { from: spot, dx, dy, length } = arrow;
    const turn = (Math.atan2(dy, dx) * 180) / Math.PI;
    const transform =
      `translate(${coordinate(spot.x)} ${coordinate(spot.y)}) ` + `rotate(${turn.toFixed(2)})`;
    const [from, to] = [coordinate(Math.min(START * scale, length / 2)), coordinate(length)];
    const shaft = `M${from} 0H${to}`;
    const names = { 'data-handle': handle.symbol, 'data-symbol': handle.symbol, 'data-axis': i };
    layer.show(`${axis} gap`, 'path', { class: 'axis-arrow-gap', d: shaft, transform });
    const hit = { class: 'axis-arrow-hit', d: `M${from} 0h${coordinate(length + 2)}` };
    layer.show(`${axis} hit`, 'path', { ...hit, ...names, transform });
    const head = `m0 0l${-9 * scale} ${-4 * scale}v${8 * scale}z`;
    layer.show(`${axis} shaft`, 'path', { class: 'axis-arrow', d: shaft + head, transform });
    const reach = 1 + (0.42 * label) / length;
    const letter = layer.show(`${axis} letter`, 'text', {
      class: 'axis-arrow-letter',
      x: spot.x + dx * reach,
      y: spot.y + dy * reach + 0.2 * label,
    });
    letter.textContent ||= italic(axis);
  }
}

/** The end of an arrow, on the side of the axis that is in the frame. */
function endOf(
  place: Point,
  axis: number,
  spot: ScreenPoint,
  projection: Projection,
  scale: number,
): { x: number; y: number } {
  const length =
    (ARROW_LENGTH * scale * Math.max(projection.distance(place), projection.near)) /
    projection.focal;
  const ends = [1, -1].map((sign) => {
    const step: Point = [0, 0, 0];
    step[axis] = sign * length;
    return projection.project(along(place, step, 1)) ?? spot;
  });
  return ends.find((end) => isInside(end, projection)) ?? ends[0] ?? spot;
}
