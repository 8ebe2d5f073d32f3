import type { Rays } from '../batch/batch.ts';
import { type FatedHit, withEnds } from '../ends.ts';
import type { Fate, Hit, Sign } from '../intersection.ts';
import {
  InvalidInput,
  quote,
  refused,
  requireFields,
  requireFiniteVector,
  requireNonZero,
} from '../invalid-input.ts';
import { lazily } from '../lazily.ts';
import { DIRECT_ERROR, LARGEST, SMALLEST_DIRECT } from '../methods/certified/class.ts';
import { type ExactLine, exactLine, exactSide } from '../methods/exact-line.ts';
import { isSameSurface, isSecondNearer } from '../nearer.ts';
import type { Ray } from '../ray.ts';
import { type Cut, checkedSolid, type Ends } from '../shapes/checked.ts';
import type { ShapeDefinition } from '../shapes/define.ts';
import type { Quadric } from '../shapes/numbers.ts';
import { type Given, plainVector, type Vec3 } from '../vec3.ts';
import { curvedSurface, type Surface } from './lines.ts';
import {
  ANY,
  createHit,
  FAR,
  FIRST,
  type HitRoom,
  NEAR,
  OPEN,
  put,
  rootOf,
  UNPLACED,
} from './sharp.ts';

/** What a ray may be asked about a prepared shape. */
export interface PrepareOptions<S> {
  /** The least t that counts, in lengths of d: 0 unless given; −Infinity for the whole line. */
  readonly tMin?: number | undefined;
  /** The greatest t that counts: Infinity unless given. */
  readonly tMax?: number | undefined;
  /** As for `intersect`: the shape that every ray starts on, whose root there is no hit. */
  readonly from?: (Given<S> & Ends) | null | undefined;
}

/** A hit, with what became of the root. */
export interface PreparedHit extends Hit {
  readonly fate: Fate;
}

/**
 * A shape that many rays are asked about, one after the other. Rays as `intersect` takes them; what
 * else a ray holds is not looked at.
 */
export interface Prepared {
  /**
   * The hit with the least t from tMin to tMax; null where there is none. With `out` (`createHit`)
   * it is put there, and nothing is allocated unless doubles cannot tell.
   */
  first(ray: Given<Ray>): PreparedHit | null;
  first(ray: Given<Ray>, out: HitRoom): HitRoom | null;
  /** Every root from tMin to tMax, ascending, with its fate: also those that are cut off. */
  all(ray: Given<Ray>): readonly PreparedHit[];
  /** Whether there is a hit from tMin to tMax. */
  any(ray: Given<Ray>): boolean;
  /** Whether a point lies inside, or on the border; a flat shape has no inside. */
  inside(point: ArrayLike<number>): boolean;
  /** −1 inside, 0 on the border, 1 outside; null for a flat shape. By an exact sign. */
  side(point: ArrayLike<number>): Sign | null;
  /** `first` for many rays (`createRays`): t in `out`, NaN where there is none. */
  firsts(rays: Rays, out: Float64Array): void;
}

/**
 * `prepare` for these shapes and for `certified` only: a program that imports the shapes that it
 * needs, and this, holds nothing of the others. Made for curved ones: flat shapes are answered by
 * exact arithmetic here, which is slow.
 *
 * @param entries shapes of SHAPES, by their own names.
 * @see NUMERICS.md, section 5, the end: one ray after the other.
 * @example
 * const prepareBall = prepareWith(sphere);
 * const ball = prepareBall({ kind: 'sphere', center: [0, 0, 0], radius: 2 });
 * ball.first({ origin: [-5, 0, 0], direction: [1, 0, 0] })?.t; // → 3
 */
export function prepareWith<S extends { readonly kind: string }>(
  ...entries: readonly ShapeDefinition<S>[]
): (shape: Given<S> & Ends, options?: PrepareOptions<S> | null) => Prepared {
  return (shape, options) => {
    const entry = entryOf(entries, shape);
    const solid = ownSolid(entry, shape);
    const surface = curvedSurface(entry, solid.shape);
    return preparedBy(entry, solid, surface, rangeOf(entries, options));
  };
}

interface CheckedSolid<S> {
  readonly shape: S;
  readonly cut: Cut | null;
}

/** As checkedSolid, copied: the caller's may change. */
export function ownSolid<S extends { readonly kind: string }>(
  entry: ShapeDefinition<S>,
  given: Given<S> & Ends,
): CheckedSolid<S> {
  const { shape, cut } = checkedSolid(entry, given);
  const own = Object.entries(shape).map(([key, x]) => [key, Array.isArray(x) ? [...x] : x]);
  return { shape: Object.fromEntries(own) as S, cut };
}

/** The entry of a shape's kind. */
export function entryOf<S extends { readonly kind: string }>(
  entries: readonly ShapeDefinition<S>[],
  shape: { readonly kind?: unknown },
): ShapeDefinition<S> {
  const kind = shape?.kind;
  const entry = entries.find((one) => one.kind === kind);
  if (entry) return entry;
  if (kind === undefined || kind === null) throw refused('kind', '', undefined);
  throw new InvalidInput(`unknown shape ${quote(kind)}`);
}

