import type { Dyadic } from '../exact/dyadic.ts';
import { bitLength, isqrt } from '../exact/isqrt.ts';
import { settled, toNumber } from '../exact/round.ts';
import { decompose, type Parts } from '../float/bits.ts';
import { CONTAINED, NONE, ONE, TANGENT, TWO } from './batch.ts';
import type { Quadric } from './quadric.ts';

/** The roots of one ray, ascending, NaN where there is none. */
export interface RootSlot {
  t0: number;
  t1: number;
}

/** Where only the first root from tMin to tMax is wanted. */
export interface Within {
  readonly tMin: number;
  readonly tMax: number;
}

const ONE_MORE: Dyadic = { m: 1n, e: 0 };
const ZERO_PARTS: Parts = { m: 0n, e: 0 };

/** parts as a whole number of 2^e; e must not lie above their own exponent. */
const wholeOf = ({ m, e }: Parts, unit: number): bigint => (m === 0n ? 0n : m << BigInt(e - unit));

/** The lesser exponent; of 0 it counts as infinite. */
const lower = (e: number, { m, e: other }: Parts): number => (m !== 0n && other < e ? other : e);
const unitOf = (e: number): number => (e === Number.POSITIVE_INFINITY ? 0 : e);

interface ShapeParts {
  readonly q: Quadric;
  readonly cx: Parts;
  readonly cy: Parts;
  readonly cz: Parts;
  readonly r: Parts;
  readonly flare: Parts;
  /** The least exponent among centre and radius. */
  readonly least: number;
}

/** Of the last shape that was asked for; this is a memo only. */
let last: ShapeParts | null = null;

function partsOf(q: Quadric): ShapeParts {
  if (last?.q === q) return last;
  const [cx, cz, r] = [q.Cx, q.Cz, q.r].map(decompose) as [Parts, Parts, Parts];
  const cy = q.hasY ? decompose(q.Cy) : ZERO_PARTS;
  const least = [cx, cy, cz, r].reduce(lower, Number.POSITIVE_INFINITY);
  last = { q, cx, cy, cz, r, flare: decompose(q.flare), least };
  return last;
}

/**
 * One ray exactly. All lengths are whole multiples of one power of two 2^l, the direction's
 * components of another, 2^k; then A t² + 2bt + C = 0 has whole coefficients for t in units of 2^(l
 * − k), and a factor 2^-e of a = m·2^e < 1 is multiplied through. The sign of b² − AC is the class,
 * and exact/round.ts rounds (−b ± √(b² − AC))/A once.
 *
 * @param within the lesser of two roots that is within, is all that is found; null: both are.
 */
export function solveExactly(
  q: Quadric,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: RootSlot,
  within: Within | null = null,
): number {
  const { cx, cy, cz, r, flare, least } = partsOf(q);
  const ex = decompose(Ex);
  const ez = decompose(Ez);
  const ey = q.hasY ? decompose(Ey) : ZERO_PARTS;
  const l = unitOf(lower(lower(lower(least, ex), ey), ez));
  const x = decompose(dx);
  const y = q.hasY ? decompose(dy) : ZERO_PARTS;
  const z = decompose(dz);
  const k = unitOf(lower(lower(lower(Number.POSITIVE_INFINITY, x), y), z));
  const px = wholeOf(ex, l) - wholeOf(cx, l);
  const pz = wholeOf(ez, l) - wholeOf(cz, l);
  const radius = wholeOf(r, l);
  const X = wholeOf(x, k);
  const Z = wholeOf(z, k);
  let A = X * X + Z * Z;
  let b = X * px + Z * pz;
  let C = px * px + pz * pz - radius * radius;
  if (flare.m !== 0n) {
    const Y = wholeOf(y, k);
    const py = wholeOf(ey, l) - wholeOf(cy, l);
    const e = q.squared ? 2 * flare.e : flare.e;
    let a = q.squared ? flare.m * flare.m : flare.m;
    if (e < 0) {
      const up = BigInt(-e);
      A <<= up;
      b <<= up;
      C <<= up;
    } else a <<= BigInt(e);
    const aY = a * Y;
    A -= aY * Y;
    b -= aY * py;
    C -= a * py * py;
  }
  return rootsOf(A, b, C, l - k, slot, within);
}

/** The real roots of A t² + 2bt + C, times 2^e, each rounded once. */
function rootsOf(
  A: bigint,
  b: bigint,
  C: bigint,
  e: number,
  slot: RootSlot,
  within: Within | null,
): number {
  slot.t0 = Number.NaN;
  slot.t1 = Number.NaN;
  if (A === 0n) {
    if (b === 0n) return C === 0n ? CONTAINED : NONE;
    slot.t0 = ratio(-C, b, e - 1);
    return ONE;
  }
  const D = b * b - A * C;
  if (D < 0n) return NONE;
  if (D === 0n) {
    slot.t0 = ratio(-b, A, e);
    return TANGENT;
  }
  twoRoots(A, b, C, D, e, slot, within);
  return TWO;
}

/** Bits of D under the root, or one more: then the root has 64, the first of which is set. */
const BITS = 127;

/**
 * With q = −(b ± √D), the sign so that nothing cancels, the roots are q/A and C/q. q by the first
 * 64 bits of √D is off by less than a part in 2^63: enough to know the nearest double, unless a
 * midpoint is near. Then the exact surd is compared with it.
 */
function twoRoots(
  A: bigint,
  b: bigint,
  C: bigint,
  D: bigint,
  e: number,
  slot: RootSlot,
  within: Within | null,
): void {
  const half = (bitLength(D) - BITS) >> 1;
  const up = BigInt(2 * half);
  const root = isqrt(half < 0 ? D << -up : D >> up);
  const minus = b < 0n ? -b : b;
  const size = half < 0 ? (minus << BigInt(-half)) + root : minus + (root << BigInt(half));
  const q: Dyadic = { m: b < 0n ? size : -size, e: half < 0 ? half : 0 };
  const u: Dyadic = { m: -b, e };
  const w: Dyadic = { m: A, e: 0 };
  const d: Dyadic = { m: D, e: 0 };
  const positive: Dyadic = { m: 1n, e };
  const negative: Dyadic = { m: -1n, e };
  const [own, other] = b < 0n ? [positive, negative] : [negative, positive];
  const byRatio = (): number => settled({ u, v: own, w, D: d }, { m: q.m, e: q.e + e }, w);
  const byProduct = (): number =>
    C === 0n ? 0 : settled({ u, v: other, w, D: d }, { m: C, e }, q);
  const [near, far] = b < 0n !== A > 0n ? [byRatio, byProduct] : [byProduct, byRatio];
  slot.t0 = near();
  if (within && slot.t0 >= within.tMin && slot.t0 <= within.tMax) return;
  slot.t1 = far();
}

const ZERO: Dyadic = { m: 0n, e: 0 };

const ratio = (top: bigint, bottom: bigint, e: number): number =>
  toNumber({ u: { m: top, e }, v: ZERO, w: { m: bottom, e: 0 }, D: ONE_MORE });
