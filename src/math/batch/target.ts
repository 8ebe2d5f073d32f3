import type { Choose, Source } from './straight.ts';

/** What a kernel runs as: loops of TypeScript, or WebAssembly with vectors (SIMD128). */
export type Target = 'typescript' | 'simd';

/** Loops with vectors, and what `first` makes of their roots. */
export interface Simd {
  readonly source: Source;
  readonly choose: Choose;
}

let simd: Simd | null = null;

/** From now on a kernel that was made without a target is SIMD where there is one, or is not. */
export function useSimd(now: Simd | null): void {
  simd = now;
}

/** Null where the module is not accelerated. */
export const simdNow = (): Simd | null => simd;
