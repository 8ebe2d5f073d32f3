import { scale } from '../float/bits.ts';
import { nextDown, nextUp } from '../float/ulp.ts';
import { integer, pick, type Random, randomSign, uniform } from '../rng.ts';
import type { Vec3 } from '../vec3.ts';

/*
 * Random numbers and vectors of the families. Nothing here uses sin, cos or pow: their last bits
 * differ between engines, and a seed has to give the same rays in all of them.
 */

export const inBox = (random: Random, size: number): Vec3 => [
  uniform(random, -size, size),
  uniform(random, -size, size),
  uniform(random, -size, size),
];

/** Every direction equally likely; of length 1 but for rounding. */
export function unitDirection(random: Random): Vec3 {
  for (;;) {
    const v = inBox(random, 1);
    const square = dot(v, v);
    if (square <= 1 && square > 0.01) return times(1 / Math.sqrt(square), v);
  }
}

/** (cos, sin) of a random angle, but for rounding. */
export function onUnitCircle(random: Random): readonly [number, number] {
  for (;;) {
    const x = uniform(random, -1, 1);
    const y = uniform(random, -1, 1);
    const square = x * x + y * y;
    if (square <= 1 && square > 0.01) return [x / Math.sqrt(square), y / Math.sqrt(square)];
  }
}

/** A list that `pick` takes one of. */
export type NonEmpty<T> = readonly [T, ...T[]];
export type Draw<T> = (random: Random) => T;

const TRIPLES: NonEmpty<Vec3> = [
  [3, 4, 5],
  [5, 12, 13],
  [8, 15, 17],
  [7, 24, 25],
  [1, 0, 1],
];

/** Whole numbers with x² + y² = n², in any quadrant. */
export function pythagorean(random: Random): { x: number; y: number; n: number } {
  const [a, b, n] = pick(random, TRIPLES);
  const [x, y] = random() < 0.5 ? [a, b] : [b, a];
  return { x: x * randomSign(random), y: y * randomSign(random), n };
}

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const plus = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (k: number, a: Vec3): Vec3 => [k * a[0], k * a[1], k * a[2]];
/** p + t d. */
export const along = (p: Vec3, t: number, d: Vec3): Vec3 => plus(p, times(t, d));
export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const unit = (a: Vec3): Vec3 => times(1 / Math.sqrt(dot(a, a)), a);
export const scaled = (a: Vec3, k: number): Vec3 => [
  scale(a[0], k),
  scale(a[1], k),
  scale(a[2], k),
];

/** A direction at right angles to n (of length 1), of length 1. */
export function perpendicular(random: Random, n: Vec3): Vec3 {
  for (;;) {
    const v = unitDirection(random);
    const rest = along(v, -dot(v, n), n);
    if (dot(rest, rest) > 0.05) return unit(rest);
  }
}

/**
 * A whole number from −size to size in quarters: sums, products and squares of a few of them are
 * exact.
 */
export const quarter = (random: Random, size: number): number =>
  integer(random, -4 * size, 4 * size) / 4;
export const inQuarters = (random: Random, size: number): Vec3 => [
  quarter(random, size),
  quarter(random, size),
  quarter(random, size),
];
export const wholeVector = (random: Random, size: number): Vec3 => [
  integer(random, -size, size),
  integer(random, -size, size),
  integer(random, -size, size),
];

export function nonZero(draw: () => Vec3): Vec3 {
  for (;;) {
    const v = draw();
    if (v.some((x) => x !== 0)) return v;
  }
}

/** 2^k for a dial's k: a distance counted in doubles. */
export const stepsOf = (k: number): number => scale(1, Math.round(k));

/** x moved by up to `most` doubles either way, 0 included. */
function nudged(random: Random, x: number, most: number): number {
  let moved = x;
  const steps = integer(random, -most, most);
  for (let i = 0; i < Math.abs(steps); i++) moved = steps > 0 ? nextUp(moved) : nextDown(moved);
  return moved;
}

/** v with one of its components nudged. */
export function nudgedVector(random: Random, v: Vec3, most: number): Vec3 {
  const at = integer(random, 0, 2);
  const [x, y, z] = v.map((c, i) => (i === at ? nudged(random, c, most) : c));
  return [x as number, y as number, z as number];
}
