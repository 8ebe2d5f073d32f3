import { describe, expect, test } from 'vitest';
import type { Arithmetic } from '../../../src/math/arithmetic/arithmetic.ts';
import { exact } from '../../../src/math/arithmetic/exact.ts';
import { float64 } from '../../../src/math/arithmetic/float64.ts';
import {
  DISCRIMINANT,
  DOUBLE_ROOT,
  F_OF_T,
  LINEAR_ROOT,
  POINT,
  ROOTS,
} from '../../../src/math/formula/common.ts';
import {
  alongAxes,
  evaluate,
  evaluateTriple,
  evaluateVector,
  lift,
  type Triple,
  type Values,
  withScalars,
  withVector,
} from '../../../src/math/formula/evaluate.ts';
import {
  comp,
  dot,
  type Expr,
  minus,
  negative,
  norm,
  num,
  over,
  plus,
  plusMinus,
  root,
  scalar,
  signedSum,
  squared,
  times,
  vec,
  vecMinus,
} from '../../../src/math/formula/expr.ts';
import { coefficients, intersect } from '../../../src/math/index.ts';
import { STABLE_Q, STABLE_ROOTS } from '../../../src/math/methods/solvers.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import { initialShape } from '../../../src/state/state.ts';
import { cone, curvedDetails, ray, square } from './shorthand.ts';

/** Numbers that only write down what is done to them: the program that a student would write. */
const written: Arithmetic<string> = {
  id: 'written',
  of: String,
  add: (a, b) => `(${a} + ${b})`,
  sub: (a, b) => `(${a} - ${b})`,
  mul: (a, b) => `(${a} * ${b})`,
  div: (a, b) => `(${a} / ${b})`,
  neg: (a) => `-${a}`,
  sqr: (a) => `${a}²`,
  sqrt: (a) => `√${a}`,
  sign: () => 1,
  toNumber: () => 0,
};

const letters = (v: string): Triple<string> => [`${v}x`, `${v}y`, `${v}z`];
const NAMES: Values<string> = {
  scalars: Object.fromEntries([...'ABCDEacdkrLtqxyz'].map((letter) => [letter, letter])),
  vectors: Object.fromEntries([...'NPCVEdX'].map((letter) => [letter, letters(letter)])),
};
const program = (expr: Expr, branch?: 1 | -1): string => evaluate(expr, written, NAMES, branch);

const [a, b, c] = [scalar('a'), scalar('c'), scalar('r')];

describe('the order of operations is the order in which the formula is written', () => {
  test.each<[Expr, string]>([
    [num(4), '4'],
    [a, 'a'],
    [comp('E', 'z'), 'Ez'],
    [plus(a, b, c), '((a + c) + r)'],
    [plus(a, plus(b, c)), '(a + (c + r))'],
    [plus(a), 'a'],
    [minus(a, b, c), '((a - c) - r)'],
    [signedSum([-1, a], [1, b], [-1, c]), '((-a + c) - r)'],
    [times(num(2), a, b, c), '(((2 * a) * c) * r)'],
    [over(plus(a, b), times(num(2), c)), '((a + c) / (2 * r))'],
    [negative(times(a, b)), '-(a * c)'],
    [squared(minus(a, b)), '(a - c)²'],
    [root(a), '√a'],
    [dot(vec('N'), vec('d')), '(((Nx * dx) + (Ny * dy)) + (Nz * dz))'],
    [
      dot(vec('N'), vecMinus(vec('E'), vec('P'))),
      '(((Nx * (Ex - Px)) + (Ny * (Ey - Py))) + (Nz * (Ez - Pz)))',
    ],
    [norm(vecMinus(vec('X'), vec('C'))), '√(((Xx - Cx)² + (Xy - Cy)²) + (Xz - Cz)²)'],
  ])('%j', (expr, text) => {
    expect(program(expr)).toBe(text);
  });

  test('in doubles it shows: 0.1 + 0.2 + 0.3 from the left', () => {
    const values = { scalars: { a: 0.1, c: 0.2, r: 0.3 }, vectors: {} };
    expect(evaluate(plus(a, b, c), float64, values)).toBe(0.6000000000000001);
    expect(evaluate(plus(a, plus(b, c)), float64, values)).toBe(0.6);
  });
});

