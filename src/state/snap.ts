import { roundStep } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';
import type { Sign } from '../math/shapes.ts';

/** What a handle moves: a point or direction, or one number. */
export type Value = Vec3 | number;

/**
 * Pixels between a dragged value and what it snaps to: it is taken within the first, and let go
 * beyond the second.
 */
export const ENTER = 8;
export const LEAVE = 13;

/** A value that a drag may snap to. */
export interface Offer {
  /** Tells it from the others from one moment to the next. */
  readonly key: string;
  readonly value: Value;
  /** What is said beside the handle. */
  readonly reason: string;
  /** Pixels from where the pointer has the value. */
  readonly gap: number;
}

/** The offer that is taken: the one that is held until it is far, else the nearest that is near. */
export function take(offers: readonly Offer[], held: string | null): Offer | null {
  const same = offers.find(({ key, gap }) => key === held && gap <= LEAVE);
  if (same) return same;
  const near = offers.filter(({ gap }) => gap <= ENTER);
  return near.reduce<Offer | null>((a, b) => (a && a.gap <= b.gap ? a : b), null);
}

/**
 * The grid of a drag is the parameter's step, coarser in a large world and finer when that is seen
 * from near.
 */
export function gridUnit(stageRadius: number, worldPerPixel: number): number {
  return roundStep(Math.min(stageRadius / 5, PIXELS_A_UNIT * worldPerPixel));
}

/**
 * A world length of 1 on the first page, with room to spare, so that the grid there is the
 * sliders'.
 */
const PIXELS_A_UNIT = 120;

/**
 * A power of ten at or below a tenth of a pixel: values that are not on the grid stay short to read
 * all the same.
 */
export function hair(valuePerPixel: number): number {
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

/**
 * The multiple of `step`, a power of ten times 1, 2 or 5 times a short decimal, that is nearest to
 * x, as the decimal reads.
 */
export function nearestOn(x: number, step: number): number {
  const rounded = Number((Math.round(x / step) * step).toPrecision(12));
  // Beyond twelve digits the grid is finer than what can be written; + 0 makes −0 a plain zero.
  return Number.isFinite(rounded) && Math.abs(rounded - x) <= step ? rounded + 0 : x;
}

/** What the discriminant says of a value. */
export interface Probe {
  /** Null where the shape has none, or the value is not allowed. */
  readonly sign: Sign | null;
  readonly size: number;
  readonly isTangent: boolean;
}

/** The two ways to ask: `quick` in plain doubles, to find the place, `exact` to decide. */
export interface Tangency {
  quick(value: Value): number;
  exact(value: Value): Probe;
}

/** A line of values through the dragged one, by pixels. */
export type Way = (pixels: number) => Value;

const COARSE = [LEAVE / 3, (2 * LEAVE) / 3, LEAVE];
/** The bracket in which the exact signs take over, in pixels. */
const BRACKET = 1e-4;

/**
 * The nearest place on one of the ways where D changes its sign, as near as doubles come: found by
 * bisection on the exact sign. Where one of the `grids` has a value beside it that is tangent
 * exactly, that one.
 */
export function tangentOffer(
  ways: readonly Way[],
  tangency: Tangency,
  grids: ((value: Value) => Value)[],
): Offer | null {
  const first = ways[0];
  if (!first) return null;
  const here = tangency.quick(first(0));
  let best: { way: Way; from: number; to: number } | null = null;
  for (const way of ways) {
    const to = COARSE.find((s) => tangency.quick(way(s)) * here <= 0);
    if (to === undefined || Number.isNaN(here)) continue;
    let [a, b] = [0, to];
    while (b - a > BRACKET) {
      const middle = (a + b) / 2;
      if (tangency.quick(way(middle)) * here <= 0) b = middle;
      else a = middle;
    }
    if (!best || b < best.to) best = { way, from: a, to: b };
  }
  if (!best) return null;
  const { way, to: gap } = best;
  const offer = (value: Value, isTangent: boolean): Offer => ({
    key: 'tangent',
    value,
    reason: isTangent ? 'snapped: tangent' : 'snapped: as near tangent as doubles come',
    gap,
  });
  for (const grid of grids) {
    const value = grid(way(gap));
    if (tangency.exact(value).isTangent) return offer(value, true);
  }
  const found = bisect(way, Math.max(best.from - BRACKET, 0), gap + BRACKET, tangency);
  return found && offer(found.value, found.probe.isTangent);
}

/**
 * Of the two neighbouring doubles between which the exact D changes its sign, the one where it is
 * smaller.
 */
function bisect(
  way: Way,
  from: number,
  to: number,
  { exact }: Tangency,
): { value: Value; probe: Probe } | null {
  const ask = (s: number) => ({ s, value: way(s), probe: exact(way(s)) });
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
