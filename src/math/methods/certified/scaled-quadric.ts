import { type Quadric, quadricOf, stillHolds } from '../../batch/quadric.ts';
import { productError, SPLITTER, squareError } from '../../float/eft.ts';
import type { Shape } from '../../shapes/index.ts';
import { type Lattice, latticeOf } from './lattice.ts';

/**
 * A curved shape as the certified kernels take it: (x−Cx)² + (z−Cz)² = ±(k(y−Cy))² + ρ with k = √|a|, so that all three
 * coordinates are alike. k = k1 + k2, k1 with at most 26 bits, off by less than 2^-78 k; for a cone k = |c| exactly.
 * ρ = rho + rhoLow exactly.
 */
export interface CertifiedQuadric {
  readonly k: number;
  readonly k1: number;
  readonly k2: number;
  /** The sign of a. */
  readonly sign: number;
  readonly rho: number;
  readonly rhoLow: number;
  /** a rounded to a double. */
  readonly flare: number;
  /** Whether the fast stages may be used: see BOX. */
  readonly inBox: boolean;
  /** What the loops need of all that, as doubles for certain. */
  readonly numbers: Float64Array;
  /** The shape in units of its own, if it is an ordinary one. */
  readonly lattice: Lattice | null;
}

/**
 * The fast stages work on rays and shapes whose numbers lie between 2^-100 and 2^100 (zero where that makes sense): no
 * product of theirs can overflow, and what underflows is far below their absolute terms. The rest is scaled first.
 */
export const BOX = 2 ** 100;

/** Where in `numbers` each is; `flare` is a rounded, `flareLow` the rest of it, and `wide` is max(1, k). */
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

const KEPT = 8;
const kept: { readonly q: Quadric; readonly c: CertifiedQuadric }[] = [];
let oldest = 0;

/** One ray at a time, the same few shapes are asked about again and again: the latest ones are kept. */
export function certifiedQuadric(q: Quadric): CertifiedQuadric {
  for (const { q: known, c } of kept) if (same(known, q)) return c;
  const c = prepared(q);
  kept[oldest] = { q, c };
  oldest = (oldest + 1) % KEPT;
  return c;
}

/** A shape's numbers, and how the kernels take them. */
export interface ReadQuadric {
  readonly kind: Shape['kind'];
  readonly q: Quadric;
  readonly c: CertifiedQuadric;
}

let latest: ReadQuadric | null = null;

/** The shape, read as a quadric; null where it is none. The last one is recognized by its numbers: a shape is its caller's and may change. */
export function readQuadric(shape: Shape): ReadQuadric | null {
  if (latest !== null && stillHolds(latest.q, latest.kind, shape)) return latest;
  const q = quadricOf(shape);
  if (!q) return null;
  latest = { kind: shape.kind, q, c: certifiedQuadric(q) };
  return latest;
}

const same = (a: Quadric, b: Quadric): boolean =>
  a.Cx === b.Cx &&
  a.Cy === b.Cy &&
  a.Cz === b.Cz &&
  a.r === b.r &&
  a.flare === b.flare &&
  a.hasY === b.hasY &&
  a.squared === b.squared;

function prepared(q: Quadric): CertifiedQuadric {
  const rho = q.r * q.r;
  const size = Math.abs(q.flare);
  const s = q.squared ? size : Math.sqrt(size);
  // √a to twice the digits: the remainder a − s² is a double, and so is its half over s but for one rounding.
  const p = s * s;
  const rest = q.squared || s === 0 ? 0 : (size - p - squareError(s, p)) / (2 * s);
  const big = SPLITTER * s;
  const k1 = big - (big - s);
  const k2 = s - k1 + rest;
  const sign = q.squared || q.flare > 0 ? 1 : -1;
  const rhoLow = productError(q.r, q.r, rho);
  const flare = q.squared ? q.flare * q.flare : q.flare;
  const wide = Math.max(1, s);
  const flareLow = q.squared ? squareError(q.flare, flare) : 0;
  return {
    k: s,
    k1,
    k2,
    sign,
    rho,
    rhoLow,
    numbers: Float64Array.of(
      ...[q.Cx, q.Cy, q.Cz, s, k1, k2, sign, rho, rhoLow],
      ...[flare, wide, flareLow],
    ),
    flare,
    inBox: (s === 0 || (s < BOX && s > 1 / BOX)) && (q.r === 0 || (q.r < BOX && q.r > 1 / BOX)),
    lattice: latticeOf(q),
  };
}
