import type { Dyadic } from '../exact/dyadic.ts';
import { toNumber } from '../exact/round.ts';
import { decompose, type Parts } from '../float/bits.ts';
import { CONTAINED, NONE, ONE, TANGENT, TWO } from './batch.ts';
import type { Quadric } from './quadric.ts';

/** The roots of one ray, ascending, NaN where there is none. */
export interface RootSlot {
  t0: number;
  t1: number;
}

const ONE_MORE: Dyadic = { m: 1n, e: 0 };
const ZERO_PARTS: Parts = { m: 0n, e: 0 };

/** parts as a whole number of 2^e; e must not lie above their own exponent. */
const wholeOf = ({ m, e }: Parts, unit: number): bigint => (m === 0n ? 0n : m << BigInt(e - unit));

/** The least exponent among numbers that are not 0. */
function leastExponent(...parts: readonly Parts[]): number {
  let least = Number.POSITIVE_INFINITY;
  for (const { m, e } of parts) if (m !== 0n && e < least) least = e;
  return least === Number.POSITIVE_INFINITY ? 0 : least;
}

/**
 * One ray exactly. All lengths are whole multiples of one power of two 2^l, the direction's
 * components of another, 2^k; then A t² + 2bt + C = 0 has whole coefficients for t in units of 2^(l
 * − k), and a factor 2^-e of a = m·2^e < 1 is multiplied through. The sign of b² − AC is the class,
 * and exact/round.ts rounds (−b ± √(b² − AC))/A once.
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
): number {
  const ex = decompose(Ex);
  const ez = decompose(Ez);
  const cx = decompose(q.Cx);
  const cz = decompose(q.Cz);
  const ey = q.hasY ? decompose(Ey) : ZERO_PARTS;
  const cy = q.hasY ? decompose(q.Cy) : ZERO_PARTS;
  const r = decompose(q.r);
  const l = leastExponent(ex, ey, ez, cx, cy, cz, r);
  const x = decompose(dx);
  const y = q.hasY ? decompose(dy) : ZERO_PARTS;
  const z = decompose(dz);
  const k = leastExponent(x, y, z);
  const px = wholeOf(ex, l) - wholeOf(cx, l);
  const pz = wholeOf(ez, l) - wholeOf(cz, l);
  const rho = wholeOf(r, l) ** 2n;
  const X = wholeOf(x, k);
  const Z = wholeOf(z, k);
  let A = X * X + Z * Z;
  let b = X * px + Z * pz;
  let C = px * px + pz * pz - rho;
  const flare = decompose(q.flare);
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
  return rootsOf(A, b, C, l - k, slot);
}

/** The real roots of A t² + 2bt + C, times 2^e, each rounded once. */
function rootsOf(A: bigint, b: bigint, C: bigint, e: number, slot: RootSlot): number {
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
  const u: Dyadic = { m: -b, e };
  const w: Dyadic = { m: A, e: 0 };
  const root: Dyadic = { m: D, e: 0 };
  const plus: Dyadic = { m: 1n, e };
  const minus: Dyadic = { m: -1n, e };
  slot.t0 = toNumber({ u, v: A > 0n ? minus : plus, w, D: root });
  slot.t1 = toNumber({ u, v: A > 0n ? plus : minus, w, D: root });
  return TWO;
}

const ZERO: Dyadic = { m: 0n, e: 0 };

const ratio = (top: bigint, bottom: bigint, e: number): number =>
  toNumber({ u: { m: top, e }, v: ZERO, w: { m: bottom, e: 0 }, D: ONE_MORE });
