import { elementOf } from '../../../wasm/source.ts';

/*
 * The memory that the WebAssembly kernels share with TypeScript: the numbers of the shape, a block of rays and its answers, and lists of rays that a stage
 * leaves to the next one. All in bytes.
 */

/** Rays of a block. */
export const CAPACITY = 1024;
/** Rays that the passes over ordinary ones hand on to each other, so that what they hand on stays in the first cache. */
export const HANDED = 128;
/** Arrays that begin a power of two apart would fall into the same lines of the cache. */
const GAP = 192;

/** Where the constants of the ordinary rays' passes and of the stages after them begin. */
export const LATTICE_NUMBERS = 0;
export const SCALED_NUMBERS = 512;
const ARRAYS = 1024;
const array = (n: number): number => ARRAYS + n * (8 * CAPACITY + GAP);

export const INPUTS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'] as const;
export type Input = (typeof INPUTS)[number];
/** Which input an element of a loop, by elementOf's name for it, is of. */
export const inputOf = (element: string): Input | undefined =>
  INPUTS.find((one) => elementOf(one) === element);

/** The arrays whose addresses a kernel is given: they may be in the block or wherever arena.ts made them. */
export const PARAMS = [...INPUTS, 't0', 't1'] as const;
export type Param = (typeof PARAMS)[number];

/** Where each array begins. The lists hold the rays' indices, and have room for one more. */
export const PLACE = {
  Ex: array(0),
  Ey: array(1),
  Ez: array(2),
  dx: array(3),
  dy: array(4),
  dz: array(5),
  t0: array(6),
  t1: array(7),
  doubtful: array(8),
  unsettled: array(9),
  doubtfulBytes: array(10),
} as const;

const MOST_HANDED = 64;
const handedEnd = (n: number): number => array(10) + 64 + n * (8 * HANDED + 64);

/** Where the value number n that a part hands on is kept, for each ray of a lot. Throws RangeError where there is no room for so many. */
export function handed(n: number): number {
  if (!(n < MOST_HANDED)) throw new RangeError(`no room to hand on ${n + 1} values`);
  return handedEnd(n);
}
const PAGE = 65536;
/** From here on the memory is for arrays of rays and answers (arena.ts). */
export const ARENA = PAGE * Math.ceil(handedEnd(MOST_HANDED) / PAGE);
/** What is not touched costs an address only. */
const ARENA_BYTES = 2 ** 25;
export const PAGES = (ARENA + ARENA_BYTES) / PAGE;
