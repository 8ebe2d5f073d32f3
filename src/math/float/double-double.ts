import { fastSumError, productError, squareError, sumError } from './eft.ts';

/**
 * Double-double numbers x = hi + lo with |lo| ≤ ulp(hi)/2, so hi is x rounded: 106 bits at least,
 * and the exponents of a double.
 *
 * They live in a register file, a Float64Array in which `R[a]` is a hi and `R[a + 1]` its lo; `out`
 * may be one of the operands. So a batch kernel allocates nothing, and
 * src/math/arithmetic/double-double.ts wraps the same functions.
 *
 * Bounds (u = 2^-53) are relative errors, proven by Joldes, Muller, Popescu 2017, Tight and
 * rigorous error bounds for basic building blocks of double-word arithmetic, and by Lefèvre,
 * Louvet, Muller, Picot, Rideau 2022 for the root. They need every product of two hi's (for the
 * quotient also q·hi, for the root its square) to lie in 2^-968 … 2^1020 and every hi that is
 * multiplied under 2^996, the range of eft.ts. Above it the results are NaN, never a wrong number;
 * below it each product is off by up to 2^-1073 more, and nothing tells: a sign found near 2^-968
 * means nothing.
 */
type Registers = Float64Array;

const get = (R: Registers, i: number): number => R[i] as number;

/** hi + lo, renormalised; needs |hi| ≥ |lo|. */
function put(R: Registers, out: number, hi: number, lo: number): void {
  const s = hi + lo;
  R[out] = s;
  R[out + 1] = fastSumError(hi, lo, s);
}

export function set(R: Registers, out: number, x: number): void {
  R[out] = x;
  R[out + 1] = 0;
}

export function neg(R: Registers, out: number, a: number): void {
  R[out] = -get(R, a);
  R[out + 1] = -get(R, a + 1);
}

/**
 * The accurate addition (their algorithm 6), ≤ 3u²/(1 − 4u) of the sum even when hi's cancel. The
 * "sloppy" one, 9 operations shorter, has no bound at all there, and cancellation is what these
 * numbers are for.
 */
export function add(R: Registers, out: number, a: number, b: number): void {
  const aHi = get(R, a);
  const aLo = get(R, a + 1);
  const bHi = get(R, b);
  const bLo = get(R, b + 1);
  const s = aHi + bHi;
  const t = aLo + bLo;
  const c = sumError(aHi, bHi, s) + t;
  const v = s + c;
  put(R, out, v, sumError(aLo, bLo, t) + fastSumError(s, c, v));
}

/** As `add` with b's signs turned. */
export function sub(R: Registers, out: number, a: number, b: number): void {
  const aHi = get(R, a);
  const aLo = get(R, a + 1);
  const bHi = -get(R, b);
  const bLo = -get(R, b + 1);
  const s = aHi + bHi;
  const t = aLo + bLo;
  const c = sumError(aHi, bHi, s) + t;
  const v = s + c;
  put(R, out, v, sumError(aLo, bLo, t) + fastSumError(s, c, v));
}

/**
 * Their algorithm 10, ≤ 5u²: the error of hi·hi exactly, the two cross terms rounded, lo·lo ≤
 * u²·hi·hi left out.
 */
export function mul(R: Registers, out: number, a: number, b: number): void {
  const x = get(R, a);
  const y = get(R, b);
  const p = x * y;
  put(R, out, p, productError(x, y, p) + (x * get(R, b + 1) + get(R, a + 1) * y));
}

/** As `mul` of a with itself, bit for bit: the two cross terms are equal, so their sum is exact. */
export function sqr(R: Registers, out: number, a: number): void {
  const x = get(R, a);
  const p = x * x;
  put(R, out, p, squareError(x, p) + 2 * (x * get(R, a + 1)));
}

/** a·k for a double k, ≤ 5u² as `mul` with lo = 0. */
export function mulDouble(R: Registers, out: number, a: number, k: number): void {
  const x = get(R, a);
  const p = x * k;
  put(R, out, p, productError(x, k, p) + get(R, a + 1) * k);
}

/**
 * Their algorithm 17, ≤ 9.8u² + O(u³): q = fl(hi/hi), the remainder a − q·b (whose leading part is
 * exact, since q·b agrees with a in all but the last bits), and one more digit q' = remainder / hi.
 * NaN for b = 0.
 */
export function div(R: Registers, out: number, a: number, b: number): void {
  const x = get(R, a);
  const y = get(R, b);
  const q = x / y;
  // q·b as a double-double (their algorithm 7, ≤ 1.5u² + 4u³).
  const p = q * y;
  const c = q * get(R, b + 1);
  const t = p + c;
  const tLo = fastSumError(p, c, t) + productError(q, y, p);
  const r = t + tLo;
  const rest = x - r + (get(R, a + 1) - fastSumError(t, tLo, r));
  put(R, out, q, rest / y);
}

/**
 * One Newton step from s = fl(√hi), ≤ 25/8 u²: hi − s² is a double (Sterbenz, and the remainder of
 * a root is representable). Zero has the root 0, a negative number NaN.
 */
export function sqrt(R: Registers, out: number, a: number): void {
  const x = get(R, a);
  if (x === 0) {
    set(R, out, 0);
    return;
  }
  const s = Math.sqrt(x);
  const p = s * s;
  const rest = x - p - squareError(s, p) + get(R, a + 1);
  put(R, out, s, rest / (2 * s));
}

/** −1, 0, 1: hi's sign is that of hi + lo. NaN where hi is not finite: an overflow on the way. */
export function sign(R: Registers, a: number): number {
  const x = get(R, a);
  return Number.isFinite(x) ? Math.sign(x) + 0 : Number.NaN;
}

export function size(R: Registers, a: number): number {
  return Math.abs(get(R, a));
}
