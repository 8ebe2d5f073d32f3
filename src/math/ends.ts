import type { Quadric } from './batch/quadric.ts';
import { productError, sumError } from './float/eft.ts';
import type { Fate, Hit, Sign, Verdict } from './intersection.ts';
import { FAITHFUL_ONCE } from './methods/certified/numbers.ts';
import type { AtHeight, ExactLine } from './methods/exact-line.ts';
import type { Ray } from './ray.ts';
import type { Cut } from './shapes/checked.ts';
import type { Vec3 } from './vec3.ts';

/*
 * A curved shape between two heights, its ends open or closed by discs. Rims and edges belong to
 * it: a root at a height is a hit, and where a disc ends on the surface the surface's root stands
 * for both, if it has one there.
 */

/** A hit of a shape with ends; one that is cut off is no hit at all. */
export interface FatedHit extends Hit {
  readonly fate: Fate;
}

/** How a method decides what is on which side of an end. */
export interface Ending {
  /** The sign of y − height at root k, whose rounded height is y. */
  readonly above: (k: number, y: number, height: number) => Sign;
  /** The point at an end's height, and f's sign there; null where f > 0 for certain. */
  readonly atHeight: (height: number) => AtHeight | null;
  /** The sign of (root k at t) − (the ray's t at this height, rounded to s). */
  readonly after: (k: number, t: number, height: number, s: number) => Sign;
}

/**
 * The roots of a surface with what becomes of each, and where the line goes through a cap:
 * ascending in t.
 *
 * @param hits all roots of the line, ascending.
 * @param verdict of the line and the whole surface.
 */
export function withEnds(
  hits: readonly Hit[],
  verdict: Verdict,
  { low, high, caps }: Cut,
  ray: Ray,
  ending: Ending,
): FatedHit[] {
  const found = hits.map((hit, k): FatedHit => {
    const y = hit.point[1];
    const inside = ending.above(k, y, low) >= 0 && ending.above(k, y, high) <= 0;
    return { ...hit, fate: inside ? 'hit' : 'cut' };
  });
  if (!caps || ray.direction[1] === 0) return found;
  const up = ray.direction[1] > 0;
  const order = up ? [low, high] : [high, low];
  const met = order.flatMap((height): { readonly hit: FatedHit; readonly height: number }[] => {
    const at = ending.atHeight(height);
    const rim = at?.side === 0 && verdict !== 'contained';
    if (at === null || at.side > 0 || rim) return [];
    const normal = [0, height === low ? -1 : 1, 0] as const;
    const { t, point } = at;
    return [{ hit: { t, point, normal, singular: false, fate: 'cap' }, height }];
  });
  return merged(found, met, ending.after);
}

function merged(
  roots: readonly FatedHit[],
  caps: readonly { readonly hit: FatedHit; readonly height: number }[],
  after: Ending['after'],
): FatedHit[] {
  const all: FatedHit[] = [];
  let k = 0;
  for (const { hit, height } of caps) {
    for (let root = roots[k]; root && after(k, root.t, height, hit.t) <= 0; root = roots[k]) {
      all.push(root);
      k += 1;
    }
    all.push(hit);
  }
  return [...all, ...roots.slice(k)];
}

const signOf = (x: number): Sign => (x > 0 ? 1 : x < 0 ? -1 : 0);

/**
 * Decided exactly, for roots and heights that are one of the two doubles around the exact number,
 * and it itself where that is a double: only an equal double leaves it open.
 *
 * @param line exact arithmetic, asked for only where doubles cannot tell.
 * @param q the surface's numbers, if it is a round quadric: for the filter.
 */
export function exactEnding(ray: Ray, q: Quadric | null, line: () => ExactLine): Ending {
  return {
    above: (k, y, height) => (y === height ? line().yVsHeight(k, height) : signOf(y - height)),
    atHeight(height) {
      const side = q ? capSide(q, ray, height) : 0;
      if (side > 0) return null;
      return (side < 0 ? placeAtHeight(ray, height) : null) ?? line().atHeight(height);
    },
    after: (k, t, height, s) => {
      const apart = Math.abs(t - s) > NEXT * Math.max(Math.abs(t), Math.abs(s)) + LEAST;
      return apart ? signOf(t - s) : line().rootVsHeight(k, height);
    },
  };
}

/** Two numbers that are off by a neighbour each have not changed places beyond this. */
const NEXT = 2 ** -50;
const LEAST = 2 ** -1072;

