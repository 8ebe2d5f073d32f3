import { BLOCK, CAPACITY, GAP, NUMBERS, SCRATCH, SCRATCH_BYTES } from '../../batch/simd-memory.ts';

/*
 * What certified's kernels keep in the shared memory (batch/simd-memory.ts): the shape's numbers,
 * and in the scratch lists of rays that a stage leaves to the next one and what parts of a kernel
 * hand on. All in bytes.
 */

/**
 * Rays that the passes over ordinary ones hand on, so that these numbers stay in the first cache.
 */
export const HANDED = 128;

/** Where the constants of the ordinary rays' passes and of the stages after them begin. */
export const LATTICE_NUMBERS = NUMBERS;
export const SCALED_NUMBERS = NUMBERS + 512;

export const INPUTS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'] as const;
export type Input = (typeof INPUTS)[number];

/** The arrays whose addresses a kernel is given. */
export const PARAMS = [...INPUTS, 't0', 't1'] as const;
export type Param = (typeof PARAMS)[number];

const LIST_BYTES = 4 * CAPACITY + GAP;

/** Where each array begins. The lists hold the rays' indices, and have room for one more. */
export const PLACE = {
  Ex: BLOCK.Ex,
  Ey: BLOCK.Ey,
  Ez: BLOCK.Ez,
  dx: BLOCK.dx,
  dy: BLOCK.dy,
  dz: BLOCK.dz,
  t0: BLOCK.t0,
  t1: BLOCK.t1,
  doubtful: SCRATCH,
  unsettled: SCRATCH + LIST_BYTES,
  doubtfulBytes: SCRATCH + 2 * LIST_BYTES,
} as const;

const HANDED_START = PLACE.doubtfulBytes + 64;
const HANDED_BYTES = 8 * HANDED + 64;
const MOST_HANDED = Math.floor((SCRATCH + SCRATCH_BYTES - HANDED_START) / HANDED_BYTES);

/**
 * Where the value number n that a part hands on is kept, for each ray of a lot. Throws RangeError
 * where there is no room for so many.
 */
export function handed(n: number): number {
  if (!(n < MOST_HANDED)) throw new RangeError(`no room to hand on ${n + 1} values`);
  return HANDED_START + n * HANDED_BYTES;
}
