import type { Intersection } from '../math/index.ts';
import type { Sign, Span } from '../math/shapes.ts';
import type { Ended } from './ended.ts';
import type { Stretch } from './scene-model.ts';

/**
 * Where the ray is over an interval of t, by the sign of f; for t < 0 just 'behind'. A flat shape
 * has two sides and no inside: f > 0 is the side that N points to. Null if the method does not know
 * the sign.
 */
type RayRegion = 'behind' | 'outside' | 'inside' | 'on it' | 'side of N' | 'other side' | null;

export interface PlacedStretch {
  readonly from: number;
  readonly to: number;
  /** Its line style. */
  readonly stretch: Stretch;
  /** Its name. */
  readonly place: RayRegion;
}

interface Interval {
  readonly from: number;
  readonly to: number;
}

/**
 * The window cut at E and at the roots, in the order of t. `span`: the part of a line in a figure's
 * plane that is in the figure. `ended`: what is left of a shape with ends.
 */
export function stretchesOf(
  found: Intersection,
  { from, to }: Interval,
  span: Span | null,
  ended: Ended | null = null,
): PlacedStretch[] {
  const ends = span ? [span.from, span.to] : (ended?.crossed ?? []);
  const cuts = [0, ...found.hits.map(({ t }) => t), ...ends, ...planeCut(found)];
  const visible = hitsLeft(found, ended).filter((t) => t >= 0);
  const inside = cuts.filter((t) => t > from && t < to).sort((a, b) => a - b);
  const bounds = [from, ...new Set(inside), to];
  const pieces = bounds.slice(1).map((end, i) => {
    const interval = { from: bounds[i] ?? from, to: end };
    const whole = placeAt(found, interval, span);
    const isGone = ended !== null && isSomewhere(whole) && !isBetween(interval, ended);
    const place = isGone ? 'outside' : whole;
    return { ...interval, place, stretch: stretchAt(visible, interval, place) };
  });
  return pieces.reduce<PlacedStretch[]>((before, next) => joined(before, next, ended !== null), []);
}

/** The t at which the plane is crossed: f changes its sign there also if the figure is missed. */
function planeCut({ details }: Intersection): number[] {
  return details.family === 'flat' && details.plane ? [details.plane.t] : [];
}

/** t of every hit, ascending: all roots; with ends, the roots that are not cut off and the caps. */
export const hitsLeft = ({ hits }: Intersection, ended: Ended | null): number[] =>
  ended
    ? ended.fates.flatMap(({ t, fate }) => (fate === 'cut' ? [] : [t]))
    : hits.map(({ t }) => t);

const isSomewhere = (place: RayRegion): boolean => place === 'inside' || place === 'on it';

/** Whether the stretch is between the heights, of which it crosses none. */
function isBetween({ from, to }: Interval, { crossed, isWithin }: Ended): boolean {
  if (!crossed) return isWithin;
  return from >= Math.min(...crossed) && to <= Math.max(...crossed);
}

/** Joins stretches behind E into one, and those outside that a cut surface would part. */
function joined(before: PlacedStretch[], next: PlacedStretch, isCut: boolean): PlacedStretch[] {
  const last = before.at(-1);
  const isSame = last?.place === next.place && last.stretch === next.stretch;
  if (!last || !isSame || !(next.place === 'behind' || (isCut && next.place === 'outside'))) {
    return [...before, next];
  }
  return [...before.slice(0, -1), { ...last, to: next.to }];
}

/** The line style. Outside between two hits the ray is 'before' the second one. */
function stretchAt(visible: readonly number[], { to }: Interval, place: RayRegion): Stretch {
  if (place === 'behind') return 'behind';
  if (place === 'inside') return 'inside';
  return visible.some((t) => t >= to) || visible.length === 0 ? 'before' : 'after';
}

function placeAt(found: Intersection, interval: Interval, span: Span | null): RayRegion {
  const { details, class: verdict } = found;
  if (interval.to <= 0) return 'behind';
  if (verdict === 'undecided') return null;
  if (details.family === 'flat') {
    if (verdict !== 'contained') return sideOf(signOfLine(details, interval));
    if (details.meetsFigure === null) return 'on it';
    if (!details.meetsFigure) return 'outside';
    return span && (interval.from >= span.from && interval.to <= span.to ? 'on it' : 'outside');
  }
  if (verdict === 'contained') return 'on it';
  return isInside(found, interval) ? 'inside' : 'outside';
}

const sideOf = (sign: Sign | null): RayRegion =>
  sign === null || sign === 0 ? null : sign > 0 ? 'side of N' : 'other side';

/** The sign of N·(R(t) − P). */
function signOfLine(
  { signs, plane }: Extract<Intersection['details'], { family: 'flat' }>,
  { from }: Interval,
): Sign | null {
  if (!plane || signs.rate === null) return signs.offset;
  return from >= plane.t ? signs.rate : ((0 - signs.rate) as Sign);
}

/** f < 0 between two roots or beyond them, by the signs that the method found. */
function isInside(
  { hits, class: verdict, details }: Intersection,
  { from, to }: Interval,
): boolean {
  if (details.family === 'flat') return false;
  const { A, B, C } = details.signs;
  const passed = hits.filter(({ t }) => t <= from).length;
  const between = passed === 1 && hits.some(({ t }) => t >= to);
  if (verdict === 'two') return A === 1 ? between : !between;
  if (verdict === 'one') return (B === 1) === (passed === 0);
  return A === -1 || (A === 0 && C === -1);
}