describe('±', () => {
  test('takes + unless told otherwise', () => {
    expect(program(plusMinus(a, b))).toBe('(a + c)');
    expect(program(plusMinus(a, b), 1)).toBe('(a + c)');
    expect(program(plusMinus(a, b), -1)).toBe('(a - c)');
  });

  test('the branch reaches down through every operation', () => {
    const deep = negative(root(squared(over(times(num(2), plus(plusMinus(a, b))), c))));
    expect(program(deep, -1)).toBe('-√((2 * (a - c)) / r)²');
  });
});

describe('the formulas that all shapes share', () => {
  test.each<[string, Expr, string]>([
    ['D', DISCRIMINANT, '(B² - ((4 * A) * C))'],
    ['t, +', ROOTS, '((-B + √D) / (2 * A))'],
    ['the double root', DOUBLE_ROOT, '(-B / (2 * A))'],
    ['the root of a line', LINEAR_ROOT, '(-C / B)'],
    ['f', F_OF_T, '(((A * t²) + (B * t)) + C)'],
    ['q for B ≥ 0', STABLE_Q[0], '(-(B + √D) / 2)'],
    ['q for B < 0', STABLE_Q[1], '((√D - B) / 2)'],
    ['q/A', STABLE_ROOTS[0], '(q / A)'],
    ['C/q', STABLE_ROOTS[1], '(C / q)'],
  ])('%s', (_, expr, text) => {
    expect(program(expr)).toBe(text);
  });

  test('t, −', () => {
    expect(program(ROOTS, -1)).toBe('((-B - √D) / (2 * A))');
  });

  test('R(t)', () => {
    expect(evaluateTriple(POINT, written, NAMES)).toEqual([
      '(Ex + (t * dx))',
      '(Ey + (t * dy))',
      '(Ez + (t * dz))',
    ]);
  });
});

/**
 * The course's table (docs/NUMERICS.md) as the programs that its trees are. What every shape's
 * trees have to satisfy is in contract.ts.
 */
const CURVED: Record<string, Record<string, string>> = {
  cylinder: {
    surface: '((x - Cx)² + (z - Cz)²) = r²',
    A: '(dx² + dz²)',
    B: '(((2 * dx) * (Ex - Cx)) + ((2 * dz) * (Ez - Cz)))',
    C: '(((Ex - Cx)² + (Ez - Cz)²) - r²)',
    normal: '(x - Cx), 0, (z - Cz)',
  },
  cone: {
    surface: '((x - Vx)² + (z - Vz)²) = (c² * (y - Vy)²)',
    A: '((dx² + dz²) - (c² * dy²))',
    B: '((((2 * dx) * (Ex - Vx)) + ((2 * dz) * (Ez - Vz))) - (((2 * c²) * dy) * (Ey - Vy)))',
    C: '(((Ex - Vx)² + (Ez - Vz)²) - (c² * (Ey - Vy)²))',
    normal: '(x - Vx), (-c² * (y - Vy)), (z - Vz)',
  },
  hyperboloid: {
    surface: '((x - Cx)² + (z - Cz)²) = ((a * (y - Cy)²) + r²)',
    A: '((dx² + dz²) - (a * dy²))',
    B: '((((2 * dx) * (Ex - Cx)) + ((2 * dz) * (Ez - Cz))) - (((2 * a) * dy) * (Ey - Cy)))',
    C: '((((Ex - Cx)² + (Ez - Cz)²) - (a * (Ey - Cy)²)) - r²)',
    normal: '(x - Cx), (-a * (y - Cy)), (z - Cz)',
  },
  sphere: {
    surface: '(((x - Cx)² + (y - Cy)²) + (z - Cz)²) = r²',
    A: '((dx² + dy²) + dz²)',
    B: '((((2 * dx) * (Ex - Cx)) + ((2 * dy) * (Ey - Cy))) + ((2 * dz) * (Ez - Cz)))',
    C: '((((Ex - Cx)² + (Ey - Cy)²) + (Ez - Cz)²) - r²)',
    normal: '(x - Cx), (y - Cy), (z - Cz)',
  },
  paraboloid: {
    surface: '((x - Vx)² + (z - Vz)²) = (k * (y - Vy))',
    A: '(dx² + dz²)',
    B: '((((2 * dx) * (Ex - Vx)) + ((2 * dz) * (Ez - Vz))) - (k * dy))',
    C: '(((Ex - Vx)² + (Ez - Vz)²) - (k * (Ey - Vy)))',
    normal: '(x - Vx), -(k / 2), (z - Vz)',
  },
};

