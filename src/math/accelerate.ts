import { type Allocate, useMemory } from './batch/memory.ts';
import { createSimdMemory } from './batch/simd-memory.ts';
import type { Source } from './batch/straight.ts';
import { simdSource } from './batch/straight-simd.ts';
import { useSimd } from './batch/target.ts';
import { createFastRoots } from './methods/certified/fast/index.ts';
import { type FastRoots, useFastRoots } from './methods/certified/quadric-kernel.ts';

interface Fast {
  readonly roots: FastRoots;
  readonly source: Source;
  readonly allocate: Allocate;
}

let made: Fast | null | undefined;

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
  if (made === undefined) made = loaded();
  useFastRoots(made?.roots ?? null);
  useMemory(made?.allocate ?? null);
  useSimd(made?.source ?? null);
  return made !== null;
}

/**
 * Undoes `accelerate`; its memory stays, for arrays that were made in it.
 *
 * @example
 * decelerate();
 * solveQuadratic(1, -3, 2).roots; // → [1, 2]
 */
export function decelerate(): void {
  useFastRoots(null);
  useMemory(null);
  useSimd(null);
}

function loaded(): Fast | null {
  if (typeof WebAssembly === 'undefined') return null;
  try {
    const memory = createSimdMemory();
    return {
      roots: createFastRoots(memory),
      source: simdSource(memory),
      allocate: memory.allocate,
    };
  } catch {
    // CompileError without vectors, that or EvalError under a policy, RangeError without room.
    return null;
  }
}
