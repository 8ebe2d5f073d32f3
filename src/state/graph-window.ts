import { roundStep } from '../math/drawing.ts';
import type { Intersection } from '../math/index.ts';

/** The interval of t that the graph shows. */
interface Window {
  readonly from: number;
  readonly to: number;
  /** Words on what lies outside of the window; null if nothing does. */
  readonly note: string | null;
}

/** Two roots whose distance is below this share of their |t| are shown without E. */
const CLOSE = 0.02;
/** Below this share they fall on one pixel even so, and f between them is lost in rounding. */
const TOO_CLOSE = 1e-5;
/** A root whose |t| is below this share of the other root's is shown without that one. */
const FAR = 1e-3;

const TOGETHER = 't₁ and t₂ lie too close together to be told apart here';

/** Largest |t| of a window: differences of two such numbers do not overflow. */
const LARGEST = Number.MAX_VALUE / 4;

/**
 * All roots, E and the tip of d, with a margin on both sides; or the roots alone if E is too far
 * away. `ends`: the t's between which a line in a figure's plane is in the figure.
 */
export function windowOf(found: Intersection, ends: readonly number[] = []): Window {
  return within(found, [1, ...ends]);
}

/** The window of the graph: without the tip of d if that is so far off that two roots coincide. */
export function graphWindowOf(found: Intersection, ends: readonly number[] = []): Window {
  const whole = windowOf(found, ends);
  const [first, last] = rootsOf(found);
  if (first === undefined || last === undefined) return whole;
  if (first === last) {
    return Math.abs(first) < CLOSE && first !== 0 ? within(found, ends) : whole;
  }
  const alone = nearRootAlone(first, last);
  if (alone) return alone;
  if (last - first > CLOSE * (whole.to - whole.from)) return whole;
  const near = within(found, ends);
  return near.note === TOGETHER ? whole : near;
}

/** The window of E and the near root, if the other is so far off that both would coincide. */
function nearRootAlone(first: number, last: number): Window | null {
  const [near, far] = Math.abs(first) < Math.abs(last) ? [first, last] : [last, first];
  if (near === 0 || !(Math.abs(near) < FAR * Math.abs(far))) return null;
  const [name, side] = [far === first ? 't₁' : 't₂', far > 0 ? 'right' : 'left'];
  const note = `${name} is far to the ${side}`;
  return { ...around([0, near], [near]), note };
}

function within(found: Intersection, ends: readonly number[]): Window {
  const roots = rootsOf(found).filter(Number.isFinite);
  const [first, last] = [roots[0], roots.at(-1)];
  if (first !== undefined && last !== undefined && first !== last) {
    const gap = last - first;
    const farthest = Math.max(Math.abs(first), Math.abs(last));
    if (gap < CLOSE * farthest && gap > TOO_CLOSE * farthest) {
      const side = first > 0 ? 'left' : 'right';
      const note = `E, at t = 0, is far to the ${side}`;
      return { from: first - 0.6 * gap, to: last + 0.6 * gap, note };
    }
  }
  return around([0, ...roots, ...ends.filter(Number.isFinite), ...turningPoint(found)], roots);
}

/** The roots; for a flat shape the t of its plane, also if the figure is missed. */
export function rootsOf({ hits, details }: Intersection): number[] {
  if (details.family === 'flat' && details.plane) return [details.plane.t];
  return hits.map(({ t }) => t);
}

/** For a miss the t of the vertex of f, if its |t| is below 100. */
function turningPoint({ class: verdict, details }: Intersection): number[] {
  if (details.family !== 'curved' || verdict !== 'none' || !details.signs.A) return [];
  const t = -details.B / (2 * details.A);
  return Math.abs(t) < 100 ? [t] : [];
}

function around(points: readonly number[], roots: readonly number[]): Window {
  const least = Math.min(...points);
  const most = Math.max(...points);
  const span = Math.min(most - least, LARGEST);
  const close = roots.length === 2 && (roots[1] ?? 0) - (roots[0] ?? 0) <= TOO_CLOSE * span;
  return {
    from: Math.max(least - 0.14 * span, -LARGEST),
    to: Math.min(most + 0.3 * span, LARGEST),
    note: close ? TOGETHER : null,
  };
}

/**
 * t of a bead that was not moved: midway between the first two hits, else 1.5; rounded to a short
 * decimal.
 */
export function restingBead(hits: readonly number[], { from, to }: Window): number {
  const [first, second] = hits;
  const t = first !== undefined && second !== undefined ? (first + second) / 2 : 1.5;
  const step = roundStep((to - from) / 50);
  const rounded = Math.round(t / step) * step;
  const clean = Number(rounded.toPrecision(12));
  return clean >= from && clean <= to ? clean : (from + to) / 2;
}
