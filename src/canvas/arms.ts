import { AXES } from '../math/vec3.ts';
import { coordinate } from '../text/coordinate.ts';
import { italic } from './captions.ts';
import type { Segment } from './labels.ts';
import type { Layer } from './layer.ts';
import type { Lens, Spot } from './lens.ts';
import { isInside } from './offstage.ts';
import type { Placed } from './placed.ts';
import { along, type Point } from './space.ts';
import type { Theme } from './theme.ts';

/** Length of an arrow where it is seen in full, in pixels at scale 1. */
export const ARM = 50;
/** One that leads to the eye or away is drawn longer than it is, so that it can be taken; from here on it is left out. */
const LEAST = 34;
const SHORT = 9;
/** They begin outside of the mark. */
const FROM = 12;

interface Arm {
  readonly from: Spot;
  readonly dx: number;
  readonly dy: number;
  readonly length: number;
}

/** The arrows that can be shown, by axis. */
function armsOf(place: Point, lens: Lens, scale: number): (Arm | null)[] {
  const from = lens.project(place);
  return AXES.map((_, axis) => {
    if (!from) return null;
    const end = endOf(place, axis, from, lens, scale);
    const seen = Math.hypot(end.x - from.x, end.y - from.y);
    if (seen < SHORT * scale) return null;
    const length = Math.max(seen, LEAST * scale);
    const grow = length / seen;
    return { from, dx: (end.x - from.x) * grow, dy: (end.y - from.y) * grow, length };
  });
}

/** For labels to keep off; the letter at the end included. */
export function armSegments({ place }: Placed, lens: Lens, { scale, label }: Theme): Segment[] {
  if (!place) return [];
  return armsOf(place, lens, scale).flatMap((arm): Segment[] => {
    if (!arm) return [];
    const { from, dx, dy, length } = arm;
    const reach = 1 + (0.8 * label) / length;
    return [[from.x, from.y, from.x + dx * reach, from.y + dy * reach]];
  });
}

/** Three arrows along the axes of the world; what is taken by one moves along it. */
export function drawArms(layer: Layer, { handle, place }: Placed, lens: Lens, theme: Theme): void {
  const { scale, label } = theme;
  if (!place) return;
  for (const [i, arm] of armsOf(place, lens, scale).entries()) {
    const axis = AXES[i];
    if (!arm || !axis) continue;
    const { from: spot, dx, dy, length } = arm;
    const turn = (Math.atan2(dy, dx) * 180) / Math.PI;
    const transform = `translate(${coordinate(spot.x)} ${coordinate(spot.y)}) rotate(${turn.toFixed(2)})`;
    const [from, to] = [coordinate(Math.min(FROM * scale, length / 2)), coordinate(length)];
    const shaft = `M${from} 0H${to}`;
    const names = { 'data-handle': handle.symbol, 'data-symbol': handle.symbol, 'data-axis': i };
    layer.show(`${axis} gap`, 'path', { class: 'scene-arm-gap', d: shaft, transform });
    const hit = { class: 'scene-arm-hit', d: `M${from} 0h${coordinate(length + 2)}` };
    layer.show(`${axis} hit`, 'path', { ...hit, ...names, transform });
    const head = `m0 0l${-9 * scale} ${-4 * scale}v${8 * scale}z`;
    layer.show(`${axis} arm`, 'path', { class: 'scene-arm', d: shaft + head, transform });
    const reach = 1 + (0.42 * label) / length;
    const letter = layer.show(`${axis} letter`, 'text', {
      class: 'scene-arm-letter',
      x: spot.x + dx * reach,
      y: spot.y + dy * reach + 0.2 * label,
    });
    letter.textContent ||= italic(axis);
  }
}

/** To the side of the axis that stays in the frame. */
function endOf(
  place: Point,
  axis: number,
  spot: Spot,
  lens: Lens,
  scale: number,
): { x: number; y: number } {
  const length = (ARM * scale * Math.max(lens.distance(place), lens.near)) / lens.focal;
  const ends = [1, -1].map((sign) => {
    const step: Point = [0, 0, 0];
    step[axis] = sign * length;
    return lens.project(along(place, step, 1)) ?? spot;
  });
  return ends.find((end) => isInside(end, lens)) ?? ends[0] ?? spot;
}
