import { describe, expect, test } from 'vitest';
import { coefficients, InvalidInput, intersect, SHAPES } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { initialShape } from '../../../src/state/state.ts';
import { ray } from './shorthand.ts';

/**
 * Types are for those who write TypeScript; a student's page or a worker's message may hold
 * anything.
 */
type Anything = Record<string, unknown>;

const GOOD: Ray = ray([1, 2, 3], [0, 0, 1]);

/**
 * What is thrown, by either entry to the kernel; the test fails if one of them throws nothing or
 * something else.
 */
function refusal(shape: unknown, r: unknown = GOOD): string {
  const messages = [intersect, coefficients].map((f) => {
    try {
      f(shape as Shape, r as Ray);
    } catch (error) {
      if (error instanceof InvalidInput) return error.message;
      throw error;
    }
    return 'nothing was thrown';
  });
  expect(messages[1]).toBe(messages[0]);
  return messages[0] ?? '';
}

/** A good shape with one of its parameters, or one component of it, made wrong. */
function spoiled(kind: Shape['kind'], key: string, value: unknown): Anything {
  return { ...initialShape(kind), [key]: value };
}

const fields = SHAPES.flatMap(({ kind, params }) =>
  params.map((param) => ({ kind, key: param.key, param })),
);
const vectors = fields.filter(({ param }) => param.type === 'vector');
const numbers = fields.filter(({ param }) => param.type === 'number');

const NOT_FINITE = [
  [Number.NaN, 'NaN'],
  [Infinity, 'Infinity'],
  [-Infinity, '-Infinity'],
] as const;