/** Options that were checked. */
interface Range<S> {
  readonly tMin: number;
  readonly tMax: number;
  readonly from: S | null;
}

/** @param more options that the caller looks at. */
export function rangeOf<S extends { readonly kind: string }>(
  entries: readonly ShapeDefinition<S>[],
  options: PrepareOptions<S> | null | undefined,
  more: readonly string[] = [],
): Range<S> {
  if (options) requireFields('set of options', options, ['tMin', 'tMax', 'from', ...more]);
  const tMin = limit('tMin', options?.tMin ?? 0);
  const tMax = limit('tMax', options?.tMax ?? Number.POSITIVE_INFINITY);
  const from = options?.from ?? null;
  return { tMin, tMax, from: from && checkedSolid(entryOf(entries, from), from).shape };
}

function limit(name: string, x: unknown): number {
  if (typeof x !== 'number' || Number.isNaN(x)) throw refused(name, 'must be a number', x);
  return x;
}

/** The solid's answers by the roots that `surface` finds. */
export function preparedBy<S extends { readonly kind: string }>(
  entry: ShapeDefinition<S>,
  { shape, cut }: CheckedSolid<S>,
  surface: Surface,
  { tMin, tMax, from }: Range<S>,
): Prepared {
  const leaving = from !== null && isSameSurface(entry, shape, from);
  // A cut needs the point, and a start the other root.
  const ask = cut || leaving ? null : surface.ask;
  const { quadric, place, settle } = surface;

  function slowly(given: Given<Ray>): readonly PreparedHit[] {
    const ray = plainRay(given);
    const whole = lazily(() => exactLine(entry, shape, ray));
    const { verdict, hits } = surface.roots(ray, whole);
    const fated = cut
      ? withEnds(hits, verdict, cut, ray, surface.ending(ray, whole))
      : hits.map((hit): FatedHit => ({ ...hit, fate: 'hit' }));
    const start = leaving ? startOf(fated, surface.isExact ? whole : null) : null;
    let k = -1;
    return fated.filter((hit) => {
      if (hit.fate !== 'cap') k += 1;
      return hit !== start && isWithin(hit, k, whole);
    });
  }

  /** Faithful doubles are on the right side of another double, unless they are the same. */
  function isWithin({ t, fate, point }: FatedHit, k: number, whole: () => ExactLine): boolean {
    const beside = (x: number): Sign =>
      fate === 'cap' ? whole().heightVsT(point[1], x) : whole().rootVsT(k, x);
    // A root is a number, though its double may be infinite.
    const none = tMin === Number.POSITIVE_INFINITY || tMax === Number.NEGATIVE_INFINITY;
    if (none || t < tMin || t > tMax) return false;
    const finite = Number.isFinite(t) && surface.isExact;
    return (
      !(t === tMin && finite && beside(tMin) < 0) && !(t === tMax && finite && beside(tMax) > 0)
    );
  }

  const firstSlowly = (ray: Given<Ray>): PreparedHit | null =>
    slowly(ray).find(({ fate }) => fate !== 'cut') ?? null;

  const scratch = createHit();
  // Where no root below 0 counts, its sign tells which one is wanted.
  const earliest = tMin >= 0 ? FIRST : NEAR;
  const isHalfLine = tMin === 0 && tMax === Number.POSITIVE_INFINITY;

  /** What AskOne says of the first hit, in `room`; OPEN where only the slow road knows. */
  function quickly(ray: Ray, placed: boolean, room: HitRoom): number {
    if (!ask) return OPEN;
    let said = ask(ray, earliest, placed, room);
    if (said === OPEN) said = settle(ray, earliest, placed, room);
    if (said > 0 && room.t < tMin) {
      if (rootOf(said) === FAR) return 0;
      said = ask(ray, FAR, placed, room);
      if (said === OPEN) said = settle(ray, FAR, placed, room);
      if (said > 0 && room.t < tMin) return 0;
    }
    if (said <= 0) return said;
    if (room.t > tMax) return 0;
    return room.t > tMin && room.t < tMax ? said : OPEN;
  }

  /** t of the first hit; NaN where there is none. */
  function firstTime(ray: Given<Ray>): number {
    const said = quickly(ray as Ray, false, scratch);
    if (said > 0) return scratch.t;
    return said === 0 ? Number.NaN : (firstSlowly(ray)?.t ?? Number.NaN);
  }

  function any(ray: Given<Ray>): boolean {
    const said = ask && isHalfLine ? ask(ray as Ray, ANY, false, scratch) : OPEN;
    return said === OPEN ? !Number.isNaN(firstTime(ray)) : said > 0;
  }

  function first(ray: Given<Ray>): PreparedHit | null;
  function first(ray: Given<Ray>, out: HitRoom): HitRoom | null;
  function first(ray: Given<Ray>, out?: HitRoom): PreparedHit | null {
    const room = out ?? createHit();
    const said = quickly(ray as Ray, true, room);
    if (said === 0) return null;
    if (said > 0) {
      if ((said & UNPLACED) !== 0) placeIn(room, ray, rootOf(said) - 1);
      room.fate = 'hit';
      return room;
    }
    const found = firstSlowly(ray);
    if (!found || !out) return found;
    put(out, found);
    out.fate = found.fate;
    return out;
  }

  function placeIn(room: HitRoom, given: Given<Ray>, k: number): void {
    const ray = plainRay(given);
    const hit = place(
      ray,
      k,
      room.t,
      lazily(() => exactLine(entry, shape, ray)),
    );
    put(room, hit);
  }

  function side(given: ArrayLike<number>): Sign | null {
    requireFiniteVector('point', given);
    const at = plainVector(given);
    if (cut && (at[1] < cut.low || at[1] > cut.high)) return 1;
    const sign = (quadric ? roundedSide(quadric, at) : 0) || exactSide(entry, shape, at);
    const isAtEnd = cut !== null && (at[1] === cut.low || at[1] === cut.high);
    return sign !== null && sign < 0 && isAtEnd ? 0 : sign;
  }

  return {
    first,
    all: slowly,
    any,
    inside(point) {
      const sign = side(point);
      return sign !== null && sign <= 0;
    },
    side,
    firsts(rays, out) {
      const E: [number, number, number] = [0, 0, 0];
      const d: [number, number, number] = [0, 0, 0];
      const ray = { origin: E, direction: d };
      const { Ex, Ey, Ez, dx, dy, dz } = rays;
      for (let i = 0; i < rays.count; i++) {
        E[0] = Ex[i] as number;
        E[1] = Ey[i] as number;
        E[2] = Ez[i] as number;
        d[0] = dx[i] as number;
        d[1] = dy[i] as number;
        d[2] = dz[i] as number;
        out[i] = firstTime(ray);
      }
    },
  };
}

