import { describe, expect, test } from 'vitest';
import { coefficients, InvalidInput, intersect, METHODS, SHAPES } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { initialShape } from '../../../src/state/state.ts';
import { ray } from './shorthand.ts';

/*
 * What a caller may give that is not quite a Shape, a Ray or options: more fields, other kinds of
 * lists, null.
 */

const GOOD: Ray = ray([4, 0.5, 3], [-1, 0.25, -0.5]);
const KINDS = SHAPES.map(({ kind }) => kind);
const FIELDS = [...new Set(SHAPES.flatMap(({ params }) => params.map(({ key }) => key)))];

function thrown(act: () => unknown): unknown {
  try {
    act();
  } catch (error) {
    return error;
  }
  return null;
}

describe.each(SHAPES)('$kind', ({ kind, params }) => {
  const own = params.map(({ key }) => key);
  const foreign = [...FIELDS, 'height', 'heights', 'Radius', ''].filter(
    (key) => !own.includes(key),
  );

  test.each(foreign)(
    'a field %j of its own has none: refused, with the fields that there are',
    (key) => {
      const shape = { ...initialShape(kind), [key]: 1 } as Shape;
      const refusal = new InvalidInput(
        `'${key}' means nothing for a ${kind}, which has ${own.join(', ')}`,
      );
      expect(thrown(() => intersect(shape, GOOD))).toEqual(refusal);
      expect(thrown(() => coefficients(shape, GOOD))).toEqual(refusal);
      const from = { from: shape };
      expect(thrown(() => intersect(initialShape(kind), GOOD, 'certified', from))).toEqual(refusal);
    },
  );

  test('a field that is undefined, or inherited, is none', () => {
    const plain = intersect(initialShape(kind), GOOD);
    const more = { ...initialShape(kind), height: undefined } as unknown as Shape;
    expect(intersect(more, GOOD)).toEqual(plain);
    const heir = Object.assign(Object.create({ height: 3 }), initialShape(kind)) as Shape;
    expect(intersect(heir, GOOD)).toEqual(plain);
  });
});

test.each(['tMin', 'kind', 'd'])('a field %j of a ray', (key) => {
  const refusal = new InvalidInput(`'${key}' means nothing for a ray, which has origin, direction`);
  const odd = { ...GOOD, [key]: 0 } as Ray;
  expect(thrown(() => intersect(initialShape('cone'), odd))).toEqual(refusal);
  expect(thrown(() => coefficients(initialShape('cone'), odd))).toEqual(refusal);
});

/** The same numbers in other lists. */
const LISTS: readonly (readonly [string, (v: readonly number[]) => ArrayLike<number>])[] = [
  ['Float64Array', (v) => Float64Array.from(v)],
  ['Float32Array', (v) => Float32Array.from(v)],
  ['a part of a larger array', (v) => Float64Array.of(9, ...v, 9).subarray(1, 4)],
  ['an object with a length', ([x = 0, y = 0, z = 0]) => ({ 0: x, 1: y, 2: z, length: 3 })],
  ['a frozen array', (v) => Object.freeze([...v])],
];

describe.each(LISTS)('vectors as %s', (_, listOf) => {
  const given = (object: object): never =>
    Object.fromEntries(
      Object.entries(object).map(([key, x]) => [key, Array.isArray(x) ? listOf(x) : x]),
    ) as never;

  test.each(METHODS.flatMap(({ id }) => KINDS.map((kind) => [id, kind] as const)))(
    '%s, %s: the same answer, made of plain arrays',
    (id, kind) => {
      const shape = initialShape(kind);
      const plain = intersect(shape, GOOD, id);
      const found = intersect(given(shape), given(GOOD), id);
      expect(found).toEqual(plain);
      expect(JSON.stringify(found)).toBe(JSON.stringify(plain));
      for (const { point, normal } of found.hits) {
        expect(Array.isArray(point) && Array.isArray(normal)).toBe(true);
      }
      expect(coefficients(given(shape), given(GOOD), id)).toEqual(coefficients(shape, GOOD, id));
    },
  );

  test.each(KINDS)('%s: the ray starts on the same shape', (kind) => {
    const shape = initialShape(kind);
    const from = intersect(shape, GOOD, 'exact', { from: shape });
    expect(intersect(given(shape), given(GOOD), 'exact', { from: given(shape) })).toEqual(from);
    expect(intersect(shape, GOOD, 'exact', { from: given(shape) })).toEqual(from);
  });
});

test.each<[unknown, string]>([
  [new Float64Array(2), 'center must have three components, got (0, 0)'],
  [Float64Array.of(1, Number.NaN, 2), 'center.y must be a finite number, got NaN'],
  [new BigInt64Array(3), 'center.x must be a finite number, got 0'],
  [new Map([[1, 2]]), 'center must have three components, got an object'],
  ['abc', "center must have three components, got 'abc'"],
  [(_a: 1, _b: 2, _c: 3) => 0, 'center must have three components, got (_a, _b, _c) => 0'],
])('what is no list of three numbers: %o', (center, message) => {
  const shape = { ...initialShape('cylinder'), center } as Shape;
  expect(thrown(() => intersect(shape, GOOD))).toEqual(new InvalidInput(message));
});

describe('options', () => {
  const shape = initialShape('cone');
  const plain = intersect(shape, GOOD);
  test.each([[null], [undefined], [{}], [{ from: undefined }], [{ from: null }]])(
    '%j are none',
    (none) => {
      expect(intersect(shape, GOOD, 'certified', none)).toEqual(plain);
    },
  );
  test('another name is refused', () => {
    const odd = { form: shape } as object;
    expect(thrown(() => intersect(shape, GOOD, 'certified', odd))).toEqual(
      new InvalidInput("'form' means nothing for a set of options, which has from"),
    );
  });
});
