import { describe, expect, test } from 'vitest';
import { ratios } from '../../../src/math/arithmetic/ratios.ts';
import { walkLength } from '../../../src/math/derivation.ts';
import { DISCRIMINANT, F_OF_T } from '../../../src/math/formula/common.ts';
import { derivative } from '../../../src/math/formula/derivative.ts';
import { evaluate, lift, type Values, withScalars } from '../../../src/math/formula/evaluate.ts';
import { type Expr, minus } from '../../../src/math/formula/expr.ts';
import {
  asZero,
  collected,
  expanded,
  substituteRay,
  summed,
  withT,
} from '../../../src/math/formula/ray-substitution.ts';
import { seeded } from '../../../src/math/rng.ts';
import { SHAPES, type Shape } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import { AXES } from '../../../src/math/vec3.ts';
import { squareCompleted, walkBy, walkOf, walkSide } from '../../../src/math/walk.ts';
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
  const put = substituteRay(zero);
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
    everywhere(() => [[put, summed(all.map((p) => ({ sign: p.sign, expr: withT(p) })))]]);
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

  const steps = walkBy(definition, shape as never, false);

  test('every line of the walk that claims equality with 0 is the same polynomial', () => {
    const lines = steps.slice(1).flatMap((step) => step.lines);
    const claims = lines.filter(({ right, relation }) => right.length === 0 && relation === '=');
    const inT = claims.filter(({ left }) => left.some(({ products }) => products.length > 0));
    expect(inT.length).toBeGreaterThanOrEqual(2);
    for (const { left } of inT) everywhere(() => [[walkSide(left), put]]);
  });

  test('a term is worth the same wherever it stands: one number, one product', () => {
    const numbered = steps.flatMap(({ lines, columns = [] }) =>
      [...lines.flatMap(({ left, right }) => [left, right]), ...columns.map((c) => c.parts)].map(
        (parts) => parts.filter(({ products }) => products.length > 0),
      ),
    );
    for (const parts of numbered) {
      const seen = parts.flatMap(({ products }) => products);
      expect(new Set(seen).size).toBe(seen.length);
    }
    for (const { power, parts } of steps.flatMap(({ columns = [] }) => columns)) {
      for (const { sign, expr, products } of parts) {
        const [own] = products.map((i) => all[i]);
        expect(own?.power).toBe(power);
        everywhere(() => [[summed([{ sign, expr }]), collected(own ? [own] : [], power)]]);
      }
    }
  });

  test('every product comes from a term of the surface, and goes to a coefficient', () => {
    const every = all.map((_, i) => i);
    const of = (id: string): number[] =>
      steps
        .filter((step) => step.id === id)
        .flatMap(({ lines }) => lines.flatMap(({ left, right }) => [...left, ...right]))
        .flatMap(({ products }) => products)
        .sort((a, b) => a - b);
    for (const id of ['surface', 'put-in', 'expand']) expect(of(id), id).toEqual(every);
    if (formula.family === 'curved') {
      for (const id of ['collect', 'coefficients']) expect(of(id), id).toEqual(every);
    }
  });

  test('a flat shape is derived in dot products', () => {
    if (formula.family === 'curved') return;
    const [, in2, in3] = steps.map(({ lines }) => lines[0] && walkSide(lines[0].left));
    expect(in2?.op).toBe('dot');
    expect(in3?.op === 'sum' && in3.terms.length).toBe(2);
    const { offset, rate } = formula as never as { offset: Expr; rate: Expr };
    expect([collected(all, 0), collected(all, 1)]).toEqual([offset, rate]);
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
      evaluate(squareCompleted(), ratios, values),
    );
    expect(ratios.sign(gap)).toBe(0);
  }
});

test.each(SHAPES.map(({ kind }) => kind))('the walk of a %s has its steps', (kind) => {
  const shape = initialShape(kind);
  const ids = walkOf(shape, false).map(({ id }) => id);
  const { bound, family } = { bound: null, ...definitionOf(shape).formula(shape) };
  const middle = ['collect', 'coefficients', 'complete', 'roots', 'normal'];
  const last = family === 'curved' ? middle : bound ? ['t', 'figure'] : ['t'];
  expect(ids).toEqual(['surface', 'put-in', 'expand', ...last]);
  expect(walkOf(shape, true).map(({ id }) => id)).toEqual(ids);
  expect(walkLength(shape)).toBe(ids.length);
});
