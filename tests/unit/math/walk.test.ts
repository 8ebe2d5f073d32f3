import { describe, expect, test } from 'vitest';
import { ratios } from '../../../src/math/arithmetic/ratios.ts';
import { DISCRIMINANT, F_OF_T } from '../../../src/math/formula/common.ts';
import { derivative } from '../../../src/math/formula/derivative.ts';
import { evaluate, lift, type Values, withScalars } from '../../../src/math/formula/evaluate.ts';
import { type Expr, minus } from '../../../src/math/formula/expr.ts';
import {
  asZero,
  collected,
  expanded,
  rayPutIn,
  writtenOut,
} from '../../../src/math/formula/ray-put-in.ts';
import { seeded } from '../../../src/math/rng.ts';
import { SHAPES, type Shape } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import { AXES } from '../../../src/math/vec3.ts';
import { SQUARE_COMPLETED, walkOf } from '../../../src/math/walk.ts';
import { initialShape } from '../../../src/state/state.ts';
import { ellipticCylinder } from '../toy-shape.ts';

/* Each step of a derivation is the one before, as a polynomial: exact rationals, random points. */

const ROUNDS = 40;

/** Rationals that no accident makes equal: every symbol for itself. */
function randomValues(shape: Shape, definition: typeof ellipticCylinder, seed: number) {
  const random = seeded(seed);
  const number = (): number => Math.round((random() - 0.5) * 2 ** 12) / 2 ** 5 + 2 ** -7;
  const { scalars, vectors } = definition.values(shape as never);
  const triple = (): [number, number, number] => [number(), number(), number()];
  const names = [...Object.keys(scalars), 't', 'x', 'y', 'z'];
  const values: Values<number> = {
    scalars: Object.fromEntries(names.map((id) => [id, number()])),
    vectors: Object.fromEntries([...Object.keys(vectors), 'E', 'd'].map((id) => [id, triple()])),
  };
  const { x = 0, y = 0, z = 0 } = values.scalars;
  return lift({ ...values, vectors: { ...values.vectors, X: [x, y, z] } }, ratios);
}

const DEFINITIONS = [
  ...SHAPES.map((own) => ({
    definition: own as never as typeof ellipticCylinder,
    shape: initialShape(own.kind),
  })),
  {
    definition: ellipticCylinder,
    shape: { kind: 'elliptic-cylinder', center: [0, 1, 0], radius: 1.5 } as never as Shape,
  },
];

describe.each(DEFINITIONS)('$shape.kind', ({ definition, shape }) => {
  const formula = definition.formula(shape as never);
  const zero = asZero(definition.surface);
  const put = rayPutIn(zero);
  const all = expanded(put);

  const everywhere = (same: (values: ReturnType<typeof randomValues>) => [Expr, Expr][]): void => {
    for (let seed = 1; seed <= ROUNDS; seed++) {
      const values = randomValues(shape, definition, seed);
      for (const [a, b] of same(values)) {
        const gap = ratios.sub(evaluate(a, ratios, values), evaluate(b, ratios, values));
        expect(ratios.sign(gap)).toBe(0);
      }
    }
  };

  test('the surface as one sum', () => {
    const { left, right } = definition.surface;
    everywhere(() => [[zero, minus(left, right)]]);
  });

  test('the ray put in is the surface at E + t d', () => {
    for (let seed = 1; seed <= ROUNDS; seed++) {
      const values = randomValues(shape, definition, seed);
      const { E, d } = values.vectors;
      const at = AXES.map((_, i) =>
        ratios.add(E?.[i] as never, ratios.mul(values.scalars.t as never, d?.[i] as never)),
      ) as never;
      const there = withScalars(
        { ...values, vectors: { ...values.vectors, X: at } },
        { x: at[0], y: at[1], z: at[2] },
      );
      const gap = ratios.sub(evaluate(put, ratios, values), evaluate(zero, ratios, there));
      expect(ratios.sign(gap)).toBe(0);
    }
  });

  test('expanded, it is the same polynomial', () => {
    everywhere(() => [[put, writtenOut(all)]]);
  });

  test('collected, it has the coefficients of the shape, to the sign', () => {
    const own =
      formula.family === 'curved'
        ? [formula.C, formula.B, formula.A]
        : [
            (formula as never as { offset: Expr }).offset,
            (formula as never as { rate: Expr }).rate,
          ];
    expect(Math.max(...all.map(({ power }) => power))).toBe(own.length - 1);
    everywhere(() => own.map((tree, power) => [collected(all, power), tree]));
  });

  test('every line of the walk that claims equality with 0 is the same polynomial', () => {
    if (!SHAPES.some(({ kind }) => kind === shape.kind)) return;
    const [, ...steps] = walkOf(shape, false).slice(0, 4);
    for (const { lines } of steps) {
      for (const { left } of lines) everywhere(() => [[left, put]]);
    }
  });

  test('half the gradient is the normal of the shape, to the sign', () => {
    if (formula.family !== 'curved') return;
    everywhere(() =>
      AXES.flatMap((axis, i): [Expr, Expr][] => {
        const twice = {
          op: 'product',
          factors: [{ op: 'number', value: 2 }, formula.normal[i] as Expr],
        } as const;
        return [[derivative(zero, axis) ?? { op: 'number', value: 0 }, twice]];
      }),
    );
  });
});

test('the square completed is f', () => {
  for (let seed = 1; seed <= ROUNDS; seed++) {
    const random = seeded(seed);
    const [A, B, C, t] = [1, 2, 3, 4].map(() =>
      ratios.of(Math.round(random() * 4096) / 64 - 31.25),
    );
    const scalars = { A, B, C, t } as unknown as Record<string, never>;
    const D = evaluate(DISCRIMINANT, ratios, { scalars, vectors: {} }) as never;
    const values = { scalars: { ...scalars, D }, vectors: {} };
    const gap = ratios.sub(
      evaluate(F_OF_T, ratios, values),
      evaluate(SQUARE_COMPLETED, ratios, values),
    );
    expect(ratios.sign(gap)).toBe(0);
  }
});

test.each(SHAPES.map(({ kind }) => kind))(
  'the walk of a %s begins and ends as it should',
  (kind) => {
    const names = walkOf(initialShape(kind), false).map(({ name }) => name);
    expect(names.slice(0, 4)).toEqual(['surface', 'put in', 'expand', 'collect']);
    expect(definitionOf(initialShape(kind)).formula(initialShape(kind)).family === 'curved').toBe(
      names.at(-1) === 'normal',
    );
  },
);
