/**
 * Fractions of whole numbers, written for the tests alone: the answers of the product are held
 * against these.
 */
export interface Fraction {
  readonly n: bigint;
  /** Positive. */
  readonly d: bigint;
}

export type Point = readonly [Fraction, Fraction, Fraction];

const gcd = (a: bigint, b: bigint): bigint => (b === 0n ? a : gcd(b, a % b));

export function fraction(n: bigint | number, d: bigint | number = 1n): Fraction {
  const [top, under] = [BigInt(n), BigInt(d)];
  const common = gcd(top < 0n ? -top : top, under < 0n ? -under : under) || 1n;
  const flip = under < 0n ? -1n : 1n;
  return { n: (flip * top) / common, d: (flip * under) / common };
}

export const ZERO = fraction(0);
export const plus = (...xs: readonly Fraction[]): Fraction =>
  xs.reduce((a, b) => fraction(a.n * b.d + b.n * a.d, a.d * b.d), ZERO);
export const times = (...xs: readonly Fraction[]): Fraction =>
  xs.reduce((a, b) => fraction(a.n * b.n, a.d * b.d), fraction(1));
export const neg = (a: Fraction): Fraction => ({ n: -a.n, d: a.d });
export const minus = (a: Fraction, b: Fraction): Fraction => plus(a, neg(b));
export const over = (a: Fraction, b: Fraction): Fraction => fraction(a.n * b.d, a.d * b.n);
export const sign = (a: Fraction): -1 | 0 | 1 => (a.n > 0n ? 1 : a.n < 0n ? -1 : 0);

export const point = (x: Fraction, y: Fraction, z: Fraction): Point => [x, y, z];
export const add = (a: Point, b: Point): Point => [
  plus(a[0], b[0]),
  plus(a[1], b[1]),
  plus(a[2], b[2]),
];
export const scale = (k: Fraction, a: Point): Point => [
  times(k, a[0]),
  times(k, a[1]),
  times(k, a[2]),
];
export const from = (a: Point, b: Point): Point => add(a, scale(fraction(-1), b));
export const dot = (a: Point, b: Point): Fraction =>
  plus(times(a[0], b[0]), times(a[1], b[1]), times(a[2], b[2]));
export const cross = (a: Point, b: Point): Point => [
  minus(times(a[1], b[2]), times(a[2], b[1])),
  minus(times(a[2], b[0]), times(a[0], b[2])),
  minus(times(a[0], b[1]), times(a[1], b[0])),
];

/** '0.3' where that is possible in six places, else '1/3'. */
export function written({ n, d }: Fraction): string {
  const size = n < 0n ? -n : n;
  const places = [0, 1, 2, 3, 4, 5, 6].find((k) => 10n ** BigInt(k) % d === 0n);
  if (places === undefined) return `${n}/${d}`;
  const digits = String(size * (10n ** BigInt(places) / d)).padStart(places + 1, '0');
  const cut = digits.length - places;
  const decimals = places > 0 ? `.${digits.slice(cut)}` : '';
  return `${n < 0n ? '-' : ''}${digits.slice(0, cut)}${decimals}`;
}