/** Of the hits that a ray may start at, the one nearest to t = 0; null where there is none. */
const startOf = (hits: readonly FatedHit[], whole: (() => ExactLine) | null): FatedHit | null =>
  hits
    .filter(({ fate }) => fate !== 'cut')
    .reduce<FatedHit | null>((near, far) => {
      if (!near) return far;
      const isRoots = near.fate === 'hit' && far.fate === 'hit';
      return isSecondNearer(near.t, far.t, () => (isRoots && whole ? whole().signs() : null))
        ? far
        : near;
    }, null);

function plainRay(given: Given<Ray>): Ray {
  const { origin, direction } = given ?? {};
  requireFiniteVector('origin', origin);
  requireFiniteVector('direction', direction);
  requireNonZero('direction', direction);
  return { origin: plainVector(origin), direction: plainVector(direction) };
}

/**
 * −1 or 1 where C = px² + pz² − a py² − ρ is on one side for certain, by the bound of class.ts, 7u
 * of the sum of its terms; 0 elsewhere. What underflows is far below SMALLEST_DIRECT.
 */
function roundedSide(q: Quadric, at: Vec3): Sign {
  const a = q.hasY ? (q.squared ? q.flare * q.flare : q.flare) : 0;
  const px = at[0] - q.Cx;
  const py = at[1] - q.Cy;
  const pz = at[2] - q.Cz;
  const away = px * px + pz * pz;
  const above = q.hasY ? a * (py * py) : 0;
  const rho = q.r * q.r;
  const C = away - above - rho;
  const Cm = away + Math.abs(above) + rho;
  const sure = Cm < LARGEST && Math.abs(C) > DIRECT_ERROR * Cm + SMALLEST_DIRECT;
  return sure ? (C < 0 ? -1 : 1) : 0;
}

/**
 * The first hit of one ray among several shapes; the earlier one of two with the same t.
 *
 * @param list prepared shapes, each with its own tMin and tMax.
 * @param ray as for `intersect`.
 * @returns the place in the list, a whole number ≥ 0, and the hit; null where nothing is hit.
 * @see NUMERICS.md, section 5, the end: one ray after the other.
 * @example
 * const ball = prepare({ kind: 'sphere', center: [0, 0, 0], radius: 1 });
 * const floor = prepare({ kind: 'plane', normal: [0, 1, 0], point: [0, -1, 0] });
 * firstAmong([floor, ball], { origin: [0, 4, 0], direction: [0, -1, 0] })?.index; // → 1
 */
export function firstAmong(
  list: readonly Prepared[],
  ray: Given<Ray>,
): { readonly index: number; readonly hit: PreparedHit } | null {
  let nearest: { readonly index: number; readonly hit: PreparedHit } | null = null;
  list.forEach((one, index) => {
    const hit = one.first(ray);
    if (hit && (nearest === null || hit.t < nearest.hit.t)) nearest = { index, hit };
  });
  return nearest;
}
