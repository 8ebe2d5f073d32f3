import { lazily } from '../lazily.ts';

/**
 * The bits of a double. A DataView names its byte order, so this also holds on big-endian machines;
 * V8 compiles it to the same loads as a typed array.
 */
const scratch = lazily(() => new DataView(new ArrayBuffer(8)));
const TWO_32 = 2 ** 32;
const HIDDEN_BIT = 0x100000;
const FRACTION = 0xfffff;

/** The exponent of the smallest subnormal: every double is a whole multiple of 2^MIN_EXPONENT. */
export const MIN_EXPONENT = -1074;
/** Normal doubles begin at 2^MIN_NORMAL_EXPONENT. */
export const MIN_NORMAL_EXPONENT = -1022;
export const MAX_EXPONENT = 1023;

/** m·2^e, exactly. m is odd, or 0 with e = 0. */
export interface Parts {
  readonly m: bigint;
  readonly e: number;
}

const trailingZeros = (word: number): number => 31 - Math.clz32(word & -word);

/**
 * x as an odd whole number times a power of two; −0 gives the same parts as 0. The odd form keeps
 * the numbers that people type (0.5, 3, 1e6) short, and BigInt work grows with length.
 */
export function decompose(x: number): Parts {
  if (x === 0) return { m: 0n, e: 0 };
  if (!Number.isFinite(x)) throw new RangeError(`a finite number is needed, got ${x}`);
  const view = scratch();
  view.setFloat64(0, x);
  const top = view.getUint32(0);
  const low = view.getUint32(4);
  const biased = (top >>> 20) & 0x7ff;
  const high = (top & FRACTION) | (biased === 0 ? 0 : HIDDEN_BIT);
  const zeros = low === 0 ? 32 + trailingZeros(high) : trailingZeros(low);
  const size = (high * TWO_32 + low) / 2 ** zeros;
  return { m: BigInt(x < 0 ? -size : size), e: Math.max(biased, 1) - 1075 + zeros };
}

/** floor(log2 |x|), subnormals included; −Infinity for 0, and x itself unsigned if not finite. */
export function exponentOf(x: number): number {
  if (x === 0) return -Infinity;
  if (!Number.isFinite(x)) return Math.abs(x);
  const view = scratch();
  view.setFloat64(0, x);
  const top = view.getUint32(0) & 0x7fffffff;
  if (top >= HIDDEN_BIT) return (top >>> 20) - 1023;
  return top === 0 ? 31 - Math.clz32(view.getUint32(4)) - 1074 : 31 - Math.clz32(top) - 1042;
}

/** 2^k for −1074 ≤ k ≤ 1023, built from bits: the standard lets `2 ** k` be approximate. */
export function powerOfTwo(k: number): number {
  const view = scratch();
  if (k >= MIN_NORMAL_EXPONENT) view.setUint32(0, (k + 1023) << 20);
  else view.setUint32(0, k >= -1042 ? 1 << (k + 1042) : 0);
  view.setUint32(4, k < -1042 ? 1 << (k + 1074) : 0);
  return view.getFloat64(0);
}

/**
 * x·2^k for any whole k, rounded once. Below −1074 the halves are safe: if the first half already
 * underflows, the second takes whatever is left below 2^-1559, hence to 0.
 */
export function scale(x: number, k: number): number {
  if (k > MAX_EXPONENT) {
    const rest = Math.min(k - MAX_EXPONENT, 2 * MAX_EXPONENT);
    return scale(x * powerOfTwo(MAX_EXPONENT), rest);
  }
  if (k >= MIN_EXPONENT) return x * powerOfTwo(k);
  const bounded = Math.max(k, 2 * MIN_EXPONENT);
  const half = bounded >> 1;
  return x * powerOfTwo(half) * powerOfTwo(bounded - half);
}
