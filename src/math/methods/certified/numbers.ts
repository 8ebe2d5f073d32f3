import type { RootSlot } from '../../batch/exact-quadric.ts';
import { numbersOf, type Quadric } from '../../batch/quadric.ts';
import { exponentOf, powerOfTwo } from '../../float/bits.ts';
import { SPLITTER, squareError } from '../../float/eft.ts';
import type { Shape } from '../../shapes/index.ts';
import type { QuadricNumbers } from '../../shapes/numbers.ts';

/* What all stages share. u = 2^-53. */

/**
 * hi + lo, off by η of itself, may be rounded to hi as long as η < u/2, u = 2^-53: hi is off by
 * half a place at most, and a place is at least u of the number (just below a power of two), so
 * that the other half, u/2, is left for the truth to stay between hi's neighbours. Half of that is
 * room for η being worked out in doubles. A root of 0 must be 0 exactly.
 *
 * Comparisons are written so that NaN fails them. But a quotient that serves as a test, as η does,
 * needs a finite denominator: x/∞ is 0 and passes any. So each of them asks for one, or has it by
 * what was asked before: algebra.ts by LARGE, planar.ts, recentred.ts and refined.ts by the box
 * (products of five of its numbers, with a, are below 2^700), grids.ts by its splitting of A,
 * units.ts by the gap of the roots (see there).
 */
export const FAITHFUL = 2 ** -55;

/** Half a place of a number just below 1: u, and its square. */
export const U = 2 ** -53;
export const UU = 2 ** -106;

/**
 * A root that is rounded once is faithful if it was off by less than u|t|/2 before: neighbours are
 * at least u|t| apart. A tenth is left for evaluating the bound.
 */
export const FAITHFUL_ONCE = 0.9 * 2 ** -54;

/** Multiples of a size that cut numbers to 25 or 26 bits of it, and p to a grid for both roots. */
export const GRID_25 = 2 ** 29;
export const GRID_26 = 2 ** 28;
export const GRID_P = 2 ** 6;

/*
 * A loop takes its bounds before it begins from an array of doubles. Of a module's constants a
 * bundler makes variables, and of an object's fields V8 does not know whether they are small
 * integers: both would be looked up at each use.
 */

/** Rays that the fast stages leave open, in `open[0 … count − 1]`. */
export interface OpenRays {
  count: number;
  open: Int32Array;
}

/** Roots and the stage that stood for them. */
export interface CertifiedSlot extends RootSlot {
  exact: boolean;
}

/** A slot without roots. */
export const certifiedSlot = (): CertifiedSlot => ({
  t0: Number.NaN,
  t1: Number.NaN,
  exact: false,
});

/**
 * A curved shape as the certified kernels take it: (x−Cx)² + (z−Cz)² = ±(k(y−Cy))² + ρ with k =
 * √|a|, so that all three coordinates are alike. k = k1 + k2, k1 with at most 26 bits, off by less
 * than 2^-78 k; for a cone k = |c| exactly. ρ = rho + rhoLow exactly.
 */
export interface CertifiedQuadric {
  /** Whether the fast stages may be used: see BOX. */
  readonly inBox: boolean;
  /** All that, and the sign of a, as doubles for certain. */
  readonly numbers: Float64Array;
  /** The shape in units of its own, if it is an ordinary one. */
  readonly lattice: Lattice | null;
  /** What from-surface.ts needs of it, once that has been asked for. */
  surface: Float64Array | null;
}

/**
 * The fast stages work on rays and shapes whose numbers lie between 2^-100 and 2^100 (zero where
 * that makes sense): no product of theirs can overflow, and what underflows is far below their
 * absolute terms. The rest is scaled first.
 */
export const BOX = 2 ** 100;

/**
 * Where in `numbers` each is; `flare` is a rounded, `flareLow` the rest of it, and `wide` is max(1,
 * k).
 */
export const AT_SCALED = {
  Cx: 0,
  Cy: 1,
  Cz: 2,
  k: 3,
  k1: 4,
  k2: 5,
  sign: 6,
  rho: 7,
  rhoLow: 8,
  flare: 9,
  wide: 10,
  flareLow: 11,
} as const;

const SCALED_COUNT = 12;

const KEPT = 8;
const kept: { readonly q: Quadric; readonly c: CertifiedQuadric }[] = [];
let oldest = 0;

/**
 * One ray at a time, the same few shapes are asked about again and again: the latest ones are kept.
 */
