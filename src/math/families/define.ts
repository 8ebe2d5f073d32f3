import { scale } from '../float/bits.ts';
import type { Ray } from '../ray.ts';
import { type Random, uniform } from '../rng.ts';
import type { Shape } from '../shapes/index.ts';

/** A ray and the shape that it is asked about. */
export interface Question {
  readonly shape: Shape;
  readonly ray: Ray;
}

/** How hard a family's rays are, as one number. */
export interface Dial {
  /** What the number is: `the distance of E is 10^k radii`. */
  readonly title: string;
  readonly range: readonly [number, number];
  /** The interval that the number is drawn from, uniformly, when it is not given. */
  readonly usual: readonly [number, number];
}

/** How hard rays are for a program: 'special' are those that only a case of its own gets right. */
export type Hardness = 'ordinary' | 'special' | 'hard';

/** Rays that are hard (or not) for one reason. */
export interface Family {
  readonly id: string;
  readonly title: string;
  /** One sentence for the page: which rays the family has, and why they are hard. */
  readonly idea: string;
  /** How hard the rays are; null for a family without such a number. */
  readonly dial: Dial | null;
  /** The group of Check's cases that it gives rays to; absent: programs are not tried on it. */
  readonly hardness?: Hardness;
  /** Where the dial, out of its range, puts every ray exactly onto a border: special cases. */
  readonly border?: number;
  /**
   * One ray and its shape.
   *
   * @param random where chance comes from, numbers in [0, 1): the same draws give the same ray.
   * @param difficulty a number within the dial's `range`; left out: drawn from its `usual`. A
   *   family without a dial ignores it.
   */
  make(random: Random, difficulty?: number): Question;
  /** Many rays for one shape, as a batch kernel wants them; the rest as for `make`. */
  batch(
    random: Random,
    count: number,
    difficulty?: number,
  ): { readonly shape: Shape; readonly rays: readonly Ray[] };
}

/** A shape and the numbers it was drawn from, which the rays of a family may use. */
export interface Setting {
  readonly shape: Shape;
}

/** What a family is made of. */
export interface FamilyParts<S extends Setting> {
  readonly id: string;
  readonly title: string;
  readonly idea: string;
  readonly dial: Dial | null;
  readonly hardness?: Hardness;
  readonly border?: number;
  setting(random: Random, difficulty: number): S;
  ray(random: Random, setting: S, difficulty: number): Ray;
}

/** Without a dial `difficulty` is NaN, and neither `setting` nor `ray` may use it. */
export function family<S extends Setting>({ setting, ray, ...about }: FamilyParts<S>): Family {
  const { dial } = about;
  const drawn = (random: Random): number =>
    dial ? uniform(random, dial.usual[0], dial.usual[1]) : Number.NaN;
  return {
    ...about,
    make(random, difficulty = drawn(random)) {
      const made = setting(random, difficulty);
      return { shape: made.shape, ray: ray(random, made, difficulty) };
    },
    batch(random, count, difficulty) {
      const made = setting(random, difficulty ?? drawn(random));
      const one = (): Ray => ray(random, made, difficulty ?? drawn(random));
      return { shape: made.shape, rays: Array.from({ length: count }, one) };
    },
  };
}

/** log2 10: dials are in powers of ten, exact scaling is by powers of two. */
const BITS_PER_DIGIT = 3.321928094887362;

/** The exponent of the power of two that is nearest to 10^k. */
export const binaryExponent = (k: number): number => Math.round(k * BITS_PER_DIGIT);

/**
 * 10^k within 6 %, a smooth function of k; the standard lets `**` differ between engines, this does
 * not.
 */
export function powerOfTen(k: number): number {
  const bits = k * BITS_PER_DIGIT;
  const whole = Math.floor(bits);
  return scale(1 + (bits - whole), whole);
}