describe.each(vectors)('$kind, $key', ({ kind, key, param }) => {
  test.each(NOT_FINITE)('%d in any component', (bad, text) => {
    const quoted = (axis: string) => `${key}.${axis} must be a finite number, got ${text}`;
    expect(refusal(spoiled(kind, key, [bad, 1, 1]))).toBe(quoted('x'));
    expect(refusal(spoiled(kind, key, [1, bad, 1]))).toBe(quoted('y'));
    expect(refusal(spoiled(kind, key, [1, 1, bad]))).toBe(quoted('z'));
  });

  test.each([
    [undefined, `${key} is missing`],
    [null, `${key} is missing`],
    [7, `${key} must have three components, got 7`],
    ['1,2,3', `${key} must have three components, got '1,2,3'`],
    [[], `${key} must have three components, got ()`],
    [[1, 2], `${key} must have three components, got (1, 2)`],
    [[1, 2, 3, 4], `${key} must have three components, got (1, 2, 3, 4)`],
    [{ x: 1, y: 2, z: 3 }, `${key} must have three components, got an object`],
    [['1', 2, 3], `${key}.x must be a finite number, got '1'`],
    [[1, null, 3], `${key}.y is missing`],
    [[1, 2, undefined], `${key}.z is missing`],
    [[1, 2, [3]], `${key}.z must be a finite number, got (3)`],
  ])('%s', (bad, message) => {
    expect(refusal(spoiled(kind, key, bad))).toBe(message);
  });

  test('missing', () => {
    const shape = { ...initialShape(kind) } as unknown as Anything;
    delete shape[key];
    expect(refusal(shape)).toBe(`${key} is missing`);
  });

  test('zero is refused only where it has no direction', () => {
    const shape = spoiled(kind, key, [0, 0, 0]);
    if (param.type === 'vector' && param.nonZero) {
      expect(refusal(shape)).toBe(`${key} must not be zero, got (0, 0, 0)`);
      expect(refusal(spoiled(kind, key, [-0, 0, -0]))).toMatch(/^\w+ must not be zero, got \(/);
    } else {
      expect(() => intersect(shape as unknown as Shape, GOOD)).not.toThrow();
    }
  });
});

describe.each(numbers)('$kind, $key', ({ kind, key, param }) => {
  test.each([
    ...NOT_FINITE,
    ['1', "'1'"],
    ['', "''"],
    [[1], '(1)'],
    [true, 'true'],
    [{}, 'an object'],
  ] as [unknown, string][])('%s', (bad, text) => {
    expect(refusal(spoiled(kind, key, bad))).toBe(`${key} must be a finite number, got ${text}`);
  });

  test.each([undefined, null])('%s', (bad) => {
    expect(refusal(spoiled(kind, key, bad))).toBe(`${key} is missing`);
  });

  test('negative', () => {
    const least = param.type === 'number' ? param.least : undefined;
    if (least === undefined) {
      expect(() => intersect(spoiled(kind, key, -1) as unknown as Shape, GOOD)).not.toThrow();
    } else {
      expect(refusal(spoiled(kind, key, -1))).toBe(`${key} must be ≥ 0, got -1`);
      expect(refusal(spoiled(kind, key, -Number.MIN_VALUE))).toBe(
        `${key} must be ≥ 0, got -5e-324`,
      );
      expect(() => intersect(spoiled(kind, key, 0) as unknown as Shape, GOOD)).not.toThrow();
    }
  });
});

test('radii and sides may not be negative, slopes and flares may', () => {
  for (const { kind, key, param } of numbers) {
    const least = param.type === 'number' ? param.least : undefined;
    if (/^(radius|side)$/.test(key)) expect([kind, key, least]).toEqual([kind, key, 0]);
    if (/^(slope|flare)$/.test(key)) expect([kind, key, least]).toEqual([kind, key, undefined]);
  }
});

test('normals may not be zero, points may', () => {
  for (const { kind, key, param } of vectors) {
    const nonZero = param.type === 'vector' && param.nonZero === true;
    expect([kind, key, nonZero]).toEqual([kind, key, key === 'normal']);
  }
});

describe('the square’s axis', () => {
  test.each([
    ['w', "axis must be x, y or z, got 'w'"],
    ['X', "axis must be x, y or z, got 'X'"],
    ['', "axis must be x, y or z, got ''"],
    [undefined, 'axis is missing'],
    [1, 'axis must be x, y or z, got 1'],
    [['x'], "axis must be x, y or z, got ('x')"],
  ])('%s', (bad, message) => {
    expect(refusal(spoiled('square', 'axis', bad))).toBe(message);
  });
});

describe('the ray', () => {
  const shape = initialShape('cone');
  describe.each(['origin', 'direction'] as const)('%s', (key) => {
    test.each(NOT_FINITE)('%d in any component', (bad, text) => {
      const quoted = (axis: string) => `${key}.${axis} must be a finite number, got ${text}`;
      expect(refusal(shape, { ...GOOD, [key]: [bad, 1, 1] })).toBe(quoted('x'));
      expect(refusal(shape, { ...GOOD, [key]: [1, bad, 1] })).toBe(quoted('y'));
      expect(refusal(shape, { ...GOOD, [key]: [1, 1, bad] })).toBe(quoted('z'));
    });

    test.each([
      [undefined, `${key} is missing`],
      [null, `${key} is missing`],
      ['1,2,3', `${key} must have three components, got '1,2,3'`],
      [[1, 2], `${key} must have three components, got (1, 2)`],
      [[1, 2, 3, 4], `${key} must have three components, got (1, 2, 3, 4)`],
      [[1, '2', 3], `${key}.y must be a finite number, got '2'`],
    ])('%s', (bad, message) => {
      expect(refusal(shape, { ...GOOD, [key]: bad })).toBe(message);
    });
  });

  test('a zero direction', () => {
    expect(refusal(shape, ray([1, 2, 3], [0, 0, 0]))).toBe(
      'direction must not be zero, got (0, 0, 0)',
    );
    expect(refusal(shape, ray([1, 2, 3], [0, -0, 0]))).toMatch(/^direction must not be zero/);
  });

  test('the smallest direction there is, and the origin at zero', () => {
    expect(() => intersect(shape, ray([0, 0, 0], [0, 0, Number.MIN_VALUE]))).not.toThrow();
  });

  test.each([[null], [undefined], [7], ['E']])('%s instead of a ray', (bad) => {
    expect(() => intersect(shape, bad as unknown as Ray)).toThrow(InvalidInput);
    expect(() => coefficients(shape, bad as unknown as Ray)).toThrow('origin is missing');
  });
});

describe('the shape', () => {
  test.each([
    [null, 'kind is missing'],
    [undefined, 'kind is missing'],
    [7, 'kind is missing'],
    ['cone', 'kind is missing'],
    [{}, 'kind is missing'],
    [{ kind: 'torus' }, "unknown shape 'torus'"],
    [{ kind: 'Cone', vertex: [0, 0, 0], slope: 1 }, "unknown shape 'Cone'"],
    [{ kind: 'toString' }, "unknown shape 'toString'"],
    [{ kind: '__proto__' }, "unknown shape '__proto__'"],
    [{ kind: 3 }, 'unknown shape 3'],
    [{ kind: ['cone'] }, "unknown shape ('cone')"],
  ])('%j', (bad, message) => {
    expect(refusal(bad)).toBe(message);
  });
});

describe('the method', () => {
  const shape = initialShape('cone');
  test.each([
    ['Exact', "unknown method 'Exact'"],
    ['', "unknown method ''"],
    ['toString', "unknown method 'toString'"],
    [null, 'unknown method nothing'],
    [3, 'unknown method 3'],
  ])('%s', (bad, message) => {
    expect(() => intersect(shape, GOOD, bad as string)).toThrow(new InvalidInput(message));
    expect(() => coefficients(shape, GOOD, bad as string)).toThrow(new InvalidInput(message));
  });
});

describe('InvalidInput', () => {
  test('is a RangeError with a name of its own', () => {
    const error = new InvalidInput('x');
    expect(error).toBeInstanceOf(RangeError);
    expect(error.name).toBe('InvalidInput');
  });

  test('messages are one short line in lower case, however long the value', () => {
    const long = 'A'.repeat(100_000);
    for (const message of [
      refusal({ kind: long }),
      refusal(spoiled('cone', 'slope', long)),
      refusal(spoiled('cone', 'vertex', Array(1e5).fill(long))),
      refusal(spoiled('square', 'axis', long)),
    ]) {
      expect(message.length).toBeLessThan(350);
      expect(message[0]).toMatch(/[a-z]/);
      expect(message).not.toContain('\n');
    }
  });

  test('input is left as it was', () => {
    const shape = Object.freeze({ ...initialShape('cone') });
    const r = Object.freeze(
      ray(Object.freeze([3, 1, 1]) as never, Object.freeze([-1, 0, 0]) as never),
    );
    expect(() => intersect(shape as Shape, r)).not.toThrow();
  });
});
