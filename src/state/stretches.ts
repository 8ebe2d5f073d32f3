import type { Intersection } from '../math/index.ts';
import type { Sign, Span } from '../math/shapes.ts';
import type { Stretch } from './scene-model.ts';

/**
 * Where the ray is over an interval of t, by the sign of f; for t < 0 just 'behind'. A flat shape
 * has two sides and no inside: f > 0 is the side that N points to. Null if the method does not know
 * the sign.
 */
type Place = 'behind' | 'outside' | 'inside' | 'on it' | 'side of N' | 'other side' | null;

export interface PlacedStretch {
  readonly from: number;
  readonly to: number;
  /** Its line style. */
  readonly stretch: Stretch;
  /** Its name. */
  readonly place: Place;
}

interface Interval {
  readonly from: number;
  readonly to: number;
}

/**
 * The window cut at E and at the roots, in the order of t. `span`: the part of a line in a figure's
 * plane that is in the figure.
 */
export function stretchesOf(
  found: Intersection,
  { from, to }: Interval,
  span: Span | null,
): PlacedStretch[] {
  const ends = span ? [span.from, span.to] : [];
  const cuts = [0, ...found.hits.map(({ t }) => t), ...ends, ...planeCut(found)];
  const inside = cuts.filter((t) => t > from && t < to).sort((a, b) => a - b);
  const bounds = [from, ...new Set(inside), to];
  const pieces = bounds.slice(1).map((end, i) => {
    const interval = { from: bounds[i] ?? from, to: end };
    const place = placeAt(found, interval, span);
    return { ...interval, place, stretch: stretchAt(found, interval, place) };
  });
  return pieces.reduce(joined, []);
}

/** The t at which the plane is crossed: f changes its sign there also if the figure is missed. */
function planeCut({ details }: Intersection): number[] {
  return details.family === 'flat' && details.plane ? [details.plane.t] : [];
}

/** Joins the stretches behind E into one. */
function joined(before: PlacedStretch[], next: PlacedStretch): PlacedStretch[] {
  const last = before.at(-1);
  if (last?.place !== 'behind' || next.place !== 'behind') return [...before, next];
  return [...before.slice(0, -1), { ...last, to: next.to }];
}

/** The line style. Outside between two hits the ray is 'before' the second one. */
function stretchAt({ hits }: Intersection, { to }: Interval, place: Place): Stretch {
  if (place === 'behind') return 'behind';
  if (place === 'inside') return 'inside';
  const visible = hits.filter(({ t }) => t >= 0);
  return visible.some(({ t }) => t >= to) || visible.length === 0 ? 'before' : 'after';
}

function placeAt(found: Intersection, interval: Interval, span: Span | null): Place {
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

const sideOf = (sign: Sign | null): Place =>
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
