import { exponentOf, powerOfTwo } from '../float/bits.ts';

/** Bits in |m|; 0 for 0. */
export function bitLength(m: bigint): number {
  const near = Number(m);
  if (near === 0) return 0;
  if (!Number.isFinite(near)) return hexLength(m < 0n ? -m : m);
  const top = exponentOf(near);
  if (Math.abs(near) !== powerOfTwo(top)) return top + 1;
  // Number() may have rounded up to this power of two.
  return (m < 0n ? -m : m) >> BigInt(top) === 0n ? top : top + 1;
}

function hexLength(m: bigint): number {
  const digits = m.toString(16);
  return 4 * digits.length - Math.clz32(Number.parseInt(digits.charAt(0), 16)) + 28;
}

/** floor(√n) for n ≥ 0. */
export function isqrt(n: bigint): bigint {
  if (n < 0n) throw new RangeError(`the square root needs n ≥ 0, got ${n}`);
  let root = rootAbove(n, bitLength(n));
  // Never too small, but how far too large is not proved: in practice at most one turn.
  while (root * root > n) root -= 1n;
  return root;
}

/**
 * √n to within a few units, never below floor(√n). Newton's step squares the relative error: up to
 * 200 bits one step from the 53 bits of Math.sqrt is enough; above, the top half of n gives the
 * first half of the root (Zimmermann 1999; Python's math.isqrt grows its precision the same way).
 */
function rootAbove(n: bigint, size: number): bigint {
  // Below 2^52 the rounded root cannot reach the next whole number.
  if (size <= 52) return BigInt(Math.floor(Math.sqrt(Number(n))));
  if (size <= 200) return newton(n, BigInt(Math.floor(Math.sqrt(Number(n)))));
  const half = (size >> 2) - 2;
  const top = rootAbove(n >> BigInt(2 * half), size - 2 * half);
  return newton(n, top << BigInt(half));
}

/** ≥ floor(√n) from any x > 0: (x + n/x)/2 ≥ √n, and the two floors lose less than 1 in all. */
const newton = (n: bigint, x: bigint): bigint => (x + n / x) >> 1n;
