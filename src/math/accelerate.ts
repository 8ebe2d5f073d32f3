import { type Allocate, useMemory } from './batch/memory.ts';
import { bytesOf, createSimdMemory } from './batch/simd-memory.ts';
import { simdSource } from './batch/straight-simd.ts';
import { type Simd, useSimd } from './batch/target.ts';
import { CERTIFIED_SIMD } from './methods/certified/generated/certified-simd.ts';
import { type FastStages, useFastStages } from './methods/certified/kernel.ts';
import { createFastStages } from './methods/certified/simd.ts';

interface Fast {
  readonly stages: FastStages;
  readonly simd: Simd;
  readonly allocate: Allocate;
}

/** What was made, or a sentence why it could not be; undefined before it was tried. */
let made: Fast | string | undefined;

/**
 * Lets batches find their answers by WebAssembly, two rays at a time and more: the same numbers,
 * at the prices in docs/bench.md, which are those of arrays by `kernelArray` (batch/memory.ts). It
 * holds for all kernels, also those made before, until `decelerate`. For Node and workers: a page
 * whose content security policy forbids WebAssembly would report the attempt. Throws nothing.
 *
 * @returns false where WebAssembly is not to be had; then all stays as it was.
 * @example
 * accelerate(); // → true
 * decelerate();
 */
export function accelerate(): boolean {
  made ??= loaded();
  const fast = typeof made === 'string' ? null : made;
  useFastStages(fast?.stages ?? null);
  useMemory(fast?.allocate ?? null);
  useSimd(fast?.simd ?? null);
  return fast !== null;
}

/**
 * Why `accelerate` said false: a sentence to show. Null where it said true, or was not called yet.
 *
 * @example
 * accelerate(); // → true
 * whyNotAccelerated(); // → null
 * decelerate();
 */
export const whyNotAccelerated = (): string | null => (typeof made === 'string' ? made : null);

/**
 * Undoes `accelerate`; its memory stays, for arrays that were made in it.
 *
 * @example
 * decelerate();
 * solveQuadratic(1, -3, 2).roots; // → [1, 2]
 */
export function decelerate(): void {
  useFastStages(null);
  useMemory(null);
  useSimd(null);
}

function loaded(): Fast | string {
  if (typeof WebAssembly === 'undefined') return 'This engine has no WebAssembly.';
  if (!WebAssembly.validate(vectors())) return 'The WebAssembly of this engine has no SIMD.';
  try {
    const memory = createSimdMemory();
    const stages = createFastStages(memory, bytesOf(CERTIFIED_SIMD));
    return {
      stages,
      simd: { source: simdSource(memory), choose: stages.first },
      allocate: memory.allocate,
    };
  } catch (error) {
    const words = error instanceof Error ? error.message : `${error}`;
    // Under a content security policy engines throw a CompileError or an EvalError.
    return error instanceof RangeError
      ? `There is no room for the memory of WebAssembly: ${words}`
      : `WebAssembly is not allowed here: ${words}`;
  }
}

/** A module with one function, which drops a v128: i8x16.splat of 0. */
const vectors = (): Uint8Array<ArrayBuffer> =>
  Uint8Array.of(
    ...[0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 4, 1, 0x60, 0, 0, 3, 2, 1, 0],
    ...[10, 9, 1, 7, 0, 0x41, 0, 0xfd, 15, 0x1a, 0x0b],
  );
