/** What a kernel runs as: loops of TypeScript, or WebAssembly with vectors (SIMD128). */
export type Target = 'typescript' | 'simd';

let accelerated = false;

/** From now on a kernel that was made without a target is SIMD where there is one, or is not. */
export function setAccelerated(on: boolean): void {
  accelerated = on;
}

export const isAccelerated = (): boolean => accelerated;