const N_TIMES = (of: (axis: string) => string): string =>
  `(((Nx * ${of('x')}) + (Ny * ${of('y')})) + (Nz * ${of('z')}))`;

describe('the course’s table', () => {
  test.each(Object.entries(CURVED))('%s', (kind, expected) => {
    const shape = initialShape(kind as Shape['kind']);
    const { surface } = definitionOf(shape);
    const formula = definitionOf(shape).formula(shape);
    if (formula.family !== 'curved') throw new Error('not curved');
    expect({
      surface: `${program(surface.left)} ${surface.relation} ${program(surface.right)}`,
      A: program(formula.A),
      B: program(formula.B),
      C: program(formula.C),
      normal: formula.normal.map((n) => program(n)).join(', '),
    }).toEqual(expected);
  });

  test.each([
    ['plane', 'P', []],
    ['circle', 'C', ['√(((Xx - Cx)² + (Xy - Cy)²) + (Xz - Cz)²) ≤ r']],
    ['square', 'P', ['Py ≤ y', 'y ≤ (Py + L)', 'Pz ≤ z', 'z ≤ (Pz + L)']],
  ] as const)('%s', (kind, point, conditions) => {
    const shape = initialShape(kind);
    const { surface } = definitionOf(shape);
    const formula = definitionOf(shape).formula(shape);
    if (formula.family !== 'flat') throw new Error('not flat');
    const offset = N_TIMES((k) => `(E${k} - ${point}${k})`);
    const rate = N_TIMES((k) => `d${k}`);
    expect(`${program(surface.left)} ${surface.relation} ${program(surface.right)}`).toBe(
      `${N_TIMES((k) => `(X${k} - ${point}${k})`)} = 0`,
    );
    expect(program(formula.offset)).toBe(offset);
    expect(program(formula.rate)).toBe(rate);
    expect(program(formula.t)).toBe(`(-${offset} / ${rate})`);
    expect(
      (formula.bound?.conditions ?? []).map(
        ({ left, relation, right }) => `${program(left)} ${relation} ${program(right)}`,
      ),
    ).toEqual(conditions);
  });

  test('the square asks about the two axes that are not its normal’s', () => {
    const asked = (axis: 'x' | 'y' | 'z') => {
      const shape = square([0, 0, 0], 1, axis);
      const formula = definitionOf(shape).formula(shape);
      if (formula.family !== 'flat') throw new Error('not flat');
      return (formula.bound?.conditions ?? []).map(({ left }) => program(left)).join(' ');
    };
    expect([asked('x'), asked('y'), asked('z')]).toEqual(['Py y Pz z', 'Px x Pz z', 'Px x Py y']);
  });
});