export function certifiedQuadric(q: Quadric): CertifiedQuadric {
  for (const { q: known, c } of kept) if (same(known, q)) return c;
  const c = prepared(q);
  kept[oldest] = { q, c };
  oldest = (oldest + 1) % KEPT;
  return c;
}

const same = (a: Quadric, b: Quadric): boolean =>
  a.Cx === b.Cx &&
  a.Cy === b.Cy &&
  a.Cz === b.Cz &&
  a.r === b.r &&
  a.flare === b.flare &&
  a.hasY === b.hasY &&
  a.squared === b.squared;

/** Numbers to be filled by `put`. */
type Room = { -readonly [Field in keyof CertifiedQuadric]: CertifiedQuadric[Field] } & {
  readonly units: Lattice;
  /** The powers of two that the units are made for. */
  size: number;
  stretch: number;
};

function room(): Room {
  const units = new Float64Array(ROOM_COUNT);
  units[AT_LATTICE.cutD] = ROUND * UNIT_OF_DIRECTION;
  units[AT_LATTICE.largestDirection] = (LARGEST_LENGTH * UNIT_OF_DIRECTION) ** 2;
  units[AT_LATTICE.smallestDirection] = (SMALLEST_DIRECTION * UNIT_OF_DIRECTION) ** 2;
  return {
    inBox: false,
    numbers: new Float64Array(SCALED_COUNT),
    units,
    size: Number.NaN,
    stretch: 0,
    lattice: null,
    surface: null,
  };
}

function prepared(q: Quadric): CertifiedQuadric {
  const c = room();
  put(c, q);
  return c;
}

function put(c: Room, q: Quadric): void {
  const rho = q.r * q.r;
  const size = Math.abs(q.flare);
  const s = q.squared ? size : Math.sqrt(size);
  // √a to twice the digits: the remainder a − s² is a double, and so is its half over s but for one
  // rounding.
  const p = s * s;
  const rest = q.squared || s === 0 ? 0 : (size - p - squareError(s, p)) / (2 * s);
  const big = SPLITTER * s;
  const k1 = big - (big - s);
  const k2 = s - k1 + rest;
  const sign = q.squared || q.flare > 0 ? 1 : -1;
  const rhoLow = squareError(q.r, rho);
  const flare = q.squared ? q.flare * q.flare : q.flare;
  const flareLow = q.squared ? squareError(q.flare, flare) : 0;
  const { numbers } = c;
  numbers[AT_SCALED.Cx] = q.Cx;
  numbers[AT_SCALED.Cy] = q.Cy;
  numbers[AT_SCALED.Cz] = q.Cz;
  numbers[AT_SCALED.k] = s;
  numbers[AT_SCALED.k1] = k1;
  numbers[AT_SCALED.k2] = k2;
  numbers[AT_SCALED.sign] = sign;
  numbers[AT_SCALED.rho] = rho;
  numbers[AT_SCALED.rhoLow] = rhoLow;
  numbers[AT_SCALED.flare] = flare;
  numbers[AT_SCALED.wide] = Math.max(1, s);
  numbers[AT_SCALED.flareLow] = flareLow;
  c.inBox = (s === 0 || (s < BOX && s > 1 / BOX)) && (q.r === 0 || (q.r < BOX && q.r > 1 / BOX));
  c.lattice = putLattice(c, q, flare, flareLow, rho, rhoLow) ? c.units : null;
  c.surface = null;
}

/*
 * Ordinary rays are cut so that their leading parts are whole multiples of a unit: x = whole + rest
 * with |rest| ≤ 1/2 unit, and sums, products and squares of the whole parts are exact as long as
 * they stay below 2^53 units. The units are powers of two that depend on the shape alone, so a
 * ray's answer does not depend on its neighbours in the batch. That of y is smaller by the power of
 * two, `up`, that brings a into [1/4, 1): so all three coordinates are alike, and bounds speak of y
 * times `up`. (x + σ) − σ with σ = 1.5·2^52 units is x cut to units.
 */

/** |d| = 1 has 2^8 units, and a t that leads over the shape's size 2^9 or so. */
const DIRECTION_BITS = 8;
/** 2^-8: a unit, for |d| = 1. */
export const UNIT_OF_DIRECTION = 2 ** -DIRECTION_BITS;
/**
 * The shape's size has 2^17 units or up to twice as many: points up to 30 sizes from the centre
 * have fewer than 2^23.
 */
