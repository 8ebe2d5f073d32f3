import type { Answers, Rays } from './batch.ts';
import type { OneRay } from './one-ray.ts';

/**
 * A loop over all rays, without case distinctions but for those that are rare: A, D or N·d is 0, or
 * a sign is not known. A ray whose class the roots do not tell is written into `marked` with its
 * class; one that the loop cannot settle, because a number leaves the range, with ASK, and what
 * stands in the answers there means nothing.
 *
 * @param numbers the shape's, in the order of NUMBERS.
 * @param roots whether the roots are wanted, where one loop serves both.
 * @returns how many are marked.
 */
export type Loop = (
  numbers: Float64Array,
  rays: Rays,
  out: Answers,
  marked: Int32Array,
  roots: boolean,
) => number;

/** Only the method itself knows; in place of a place in VERDICTS. */
export const ASK = 6;
/** A mark is the ray's place, and its class times 2 to this. */
export const CLASS_BIT = 28;
export const PLACE = 2 ** CLASS_BIT - 1;

export type Ask = 'both' | 'classes';
export type Loops = Readonly<Record<Ask, Loop>>;
export type LoopsByKind = Readonly<Record<string, Loops>>;

/** The loops of a method that are made of its trees: scripts/kernels/trees. */
export interface Straight {
  /** The same as a module of WebAssembly in base64. */
  readonly simd: string;
  /** The number system that they are in: the `id` of its arithmetic. */
  readonly arithmetic: string;
  /** What the loops cannot settle, without objects; null where a number is more than one double. */
  readonly alone: OneRay | null;
  readonly loops: () => LoopsByKind;
}
