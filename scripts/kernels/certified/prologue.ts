import { constant, loadSplat } from '../wasm/ops.ts';
import type { Code } from './expression.ts';

/**
 * Where a loop's constants are found, by array and key: the shape's in memory, at an offset; the
 * bounds as they are.
 */
export interface Numbers {
  readonly inMemory: Readonly<Record<string, (key: string) => number>>;
  readonly known: Readonly<Record<string, Readonly<Record<string, number>>>>;
}

/**
 * A constant in both lanes, and a name that is the same for the same number. Throws ReferenceError
 * for one that is not to be found.
 */
export function numberOf(
  array: string,
  key: string,
  { inMemory, known }: Numbers,
): { id: string; code: Code } {
  const offset = inMemory[array]?.(key);
  if (offset !== undefined) return { id: `at${offset}`, code: loadSplat(offset) };
  const value = known[array]?.[key];
  if (value === undefined) throw new ReferenceError(`${array}[${key}] is not known`);
  const bits = new BigUint64Array(Float64Array.of(value).buffer)[0] as bigint;
  return { id: `is${bits.toString(16)}`, code: constant(value) };
}
