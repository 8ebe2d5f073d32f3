import type { Quadric } from '../../batch/quadric.ts';
import { exponentOf, powerOfTwo } from '../../float/bits.ts';
import { productError, squareError } from '../../float/eft.ts';

/*
 * Ordinary rays are taken in units in which their leading parts are whole numbers: x = whole + rest with |rest| ≤ 1/2, and sums,
 * products and squares of the whole parts are exact as long as they stay below 2^53. The units are powers of two that depend on
 * the shape alone, so changing to them and back is exact, and a ray's answer does not depend on its neighbours in the batch.
 * y is stretched by the power of two that brings a into [1/4, 1), so that all three coordinates are alike.
 */

/** |d| = 1 becomes 2^8 units, and a t that leads over the shape's size 2^9 or so. */
const DIRECTION = 2 ** 8;
/** The shape's size becomes 2^17 units or up to twice as many: points up to 30 sizes from the centre have fewer than 2^23. */
const SIZE_BITS = 17;
/** Shapes beyond these powers of two are not ordinary. */
const LARGEST_EXPONENT = 60;
const LARGEST_STRETCH = 30;
/** In units: beyond, E and C could not be cut exactly any more. */
export const LARGEST_LENGTH = 2 ** 45;

/**
 * A shape in units, as one array of doubles: of an object's fields V8 would not know inside a loop whether they are small integers.
 * Where each number is, is told by AT.
 */
export type Lattice = Float64Array;

/**
 * Where in a Lattice each number is. `direction`… are what dx, dz and dy, Ex, Ez and Ey are multiplied by, `back` is what t in units is.
 * C and ρ are cut into `whole` and `rest`; a = a1 + a2 + a3, a1 in 32nds and a2 in 2^12ths, |a2| ≤ 2^-6, |a3| ≤ 2^-13.
 */
export const AT = {
  direction: 0,
  directionY: 1,
  length: 2,
  lengthY: 3,
  back: 4,
  Cx: 5,
  Cy: 6,
  Cz: 7,
  wholeX: 8,
  wholeY: 9,
  wholeZ: 10,
  restX: 11,
  restY: 12,
  restZ: 13,
  a: 14,
  a1: 15,
  a2: 16,
  a3: 17,
  rho: 18,
  wholeRho: 19,
  restRho: 20,
} as const;

const COUNT = 21;

/** x rounded to a whole number, for |x| < 2^51: adding 1.5·2^52 leaves no room for a fraction. Math.round would make V8 convert to int32 and back. */
export const ROUND = 1.5 * 2 ** 52;

/** Null for a shape whose numbers are not ordinary. */
export function latticeOf(q: Quadric): Lattice | null {
  const flare = q.squared ? q.flare * q.flare : q.flare;
  const flareLow = q.squared ? squareError(q.flare, flare) : 0;
  const size = exponentOf(q.r || 1);
  const stretch = flare === 0 ? 0 : Math.ceil((exponentOf(flare) + 1) / 2);
  if (!(Math.abs(size) <= LARGEST_EXPONENT && Math.abs(stretch) <= LARGEST_STRETCH)) return null;
  const length = powerOfTwo(SIZE_BITS - size);
  const up = powerOfTwo(stretch);
  const [Cx, Cy, Cz] = [length * q.Cx, length * up * q.Cy, length * q.Cz];
  if (!(Math.max(Math.abs(Cx), Math.abs(Cy), Math.abs(Cz)) < LARGEST_LENGTH)) return null;
  const [wholeX, wholeY, wholeZ] = [Math.round(Cx), Math.round(Cy), Math.round(Cz)];
  const a = flare / up / up;
  const a1 = Math.round(2 ** 5 * a) / 2 ** 5;
  const a2 = Math.round(2 ** 12 * (a - a1)) / 2 ** 12;
  const r = length * q.r;
  const rho = r * r;
  const wholeRho = Math.round(rho);
  const lattice = new Float64Array(COUNT);
  lattice[AT.direction] = DIRECTION;
  lattice[AT.directionY] = DIRECTION * up;
  lattice[AT.length] = length;
  lattice[AT.lengthY] = length * up;
  lattice[AT.back] = DIRECTION / length;
  lattice[AT.Cx] = Cx;
  lattice[AT.Cy] = Cy;
  lattice[AT.Cz] = Cz;
  lattice[AT.wholeX] = wholeX;
  lattice[AT.wholeY] = wholeY;
  lattice[AT.wholeZ] = wholeZ;
  lattice[AT.restX] = Cx - wholeX;
  lattice[AT.restY] = Cy - wholeY;
  lattice[AT.restZ] = Cz - wholeZ;
  lattice[AT.a] = a;
  lattice[AT.a1] = a1;
  lattice[AT.a2] = a2;
  lattice[AT.a3] = a - a1 - a2 + flareLow / up / up;
  lattice[AT.rho] = rho;
  lattice[AT.wholeRho] = wholeRho;
  lattice[AT.restRho] = rho - wholeRho + productError(r, r, rho);
  return lattice;
}
