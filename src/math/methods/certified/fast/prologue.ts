import type { Code } from '../../../wasm/expression.ts';
import type { Scope } from '../../../wasm/locals.ts';
import { constant, loadSplat, set } from '../../../wasm/ops.ts';
import type { Constant } from '../../../wasm/source.ts';

/** Where a loop's constants are found: the shape's in memory, at an offset by key; the bounds as they are. */
export interface Numbers {
  readonly inMemory: Readonly<Record<string, (key: string) => number>>;
  readonly known: Readonly<Record<string, ArrayLike<number>>>;
}

/** Each constant in both lanes of a local. Throws ReferenceError for one that is not to be found. */
export function constantsOf(constants: readonly Constant[], numbers: Numbers, scope: Scope): Code {
  return constants.flatMap(({ name, array, key }) => {
    const offset = numbers.inMemory[array]?.(key);
    if (offset !== undefined) return set(scope.declare(name), loadSplat(offset));
    const value = numbers.known[array]?.[Number(key)];
    if (value === undefined) throw new ReferenceError(`${array}[${key}] is not known`);
    return set(scope.declare(name), constant(value));
  });
}
