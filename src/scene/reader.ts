import { InvalidInput, type Vec3 } from '../math/index.ts';
import { AXES, type Axis, quote, refused } from '../math/shapes.ts';

/**
 * Reads a value of an untrusted file. `path`: its place in the file, as
 * `things[2].material.mirror`. Throws InvalidInput.
 */
export type Reader<T> = (value: unknown, path: string) => T;

export const number =
  (low: number, high: number): Reader<number> =>
  (value, path) => {
    if (typeof value !== 'number' || !(value >= low && value <= high)) {
      throw refused(path, `must be a number from ${low} to ${high}`, value);
    }
    return value;
  };

export const vector =
  (component: Reader<number>): Reader<Vec3> =>
  (value, path) => {
    if (!Array.isArray(value) || value.length !== 3) {
      throw refused(path, 'must have three components', value);
    }
    const at = (i: 0 | 1 | 2): number => component(value[i], `${path}.${AXES[i]}`);
    return [at(0), at(1), at(2)];
  };

export const nonZero =
  (read: Reader<Vec3>): Reader<Vec3> =>
  (value, path) => {
    const v = read(value, path);
    if (v.every((x) => x === 0)) throw new InvalidInput(`${path} must not be zero, got (0, 0, 0)`);
    return v;
  };

export const text =
  (longest: number): Reader<string> =>
  (value, path) => {
    if (typeof value !== 'string' || value === '' || value.length > longest) {
      throw refused(path, `must be a text of 1 to ${longest} characters`, value);
    }
    return value;
  };

export const colour: Reader<string> = (value, path) => {
  if (typeof value !== 'string' || !/^#[0-9a-f]{6}$/i.test(value)) {
    throw refused(path, `must be a colour like '#8a5cc2'`, value);
  }
  return value.toLowerCase();
};

export const flag: Reader<boolean> = (value, path) => {
  if (typeof value !== 'boolean') {
    throw refused(path, 'must be true or false', value);
  }
  return value;
};

export const oneOf =
  <W extends string>(words: readonly W[]): Reader<W> =>
  (value, path) => {
    const found = words.find((word) => word === value);
    if (found === undefined) {
      throw refused(path, `must be ${words.join(', ')}`, value);
    }
    return found;
  };

export const axis: Reader<Axis> = oneOf(AXES);

export const listOf =
  <T>(item: Reader<T>, most: number): Reader<readonly T[]> =>
  (value, path) => {
    if (!Array.isArray(value)) throw refused(path, 'must be a list', value);
    if (value.length > most) {
      throw new InvalidInput(`${path} may have at most ${most} entries, got ${value.length}`);
    }
    return value.map((one, i) => item(one, `${path}[${i}]`));
  };

type Fields<T> = { readonly [K in keyof T]-?: Reader<Exclude<T[K], undefined>> };

/** Reads a record with exactly these keys, of which some are optional; other keys are refused. */
export function record<T extends object>(
  fields: Fields<T>,
  optional: readonly (keyof T)[] = [],
): Reader<T> {
  const known = Object.entries<Reader<unknown>>(fields);
  return (value, path) => {
    const given = fieldsOf(value, path);
    const dot = path === '' ? '' : `${path}.`;
    for (const key of Object.keys(given)) {
      if (!Object.hasOwn(fields, key)) {
        throw new InvalidInput(`${quote(key)} means nothing in ${path || 'a scene'}`);
      }
    }
    const entries = known
      .filter(([key]) => Object.hasOwn(given, key) || !optional.includes(key as keyof T))
      .map(([key, read]) => [key, read(given[key], `${dot}${key}`)] as const);
    return Object.fromEntries(entries) as T;
  };
}

/** Reads one of several records, chosen by the word under `key`. */
export function variant<T>(key: string, variants: Readonly<Record<string, Reader<T>>>): Reader<T> {
  const word = oneOf(Object.keys(variants));
  return (value, path) => {
    const which = word(fieldsOf(value, path)[key], `${path}.${key}`);
    return (variants[which] as Reader<T>)(value, path);
  };
}

export function fieldsOf(value: unknown, path: string): Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    throw refused(path || 'a scene', 'must be an object', value);
  }
  return value as Readonly<Record<string, unknown>>;
}