describe('values', () => {
  const values: Values<number> = { scalars: { r: 0.1 }, vectors: { E: [1, 2, 3] } };

  test('are lifted without a rounding', () => {
    const lifted = lift(values, exact);
    const third = exact.div(lifted.scalars.r ?? exact.of(0), exact.of(3));
    // 0.1 is not a tenth: three times its exact third is it again, and ten times it is not 1.
    expect(exact.sign(exact.sub(exact.mul(third, exact.of(3)), exact.of(0.1)))).toBe(0);
    expect(exact.sign(exact.sub(exact.mul(third, exact.of(30)), exact.of(1)))).toBe(1);
    expect(lifted.vectors.E?.map(exact.toNumber)).toEqual([1, 2, 3]);
  });

  test('are added to without being changed', () => {
    const more = withVector(withScalars(values, { t: 5 }), 'd', [7, 8, 9]);
    expect(more).toEqual({
      scalars: { r: 0.1, t: 5 },
      vectors: { E: [1, 2, 3], d: [7, 8, 9] },
    });
    expect(values).toEqual({ scalars: { r: 0.1 }, vectors: { E: [1, 2, 3] } });
    expect(withScalars(values, { r: 2 }).scalars.r).toBe(2);
  });

  test('a symbol without a value is a mistake in the program, and is named', () => {
    const nothing = { scalars: {}, vectors: {} };
    expect(() => evaluate(scalar('c'), float64, nothing)).toThrow(new RangeError('no value for c'));
    expect(() => evaluate(comp('V', 'x'), float64, nothing)).toThrow('no value for V');
    expect(() => evaluate(dot(vec('N'), vec('d')), float64, nothing)).toThrow('no value for N');
    expect(() => evaluateVector(vec('E'), float64, nothing)).toThrow('no value for E');
    expect(() => evaluate(plus(), float64, nothing)).toThrow('no value for an empty sum');
  });

  test('alongAxes asks in the order x, y, z', () => {
    expect(alongAxes((axis) => axis)).toEqual(['x', 'y', 'z']);
  });
});

describe('what a student’s program gets', () => {
  const shape = cone([0, 3, 0], 0.5);
  const r = ray([3, 1, 1], [-0.8, -0.2, -0.3]);

  test('A of the cone is 0.7200000000000001 in doubles, as the plain expression is', () => {
    const dx = -0.8;
    const dy = -0.2;
    const dz = -0.3;
    const slope = 0.5;
    const A = dx * dx + dz * dz - slope * slope * (dy * dy);
    expect(A).toBe(0.7200000000000001);
    expect(coefficients(shape, r, 'textbook').A).toBe(A);
  });

  test('and D 5.440000000000005', () => {
    expect(curvedDetails(intersect(shape, r, 'textbook')).D).toBe(5.440000000000005);
  });

  test('B, C and t by the plain expressions', () => {
    const [Ex, Ey, Ez] = [3, 1 - 3, 1];
    const [dx, dy, dz] = [-0.8, -0.2, -0.3];
    const c2 = 0.5 * 0.5;
    const A = dx * dx + dz * dz - c2 * (dy * dy);
    const B = 2 * dx * Ex + 2 * dz * Ez - 2 * c2 * dy * Ey;
    const C = Ex * Ex + Ez * Ez - c2 * (Ey * Ey);
    const D = B * B - 4 * A * C;
    expect(coefficients(shape, r, 'textbook')).toEqual({ A, B, C });
    expect(intersect(shape, r, 'textbook').hits.map(({ t }) => t)).toEqual([
      (-B - Math.sqrt(D)) / (2 * A),
      (-B + Math.sqrt(D)) / (2 * A),
    ]);
  });
});

describe('float64 says when it cannot tell', () => {
  test('the sign of an overflow, or of NaN, is unknown', () => {
    expect([Infinity, -Infinity, Number.NaN].map(float64.sign)).toEqual(Array(3).fill(Number.NaN));
    expect([2, -3, 0, -0].map(float64.sign)).toEqual([1, -1, 0, 0]);
  });
});
