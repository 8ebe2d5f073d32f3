import type { Source } from './straight.ts';

/** What a kernel runs as: loops of TypeScript, or WebAssembly with vectors (SIMD128). */
export type Target = 'typescript' | 'simd';

let simd: Source | null = null;

/** From now on a kernel that was made without a target is SIMD where there is one, or is not. */
export function useSimd(source: Source | null): void {
  simd = source;
}

/** Null where the module is not accelerated. */
export const simdNow = (): Source | null => simd;
