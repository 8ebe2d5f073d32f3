import { AXES } from './vec3.ts';

/**
 * Thrown for an input that is not in the domain. The message is short, lower-case and quotes the
 * value.
 *
 * @example
 * const error = new InvalidInput('radius must be ≥ 0, got -1');
 * error instanceof RangeError; // → true
 * String(error); // → 'InvalidInput: radius must be ≥ 0, got -1'
 */
export class InvalidInput extends RangeError {
  override readonly name = 'InvalidInput';
}

export function requireFinite(name: string, x: unknown): asserts x is number {
  if (typeof x !== 'number' || !Number.isFinite(x)) {
    throw refused(name, 'must be a finite number', x);
  }
}

const isOrdinary = (x: unknown): boolean => typeof x === 'number' && x - x === 0;

/** Three finite numbers in any kind of list. */
export function requireFiniteVector(name: string, v: unknown): asserts v is ArrayLike<number> {
  // Nearly every vector is in order: words are put together only for one that is not.
  if (
    Array.isArray(v) &&
    v.length === 3 &&
    isOrdinary(v[0]) &&
    isOrdinary(v[1]) &&
    isOrdinary(v[2])
  )
    return;
  if (!isList(v) || v.length !== 3) {
    throw refused(name, 'must have three components', v);
  }
  AXES.forEach((axis, i) => {
    requireFinite(`${name}.${axis}`, v[i]);
  });
}

const isList = (x: unknown): x is ArrayLike<unknown> =>
  typeof x === 'object' && x !== null && Number.isSafeInteger((x as ArrayLike<unknown>).length);

/**
 * Throws InvalidInput if `given` has a field of its own that is not among `fields`: a height of a
 * cylinder would be ignored in silence. One that is undefined is as good as missing. `besides` is
 * one more field, which need not be told of.
 */
export function requireFields(
  what: string,
  given: object | null | undefined,
  fields: readonly string[],
  besides?: string,
): void {
  for (const key in given) {
    if (key === besides || fields.includes(key)) continue;
    const own = Object.hasOwn(given, key) && given[key as keyof typeof given] !== undefined;
    if (own) {
      throw new InvalidInput(
        `${quote(key)} means nothing for a ${what}, which has ${fields.join(', ')}`,
      );
    }
  }
}

/**
 * How many fields it has. Where that is as many as are needed, and these are there, no name need be
 * looked at, which costs more.
 */
export function countFields(given: object): number {
  let count = 0;
  for (const _ in given) count += 1;
  return count;
}

export function requireNonZero(name: string, v: ArrayLike<number>): void {
  if (v[0] === 0 && v[1] === 0 && v[2] === 0) {
    throw new InvalidInput(`${name} must not be zero, got ${quote(v)}`);
  }
}

/**
 * What a value must be, and what it is instead.
 *
 * @param name what is asked for: 'radius'.
 * @param must how it has to be: 'must be ≥ 0'.
 * @param x the value that was given.
 * @example
 * refused('radius', 'must be ≥ 0', -1).message; // → 'radius must be ≥ 0, got -1'
 * refused('radius', 'must be ≥ 0', undefined).message; // → 'radius is missing'
 */
export function refused(name: string, must: string, x: unknown): InvalidInput {
  const isMissing = x === undefined || x === null;
  return new InvalidInput(isMissing ? `${name} is missing` : `${name} ${must}, got ${quote(x)}`);
}

/**
 * A value as messages show it: short, and of a list the first four.
 *
 * @param x anything.
 * @example
 * [quote('cone'), quote(-0), quote([1, 2, 3])]; // → ["'cone'", '-0', '(1, 2, 3)']
 */
export function quote(x: unknown): string {
  if (typeof x === 'string') return `'${x.slice(0, 60)}'`;
  if (Object.is(x, -0)) return '-0';
  if (isList(x)) return `(${Array.prototype.slice.call(x, 0, 4).map(quote).join(', ')})`;
  if (x === undefined || x === null) return 'nothing';
  return typeof x === 'object' ? 'an object' : String(x);
}
