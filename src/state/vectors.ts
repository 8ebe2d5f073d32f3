import type { Vec3 } from '../math/index.ts';

/** a + s b. */
export const plus = (a: Vec3, b: Vec3, s = 1): Vec3 => [
  a[0] + s * b[0],
  a[1] + s * b[1],
  a[2] + s * b[2],
];

/** a − b. */
export const minus = (a: Vec3, b: Vec3): Vec3 => plus(a, b, -1);

/** s a. */
export const scaled = (a: Vec3, s: number): Vec3 => [s * a[0], s * a[1], s * a[2]];

/** a · b. */
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