const SIZE_BITS = 17;
/** Shapes beyond these powers of two are not ordinary. */
const LARGEST_EXPONENT = 60;
const LARGEST_STRETCH = 30;
/** In units: beyond, E and C could not be cut exactly any more. */
const LARGEST_LENGTH = 2 ** 45;
/**
 * In units: some component of d has then at least 2^3 units, so that t·d shows it when t is too
 * large to be cut.
 */
const SMALLEST_DIRECTION = 2 ** 4;
/** In units: beyond, the sums of a point's whole parts might not be exact (units.ts). */
const LARGEST_SIZE = 2 ** 24;
/** In units of t: how far apart the roots must be (units.ts). */
const LEAST_GAP = 20;
/** In units: far above what may be lost to underflow, and below what matters. */
const SMALLEST_IN_UNITS = 2 ** -100;

/**
 * A shape with its units, as one array of doubles: of an object's fields V8 would not know inside a
 * loop whether they are small integers. Where each number is, is told by AT_LATTICE.
 */
export type Lattice = Float64Array;

/**
 * Where in a Lattice each number is. `cut`… cut d, dy, E, Ey and t to their units. C and ρ are cut
 * into `whole` and `rest`; a = a1 + a2 + a3, in stretched y a1 in 32nds and a2 in 2^11ths, |a2| ≤
 * 2^-6, |a3| ≤ 2^-12. `two` are two units of t; the others are the limits above, as lengths or
 * their squares.
 */
export const AT_LATTICE = {
  cutD: 0,
  cutDy: 1,
  cutE: 2,
  cutEy: 3,
  cutT: 4,
  Cx: 5,
  Cy: 6,
  Cz: 7,
  wholeX: 8,
  wholeY: 9,
  wholeZ: 10,
  restX: 11,
  restY: 12,
  restZ: 13,
  a: 14,
  a1: 15,
  a2: 16,
  a3: 17,
  rho: 18,
  wholeRho: 19,
  restRho: 20,
  up: 21,
  two: 22,
  smallest: 23,
  largestDirection: 24,
  smallestDirection: 25,
  largestSize: 26,
  leastGap: 27,
} as const;

const LATTICE_COUNT = 28;

/**
 * x rounded to a whole number, for |x| < 2^51: adding 1.5·2^52 leaves no room for a fraction.
 * Math.round would make V8 convert to int32 and back.
 */
export const ROUND = 1.5 * 2 ** 52;
export const cut = (x: number, unit: number): number => x + ROUND * unit - ROUND * unit;

/** Null for a shape whose numbers are not ordinary. */
export const latticeOf = (q: Quadric): Lattice | null => prepared(q).lattice;

const LARGEST_POWER = LARGEST_EXPONENT + SIZE_BITS;
let powers: Float64Array | null = null;

/** 2^k for |k| ≤ LARGEST_POWER: what was written to memory in halves is slow to be read. */
function power(k: number): number {
  powers ??= Float64Array.from({ length: 2 * LARGEST_POWER + 1 }, (_, i) =>
    powerOfTwo(i - LARGEST_POWER),
  );
  return powers[k + LARGEST_POWER] as number;
}

/** Beside those of AT_LATTICE: what cuts a, and ρ, and the greatest coordinate of a centre. */
const CUT_A1 = LATTICE_COUNT;
const CUT_A2 = LATTICE_COUNT + 1;
const CUT_RHO = LATTICE_COUNT + 2;
const FARTHEST = LATTICE_COUNT + 3;
const ROOM_COUNT = LATTICE_COUNT + 4;

/** Puts what depends on the units alone. */
function putUnits(lattice: Lattice, size: number, stretch: number): void {
  const up = power(stretch);
  const down = 1 / up;
  const unit = power(size - SIZE_BITS);
  const unitD = UNIT_OF_DIRECTION;
  const unitT = unit / unitD;
  const square = up * up;
  const area = unit * unitD;
  lattice[AT_LATTICE.cutDy] = ROUND * unitD * down;
  lattice[AT_LATTICE.cutE] = ROUND * unit;
  lattice[AT_LATTICE.cutEy] = ROUND * unit * down;
  lattice[AT_LATTICE.cutT] = ROUND * unitT;
  lattice[AT_LATTICE.up] = up;
  lattice[AT_LATTICE.two] = 2 * unitT;
  lattice[AT_LATTICE.smallest] = SMALLEST_IN_UNITS * (area * area);
  lattice[AT_LATTICE.largestSize] = LARGEST_SIZE * unit;
  lattice[AT_LATTICE.leastGap] = LEAST_GAP * unitT;
  lattice[CUT_A1] = ROUND * (square / 2 ** 5);
  lattice[CUT_A2] = ROUND * (square / 2 ** 11);
  lattice[CUT_RHO] = ROUND * (unit * unit);
  lattice[FARTHEST] = LARGEST_LENGTH * unit;
}

