/** Makes an array of zeros for rays or answers. */
export type MakeArray = (length: number) => Float64Array;

/** As MakeArray; null where there is no room for it. */
export type Allocate = (length: number) => Float64Array | null;

let allocate: Allocate | null = null;

/** From now on `kernelArray` is `make`, where that has room; null: ordinary arrays again. */
export function useMemory(make: Allocate | null): void {
  allocate = make;
}

/** The caller's own, to be kept, cloned or transferred. */
export const ownArray: MakeArray = (length) => new Float64Array(length);

/**
 * Where WebAssembly is used, in its memory, so that nothing need be copied: about a tenth of what
 * `certified` costs for both roots. For arrays that stay where they are made: the buffer is shared
 * with all others of this kind, so it cannot be transferred, and cloning one array copies all of
 * it.
 *
 * @param length in doubles.
 * @example
 * kernelArray(3).length; // → 3
 */
export const kernelArray: MakeArray = (length) => allocate?.(length) ?? ownArray(length);