/** By the method's own doubles, as a program would that does not look closer. */
export function roundedEnding(ray: Ray, side: (at: Vec3) => number): Ending {
  const { origin: E, direction: d } = ray;
  return {
    above: (_, y, height) => signOf(y - height),
    atHeight(height) {
      const t = (height - E[1]) / d[1];
      const point: Vec3 = [E[0] + t * d[0], height, E[2] + t * d[2]];
      return { t, point, side: signOf(side(point)) };
    },
    after: (_, t, __, s) => signOf(t - s),
  };
}

/*
 * Is the point of the line at height h inside of (x−Cx)² + (z−Cz)² = a(h−Cy)² + ρ? Times dy², with
 * p = E − C, n = h − Ey, g = p dy + d n. u = 2^-53.
 *
 *   quantity              bound           reason
 *   p, n                  u of them       one difference
 *   gx, gz                4u Gx, 4u Gz    G = |p dy| + |d n|: products 2u, their sum
 *   gx², gz²              9u G²           2·4u, and the product
 *   R = a(h−Cy)² + ρ      7u Rm           a = c² u, the square 3u, product, ρ u, sum;
 *                                         Rm = |a|(h−Cy)² + ρ
 *   R dy²                 9u Rm dy²       two products more
 *   gx² + gz² − R dy²     11u of all      two sums more
 *
 * 16u has room for evaluating the bound. With the sum of all terms and dy² between 2^-400 and
 * 2^400, and |a| < 2^200, what a product loses below the doubles is below 2^-470 in f, which is
 * less than 16u·2^-400.
 */
const ERROR_CAP = 16 * 2 ** -53;
const LARGEST_CAP = 2 ** 400;
const LARGEST_FLARE = 2 ** 200;

const isMiddling = (x: number): boolean => x > 1 / LARGEST_CAP && x < LARGEST_CAP;

/** −1 or 1, inside or outside, where that is certain; 0 elsewhere. */
function capSide(q: Quadric, { origin: E, direction: d }: Ray, height: number): Sign {
  const n = height - E[1];
  const gx = (E[0] - q.Cx) * d[1] + d[0] * n;
  const gz = (E[2] - q.Cz) * d[1] + d[2] * n;
  const Gx = Math.abs((E[0] - q.Cx) * d[1]) + Math.abs(d[0] * n);
  const Gz = Math.abs((E[2] - q.Cz) * d[1]) + Math.abs(d[2] * n);
  const a = q.hasY ? (q.squared ? q.flare * q.flare : q.flare) : 0;
  const above = height - q.Cy;
  const bulge = a * (above * above);
  const rho = q.r * q.r;
  const speed = d[1] * d[1];
  const f = gx * gx + gz * gz - (bulge + rho) * speed;
  const size = Gx * Gx + Gz * Gz + (Math.abs(bulge) + rho) * speed;
  const sure = isMiddling(size) && isMiddling(speed) && Math.abs(a) < LARGEST_FLARE;
  return sure && Math.abs(f) > ERROR_CAP * size ? signOf(f) : 0;
}

/*
 * t = n/dy with n = h − Ey as two doubles: the quotient of the leading ones, and what remains of
 * the division, exact but for 2u of itself: 3u² of t. A coordinate E + t d as two doubles is off by
 * that of t d and 3u of its low part: 8u²(|X| + |t d|).
 */
const ERROR_PLACE = 8 * 2 ** -106;
const SMALLEST = 2 ** -400;

/** Faithful, or null where that is not certain. */
function placeAtHeight({ origin: E, direction: d }: Ray, height: number): AtHeight | null {
  const n = height - E[1];
  const t = n / d[1];
  const product = t * d[1];
  const rest = n - product - productError(t, d[1], product) + sumError(height, -E[1], n);
  const step = rest / d[1];
  const size = Math.abs(t);
  const certain = size > SMALLEST && size < 1 / SMALLEST && Math.abs(n) > SMALLEST;
  // A product of theirs that overflows makes the step NaN.
  if (!certain || !Number.isFinite(step)) return null;
  const along = (e: number, v: number): number => {
    if (v === 0) return e;
    const m = t * v;
    const x = e + m;
    const p = x + (sumError(e, m, x) + (productError(t, v, m) + step * v));
    const off = ERROR_PLACE * (Math.abs(x) + Math.abs(m)) + SMALLEST_PLACE;
    return off <= FAITHFUL_ONCE * Math.abs(p) ? p : Number.NaN;
  };
  const x = along(E[0], d[0]);
  const z = along(E[2], d[2]);
  if (Number.isNaN(x) || Number.isNaN(z)) return null;
  return { t: t + step + 0, point: [x + 0, height, z + 0], side: -1 };
}

const SMALLEST_PLACE = 2 ** -1070;
