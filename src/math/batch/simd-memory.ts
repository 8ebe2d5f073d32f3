import type { Allocate } from './memory.ts';
import { createArena } from './simd-arena.ts';

/*
 * The one memory of all WebAssembly kernels. In bytes, from 0:
 *
 *   NUMBERS   constants of the shape, set before each call
 *   BLOCK     rays and answers of callers whose arrays lie elsewhere, copied block by block
 *   SCRATCH   what the kernel that runs now keeps for itself; nothing is left there between calls
 *   ARENA     arrays made by `kernelArray`, which every kernel reads and writes where they are
 */

/** What modules import their memory as. */
export const IMPORT = { module: 'batch', name: 'memory' } as const;

/** Rays of a block. */
export const CAPACITY = 1024;
/** Bytes between arrays: a power of two apart, they would share the same lines of the cache. */
export const GAP = 192;

export const NUMBERS = 0;
const NUMBERS_BYTES = 1024;

export const BLOCK_ARRAYS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz', 't0', 't1', 'margin'] as const;
type BlockArray = (typeof BLOCK_ARRAYS)[number];

const STRIDE = 8 * CAPACITY + GAP;
const START = NUMBERS + NUMBERS_BYTES;
/** Where each array of the block begins. */
export const BLOCK: Readonly<Record<BlockArray, number>> = {
  Ex: START,
  Ey: START + STRIDE,
  Ez: START + 2 * STRIDE,
  dx: START + 3 * STRIDE,
  dy: START + 4 * STRIDE,
  dz: START + 5 * STRIDE,
  t0: START + 6 * STRIDE,
  t1: START + 7 * STRIDE,
  margin: START + 8 * STRIDE,
};

const PAGE = 65536;
export const SCRATCH = NUMBERS + NUMBERS_BYTES + BLOCK_ARRAYS.length * STRIDE;
/** The arena begins on a page; the scratch has the rest of the pages before. */
export const ARENA = 4 * PAGE;
export const SCRATCH_BYTES = ARENA - SCRATCH;
/** What is not touched costs an address only. */
const ARENA_BYTES = 2 ** 25;
export const PAGES = (ARENA + ARENA_BYTES) / PAGE;

/** A kernel's function: addresses and counts in, a count out. */
export type Run = (...numbers: number[]) => number;

export interface SimdMemory {
  readonly buffer: ArrayBuffer;
  /** Arrays in the arena, for `kernelArray`. */
  readonly allocate: Allocate;
  /** The block's arrays. */
  readonly block: Readonly<Record<BlockArray, Float64Array>>;
  /** The functions of a module that imports this memory. Throws what the engine throws. */
  readonly load: (bytes: Uint8Array) => Readonly<Record<string, Run>>;
}

/** Throws what the engine throws where WebAssembly or the room for the memory is missing. */
export function createSimdMemory(): SimdMemory {
  const memory = new WebAssembly.Memory({ initial: PAGES, maximum: PAGES });
  const { buffer } = memory;
  const imports = { [IMPORT.module]: { [IMPORT.name]: memory } };
  return {
    buffer,
    allocate: createArena(buffer, ARENA),
    block: Object.fromEntries(
      BLOCK_ARRAYS.map((name) => [name, new Float64Array(buffer, BLOCK[name], CAPACITY)]),
    ) as Record<BlockArray, Float64Array>,
    load(bytes) {
      const module = new WebAssembly.Module(bytes as BufferSource);
      return new WebAssembly.Instance(module, imports).exports as Record<string, Run>;
    },
  };
}

/**
 * Where a kernel finds `count` numbers of an input from `from` on: where they are, or in the block,
 * to which they are copied (then `count` is at most CAPACITY).
 */
export function addressOf(
  { buffer, block }: SimdMemory,
  name: BlockArray,
  array: Float64Array,
  from: number,
  count: number,
): number {
  if (array.buffer === buffer) return array.byteOffset + 8 * from;
  block[name].set(part(array, from, count));
  return BLOCK[name];
}

/**
 * A view of a part, or the array itself if that is all of it: views cost more than copying some
 * hundred numbers.
 */
export const part = (array: Float64Array, from: number, count: number): Float64Array =>
  from === 0 && count === array.length ? array : array.subarray(from, from + count);

/** The bytes of a generated module, which is kept as base64 in a source file. */
export const bytesOf = (base64: string): Uint8Array =>
  Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
