import { addDown, addUp, divDown, divUp, mulDown, mulUp, sqrtDown, sqrtUp } from './directed.ts';

/**
 * Intervals in a register file: `R[a]` is a lower end and `R[a + 1]` the upper one; `out` may be
 * one of the operands. Each result holds the exact result of any numbers of its operands. An end
 * may be infinite, the numbers in between are finite. src/math/arithmetic/interval.ts wraps these
 * functions; batch kernels call them as they are, and allocate nothing.
 */
export type Registers = Float64Array;

const get = (R: Registers, i: number): number => R[i] as number;

export function set(R: Registers, out: number, x: number): void {
  R[out] = x;
  R[out + 1] = x;
}

/** As `set` with xs[i]: a double that is handed to a call may be boxed. */
export function load(R: Registers, out: number, xs: Float64Array, i: number): void {
  const x = xs[i] as number;
  R[out] = x;
  R[out + 1] = x;
}

/** Puts the middle into xs[i]. */
export function store(R: Registers, a: number, xs: Float64Array, i: number): void {
  xs[i] = toNumber(R, a);
}

export function neg(R: Registers, out: number, a: number): void {
  const lo = get(R, a);
  R[out] = -get(R, a + 1);
  R[out + 1] = -lo;
}

export function add(R: Registers, out: number, a: number, b: number): void {
  const lo = addDown(get(R, a), get(R, b));
  R[out + 1] = addUp(get(R, a + 1), get(R, b + 1));
  R[out] = lo;
}

export function sub(R: Registers, out: number, a: number, b: number): void {
  const lo = addDown(get(R, a), -get(R, b + 1));
  R[out + 1] = addUp(get(R, a + 1), -get(R, b));
  R[out] = lo;
}

/**
 * The signs of the ends tell which two products are the least and the greatest; only where both
 * hold 0 there are four.
 */
export function mul(R: Registers, out: number, a: number, b: number): void {
  const p = get(R, a);
  const q = get(R, a + 1);
  const r = get(R, b);
  const s = get(R, b + 1);
  if (p >= 0) {
    R[out] = mulDown(r >= 0 ? p : q, r);
    R[out + 1] = mulUp(s >= 0 ? q : p, s);
  } else if (q <= 0) {
    R[out] = mulDown(s >= 0 ? p : q, s);
    R[out + 1] = mulUp(r >= 0 ? q : p, r);
  } else if (r >= 0) {
    R[out] = mulDown(p, s);
    R[out + 1] = mulUp(q, s);
  } else if (s <= 0) {
    R[out] = mulDown(q, r);
    R[out + 1] = mulUp(p, r);
  } else {
    R[out] = Math.min(mulDown(p, s), mulDown(q, r));
    R[out + 1] = Math.max(mulUp(p, r), mulUp(q, s));
  }
}

/** The least is 0 where a holds 0: what `mul` of a with itself cannot know. */
export function sqr(R: Registers, out: number, a: number): void {
  const lo = get(R, a);
  const hi = get(R, a + 1);
  const least = lo > 0 ? lo : hi < 0 ? hi : 0;
  R[out] = mulDown(least, least);
  R[out + 1] = Math.max(mulUp(lo, lo), mulUp(hi, hi));
}

/** A denominator that may be 0 leaves nothing known. */
export function div(R: Registers, out: number, a: number, b: number): void {
  const p = get(R, a);
  const q = get(R, a + 1);
  const r = get(R, b);
  const s = get(R, b + 1);
  if (r <= 0 && s >= 0) {
    R[out] = -Infinity;
    R[out + 1] = Infinity;
    return;
  }
  if (r > 0) {
    R[out] = divDown(p, p >= 0 ? s : r);
    R[out + 1] = divUp(q, q >= 0 ? r : s);
  } else {
    R[out] = divDown(q, q >= 0 ? s : r);
    R[out + 1] = divUp(p, p >= 0 ? r : s);
  }
}

/** A root is only taken of what is known not to be negative, so an end below 0 counts as 0. */
export function sqrt(R: Registers, out: number, a: number): void {
  R[out] = sqrtDown(Math.max(get(R, a), 0));
  R[out + 1] = sqrtUp(Math.max(get(R, a + 1), 0));
}

/**
 * Bounds of the lesser and of the greater of two; where they overlap nobody knows which is which.
 */
export function sort(R: Registers, a: number, b: number): void {
  const lo = get(R, a);
  const hi = get(R, a + 1);
  R[a] = Math.min(lo, get(R, b));
  R[a + 1] = Math.min(hi, get(R, b + 1));
  R[b] = Math.max(lo, get(R, b));
  R[b + 1] = Math.max(hi, get(R, b + 1));
}

/**
 * 1 or −1 where no number of the interval says otherwise, 0 only for [0, 0], NaN for all others.
 */
export function sign(R: Registers, a: number): number {
  const lo = get(R, a);
  const hi = get(R, a + 1);
  if (lo > 0) return 1;
  if (hi < 0) return -1;
  return lo === 0 && hi === 0 ? 0 : Number.NaN;
}

/**
 * The middle. Halved before they are added: the sum of two ends may overflow. −0 comes out as 0,
 * [−∞, ∞] as NaN.
 */
export function toNumber(R: Registers, a: number): number {
  const lo = get(R, a);
  const hi = get(R, a + 1);
  return (lo === hi ? lo : lo / 2 + hi / 2) + 0;
}

/** No number of the interval is larger than this, either way. */
export function size(R: Registers, a: number): number {
  return Math.max(Math.abs(get(R, a)), Math.abs(get(R, a + 1)));
}

/** The least |x| of an interval without 0 inside. */
export function least(R: Registers, a: number): number {
  return Math.min(Math.abs(get(R, a)), Math.abs(get(R, a + 1)));
}
