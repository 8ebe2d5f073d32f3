import type { Dyadic } from '../exact/dyadic.ts';
import { toNumber } from '../exact/round.ts';
import { decompose, type Parts } from '../float/bits.ts';
import type { Vec3 } from '../vec3.ts';
import { CONTAINED, NONE, ONE } from './batch.ts';
import type { RootSlot } from './exact-quadric.ts';
import type { Planar } from './planar.ts';

type Whole = readonly [bigint, bigint, bigint];

const partsOf = ([x, y, z]: Vec3): [Parts, Parts, Parts] => [
  decompose(x),
  decompose(y),
  decompose(z),
];

function least(parts: readonly Parts[]): number {
  let e = Number.POSITIVE_INFINITY;
  for (const p of parts) if (p.m !== 0n && p.e < e) e = p.e;
  return e === Number.POSITIVE_INFINITY ? 0 : e;
}

const wholeOf = ({ m, e }: Parts, unit: number): bigint => (m === 0n ? 0n : m << BigInt(e - unit));

const dot = (a: Whole, b: Whole): bigint => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

const abs = (x: bigint): bigint => (x < 0n ? -x : x);

/**
 * One ray against a flat shape, exactly, in whole multiples of one power of two for lengths, one
 * for d and one for N. With p = E − P, X − P = (p·(N·d) − d·(N·p)) / (N·d), so rim and edge are
 * decided without a division.
 */
export function solvePlanarExactly(
  s: Planar,
  Ex: number,
  Ey: number,
  Ez: number,
  dx: number,
  dy: number,
  dz: number,
  slot: RootSlot,
): number {
  slot.t0 = Number.NaN;
  slot.t1 = Number.NaN;
  const N = partsOf(s.N);
  const P = partsOf(s.P);
  const E = partsOf([Ex, Ey, Ez]);
  const D = partsOf([dx, dy, dz]);
  const size = decompose(s.size);
  const n = least(N);
  const l = least([...E, ...P, size]);
  const k = least(D);
  const whole = (a: readonly [Parts, Parts, Parts], unit: number): Whole => [
    wholeOf(a[0], unit),
    wholeOf(a[1], unit),
    wholeOf(a[2], unit),
  ];
  const normal = whole(N, n);
  const d = whole(D, k);
  const e = whole(E, l);
  const corner = whole(P, l);
  const p: Whole = [e[0] - corner[0], e[1] - corner[1], e[2] - corner[2]];
  const rate = dot(normal, d);
  const offset = dot(normal, p);
  if (rate === 0n) return offset === 0n ? CONTAINED : NONE;
  const at = (i: 0 | 1 | 2): bigint => p[i] * rate - d[i] * offset;
  if (!isInside(s, at, rate, wholeOf(size, l))) return NONE;
  slot.t0 = toNumber({ u: { m: -offset, e: l - k }, v: ZERO, w: { m: rate, e: 0 }, D: UNIT });
  return ONE;
}

const ZERO: Dyadic = { m: 0n, e: 0 };
const UNIT: Dyadic = { m: 1n, e: 0 };

/** `at` gives rate·(X − P). */
function isInside(s: Planar, at: (i: 0 | 1 | 2) => bigint, rate: bigint, size: bigint): boolean {
  if (s.bound === 'none') return true;
  const reach = size * abs(rate);
  if (s.bound === 'circle') {
    const x: Whole = [at(0), at(1), at(2)];
    return dot(x, x) <= reach * reach;
  }
  const within = (x: bigint): boolean => {
    const y = rate < 0n ? -x : x;
    return y >= 0n && y <= reach;
  };
  return within(at(s.u)) && within(at(s.v));
}