/**
 * False for a shape whose numbers are not ordinary; the lattice is then of no use. Shapes in turn
 * often have the same units: these are not waited for.
 */
function putLattice(
  c: Room,
  { Cx, Cy, Cz, r }: Quadric,
  flare: number,
  flareLow: number,
  rho: number,
  rhoLow: number,
): boolean {
  const lattice = c.units;
  const size = exponentOf(r || 1);
  const stretch = flare === 0 ? 0 : (exponentOf(flare) + 2) >> 1;
  if (!(Math.abs(size) <= LARGEST_EXPONENT && Math.abs(stretch) <= LARGEST_STRETCH)) return false;
  if (size !== c.size || stretch !== c.stretch) {
    putUnits(lattice, size, stretch);
    c.size = size;
    c.stretch = stretch;
  }
  const up = lattice[AT_LATTICE.up] as number;
  const farthest = Math.max(Math.abs(Cx), Math.abs(Cy) * up, Math.abs(Cz));
  if (!(farthest < (lattice[FARTHEST] as number))) return false;
  const cutE = lattice[AT_LATTICE.cutE] as number;
  const cutEy = lattice[AT_LATTICE.cutEy] as number;
  const cutA1 = lattice[CUT_A1] as number;
  const cutA2 = lattice[CUT_A2] as number;
  const cutRho = lattice[CUT_RHO] as number;
  const wholeX = Cx + cutE - cutE;
  const wholeY = Cy + cutEy - cutEy;
  const wholeZ = Cz + cutE - cutE;
  const a1 = flare + cutA1 - cutA1;
  const rest = flare - a1;
  const a2 = rest + cutA2 - cutA2;
  const wholeRho = rho + cutRho - cutRho;
  lattice[AT_LATTICE.Cx] = Cx;
  lattice[AT_LATTICE.Cy] = Cy;
  lattice[AT_LATTICE.Cz] = Cz;
  lattice[AT_LATTICE.wholeX] = wholeX;
  lattice[AT_LATTICE.wholeY] = wholeY;
  lattice[AT_LATTICE.wholeZ] = wholeZ;
  lattice[AT_LATTICE.restX] = Cx - wholeX;
  lattice[AT_LATTICE.restY] = Cy - wholeY;
  lattice[AT_LATTICE.restZ] = Cz - wholeZ;
  lattice[AT_LATTICE.a] = flare;
  lattice[AT_LATTICE.a1] = a1;
  lattice[AT_LATTICE.a2] = a2;
  lattice[AT_LATTICE.a3] = rest - a2 + flareLow;
  lattice[AT_LATTICE.rho] = rho;
  lattice[AT_LATTICE.wholeRho] = wholeRho;
  lattice[AT_LATTICE.restRho] = rho - wholeRho + rhoLow;
  return true;
}

/** A shape's numbers, and how the kernels take them. */
interface ReadQuadric {
  q: Quadric;
  readonly c: Room;
}

let latestKind: Shape['kind'] | null = null;
let reader: QuadricNumbers<Shape> | null = null;
let latest: ReadQuadric | null = null;
let isHeld = false;

/**
 * The shape, read as a quadric; null where it is none. The last one is known by its numbers, while
 * these hold: a shape is its caller's and may change. `c` holds until the next call: the numbers of
 * thousands of shapes would take longer to fetch from memory than to make anew, in one place.
 */
export function readQuadric(shape: Shape): ReadQuadric | null {
  if (shape.kind !== latestKind) {
    latestKind = shape.kind;
    reader = numbersOf(latestKind);
    isHeld = false;
  }
  if (!reader) return null;
  if (isHeld && latest !== null && reader.holds(shape, latest.q)) return latest;
  const q = reader.read(shape);
  latest ??= { q, c: room() };
  latest.q = q;
  put(latest.c, q);
  isHeld = true;
  return latest;
}
