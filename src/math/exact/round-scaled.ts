import { MIN_EXPONENT, MIN_NORMAL_EXPONENT, scale } from '../float/bits.ts';
import { bitLength } from './isqrt.ts';

/**
 * m·2^e as a double. Beyond the doubles ±Infinity; exact zero is +0, and what underflows keeps its
 * sign. `Number(bigint)` rounds to nearest even by the standard, so it serves wherever the result
 * is normal and scaling it is exact.
 */
export function roundScaled(m: bigint, e: number): number {
  if (m === 0n) return 0;
  const size = bitLength(m);
  if (size + e <= MIN_NORMAL_EXPONENT) return roundSubnormal(m, e, size);
  if (size <= 1023) return scale(Number(m), e);
  if (size + e > 1024) return m < 0n ? -Infinity : Infinity;
  const drop = size - 64;
  return scale(Number(roundToOdd(m, BigInt(drop))), e + drop);
}

/**
 * Drops bits and remembers in the last bit whether any of them was set. Rounding the result to
 * nearest at least two bits higher up equals rounding m (Boldo and Melquiond 2008).
 */
function roundToOdd(m: bigint, drop: bigint): bigint {
  const kept = m >> drop;
  return kept << drop === m ? kept : kept | 1n;
}

function roundSubnormal(m: bigint, e: number, size: number): number {
  const drop = MIN_EXPONENT - e;
  if (drop <= 0) return scale(Number(m), e);
  const steps = drop > size ? 0 : Number(shiftToEven(m < 0n ? -m : m, BigInt(drop)));
  return (m < 0n ? -steps : steps) * Number.MIN_VALUE;
}

/** m / 2^drop to the nearest whole number, ties to even, for m ≥ 0 and drop ≥ 1. */
function shiftToEven(m: bigint, drop: bigint): bigint {
  const floor = m >> drop;
  const half = 1n << (drop - 1n);
  const rest = m - (floor << drop);
  if (rest === half) return floor + (floor & 1n);
  return rest > half ? floor + 1n : floor;
}
