import { type Code, get } from './ops.ts';

/**
 * The locals of a function, first come, first numbered; a name has one in its scope and is sought
 * in the scopes around it.
 */
export interface Scope {
  readonly declare: (name: string) => number;
  readonly value: (name: string) => Code;
  /** How many there are, in this and all scopes that share its numbers. */
  readonly count: () => number;
  readonly inner: () => Scope;
}

export function createScope(first: number): Scope {
  const numbers = { next: first };
  const make = (outer: (name: string) => Code): Scope => {
    const known = new Map<string, number>();
    const value = (name: string): Code => {
      const local = known.get(name);
      return local === undefined ? outer(name) : get(local);
    };
    return {
      value,
      declare(name) {
        if (known.has(name)) throw new SyntaxError(`${name} is known already`);
        known.set(name, numbers.next);
        numbers.next += 1;
        return numbers.next - 1;
      },
      count: () => numbers.next - first,
      inner: () => make(value),
    };
  };
  return make((name) => {
    throw new ReferenceError(`${name} is not known`);
  });
}

/** Locals one after the other, by name. */
export const numbered = <Name extends string>(
  first: number,
  ...names: readonly Name[]
): Readonly<Record<Name, number>> =>
  Object.fromEntries(names.map((name, k) => [name, first + k])) as Record<Name, number>;
