import type { Vec3 } from '../vec3.ts';

/**
 * x rounded to so many significant bits.
 *
 * @param x any double, of any unit.
 * @param bits from 1 to 53.
 * @returns in the unit of x.
 * @see NUMERICS.md, section 7
 * @example
 * [short(0.3, 2), short(100, 3)]; // → [0.25, 96]
 */
export function short(x: number, bits: number): number {
  if (x === 0 || !Number.isFinite(x)) return x;
  const step = 2 ** (Math.floor(Math.log2(Math.abs(x))) + 1 - bits);
  return step > 0 ? Math.round(x / step) * step : x;
}

export const shortPoint = (v: Vec3, bits: number): Vec3 => [
  short(v[0], bits),
  short(v[1], bits),
  short(v[2], bits),
];
