import { roundStep } from '../math/drawing.ts';
import type { Intersection } from '../math/index.ts';

/** The stretch of t that the graph shows, and the ray is drawn over. */
interface Window {
  readonly from: number;
  readonly to: number;
  /** What it leaves out, in words. */
  readonly note: string | null;
}

/** Roots closer together than this share of their distance from E are looked at by themselves. */
const CLOSE = 0.02;
/**
 * Closer than this they fall on one pixel even so, and f has lost the digits to be drawn between
 * them.
 */
const TOO_CLOSE = 1e-5;
/** A root nearer to E than this share of the other one's distance is looked at without that one. */
const FAR = 1e-3;

const TOGETHER = 't₁ and t₂ lie too close together to be told apart here';

/** Room for differences of two such numbers. */
const LARGEST = Number.MAX_VALUE / 4;

/**
 * All roots, E and the tip of d, with room on both sides; or the roots alone when E is too far away
 * to show both. `ends`: of what a line in a figure's plane has in common with the figure.
 */
export function windowOf(found: Intersection, ends: readonly number[] = []): Window {
  return within(found, [1, ...ends]);
}

/**
 * The same for the graph alone: without the tip of d where that is so far off that two roots fall
 * together.
 */
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

/** Where one root is so far off that the other one would fall on E: the near one with E. */
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

/**
 * The points in t that the picture is about: the roots, and the plane's root where the figure is
 * missed.
 */
export function rootsOf({ hits, details }: Intersection): number[] {
  if (details.family === 'flat' && details.plane) return [details.plane.t];
  return hits.map(({ t }) => t);
}

/** For a miss, the t of the smallest |f|, unless it is far off. */
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
 * t at rest: the middle between two roots, else a little beyond the tip of d. Short, so that it
 * reads well.
 */
export function restingBead(found: Intersection, { from, to }: Window): number {
  const [first, second] = found.hits;
  const t = first && second ? (first.t + second.t) / 2 : 1.5;
  const step = roundStep((to - from) / 50);
  const rounded = Math.round(t / step) * step;
  const clean = Number(rounded.toPrecision(12));
  return clean >= from && clean <= to ? clean : (from + to) / 2;
}
