import { roundStep } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';
import type { Sign } from '../math/shapes.ts';

/** What a handle moves: a point or direction, or one number. */
export type Value = Vec3 | number;

/**
 * Hysteresis in pixels: a drag snaps to a target nearer than `ENTER`, and leaves it again beyond
 * `LEAVE`.
 */
export const ENTER = 8;
export const LEAVE = 13;

/** A value that a drag may snap to. */
export interface SnapTarget {
  /** Identifies the target from one pointer event to the next. */
  readonly key: string;
  readonly value: Value;
  /** Words beside the handle while it is snapped. */
  readonly reason: string;
  /** Distance in pixels from the pointer. */
  readonly gap: number;
}

/**
 * The target to snap to, or null: the one with the key `held` within `LEAVE` pixels, else the
 * nearest within `ENTER`.
 */
export function chooseTarget(
  targets: readonly SnapTarget[],
  held: string | null,
): SnapTarget | null {
  const same = targets.find(({ key, gap }) => key === held && gap <= LEAVE);
  if (same) return same;
  const near = targets.filter(({ gap }) => gap <= ENTER);
  return near.reduce<SnapTarget | null>((a, b) => (a && a.gap <= b.gap ? a : b), null);
}

/**
 * Grid of a drag in world units, 1, 2 or 5 times a power of ten: finer on a small stage or near.
 */
export function gridUnit(stageRadius: number, worldPerPixel: number): number {
  return roundStep(Math.min(stageRadius / 5, PIXELS_A_UNIT * worldPerPixel));
}

/**
 * Pixels that a grid step of 1 takes at most. A world length of 1 is shorter on the initial page,
 * so that the grid there is that of the sliders.
 */
const PIXELS_A_UNIT = 120;

/**
 * The largest power of ten below a tenth of a pixel. Values off the grid are rounded to it, so that
 * they stay short.
 */
export function finestStep(valuePerPixel: number): number {
  return 10 ** Math.floor(Math.log10(valuePerPixel / 10));
}

/** Each component that a drag has changed, rounded to the grid; the others keep their bits. */
export function onGrid(value: Value, start: Value, step: number): Value {
  if (typeof value === 'number') return value === start ? value : nearestOn(value, step);
  const from = start as Vec3;
  const put = (i: 0 | 1 | 2): number =>
    value[i] === from[i] ? value[i] : nearestOn(value[i], step);
  return [put(0), put(1), put(2)];
}

/** The multiple of `step` nearest to x, as the double of its short decimal. */
export function nearestOn(x: number, step: number): number {
  const rounded = Number((Math.round(x / step) * step).toPrecision(12));
  // If the grid is finer than twelve digits, x is kept; + 0 turns −0 into 0.
  return Number.isFinite(rounded) && Math.abs(rounded - x) <= step ? rounded + 0 : x;
}

/** The exact discriminant for a value. */
export interface Probe {
  /** Null if the shape has no discriminant, or the value is not allowed. */
  readonly sign: Sign | null;
  readonly size: number;
  readonly isTangent: boolean;
}

/** D as a function of a value: `quick` in doubles, to search; `exact`, to decide. */
export interface Tangency {
  quick(value: Value): number;
  exact(value: Value): Probe;
}

/** A line of values through the dragged one, as a function of the distance in pixels. */
export type DragLine = (pixels: number) => Value;

const COARSE = [LEAVE / 3, (2 * LEAVE) / 3, LEAVE];
/** Width in pixels of the bracket below which exact signs are used. */
const BRACKET = 1e-4;

/**
 * The nearest value on one of the lines at which D changes its sign, to the last double, found by
 * bisection on the exact sign. If rounding to one of the `grids` gives a value beside it that is
 * exactly tangent, that one.
 */
export function tangentTarget(
  lines: readonly DragLine[],
  tangency: Tangency,
  grids: ((value: Value) => Value)[],
): SnapTarget | null {
  const first = lines[0];
  if (!first) return null;
  const here = tangency.quick(first(0));
  let best: { line: DragLine; from: number; to: number } | null = null;
  for (const line of lines) {
    const to = COARSE.find((s) => tangency.quick(line(s)) * here <= 0);
    if (to === undefined || Number.isNaN(here)) continue;
    let [a, b] = [0, to];
    while (b - a > BRACKET) {
      const middle = (a + b) / 2;
      if (tangency.quick(line(middle)) * here <= 0) b = middle;
      else a = middle;
    }
    if (!best || b < best.to) best = { line, from: a, to: b };
  }
  if (!best) return null;
  const { line, to: gap } = best;
  const offer = (value: Value, isTangent: boolean): SnapTarget => ({
    key: 'tangent',
    value,
    reason: isTangent ? 'snapped: tangent' : 'snapped: as near tangent as doubles come',
    gap,
  });
  for (const grid of grids) {
    const value = grid(line(gap));
    if (tangency.exact(value).isTangent) return offer(value, true);
  }
  const found = bisect(line, Math.max(best.from - BRACKET, 0), gap + BRACKET, tangency);
  return found && offer(found.value, found.probe.isTangent);
}

/**
 * Of the two neighbouring doubles between which exact D changes its sign, the one of smaller |D|.
 */
function bisect(
  line: DragLine,
  from: number,
  to: number,
  { exact }: Tangency,
): { value: Value; probe: Probe } | null {
  const ask = (s: number) => ({ s, value: line(s), probe: exact(line(s)) });
  let [a, b] = [ask(from), ask(to)];
  for (const end of [a, b]) if (end.probe.sign === null || end.probe.sign === 0) return solved(end);
  if (a.probe.sign === b.probe.sign) return null;
  for (;;) {
    const middle = ask((a.s + b.s) / 2);
    if (middle.probe.sign === 0 || middle.probe.sign === null) return solved(middle);
    if (same(middle.value, a.value) || same(middle.value, b.value)) break;
    if (middle.probe.sign === a.probe.sign) a = middle;
    else b = middle;
  }
  return solved(Math.abs(a.probe.size) <= Math.abs(b.probe.size) ? a : b);
}

function solved<Found extends { probe: Probe }>(found: Found): Found | null {
  return found.probe.sign === null ? null : found;
}

function same(a: Value, b: Value): boolean {
  if (typeof a === 'number' || typeof b === 'number') return a === b;
  return a.every((x, i) => x === b[i]);
}
