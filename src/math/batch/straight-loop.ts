import type { Answers, Rays } from './batch.ts';
import type { OneRay } from './one-ray.ts';

/**
 * A loop without case distinctions over all rays. What would need one, because A or D is 0, a sign
 * is not known or a number leaves the range, is left open: its place is written into `open`, and
 * what stands in the answers there means nothing.
 *
 * @param numbers the shape's, in the order of NUMBERS.
 * @param roots whether the roots are wanted, where one loop serves both.
 * @returns how many are left open.
 */
export type Loop = (
  numbers: Float64Array,
  rays: Rays,
  out: Answers,
  open: Int32Array,
  roots: boolean,
) => number;

export type Ask = 'both' | 'classes';
export type Loops = Readonly<Record<Ask, Loop>>;

/** The loops of a method that are made of its trees: scripts/kernels/trees. */
export interface Straight {
  /** The same as a module of WebAssembly in base64. */
  readonly simd: string;
  /** The number system that they are in: the `id` of its arithmetic. */
  readonly arithmetic: string;
  /** What the loops leave open, without objects; null where a number is more than one double. */
  readonly alone: OneRay | null;
  /** By kind of shape. */
  readonly loops: Readonly<Record<string, Loops>>;
}
