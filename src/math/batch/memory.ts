/** Makes an array of zeros; null where there is no room for it. */
export type Allocate = (length: number) => Float64Array | null;

let allocate: Allocate | null = null;

/** From now on the arrays of rays and answers are made by `make`, where it has room; null: as ordinary arrays again. */
export function useMemory(make: Allocate | null): void {
  allocate = make;
}

/**
 * An array of zeros for rays or answers: where WebAssembly is used, in its memory, so that nothing need be copied. Such an array's buffer is shared: it is not to be transferred, and
 * a view of a part does not keep the array from being collected.
 */
export const doubles = (length: number): Float64Array =>
  allocate?.(length) ?? new Float64Array(length);
