import { describe, expect, test } from 'vitest';
import type { Arithmetic } from '../../../src/math/arithmetic/arithmetic.ts';
import { exact } from '../../../src/math/arithmetic/exact.ts';
import { float64 } from '../../../src/math/arithmetic/float64.ts';
import { type Interval, interval } from '../../../src/math/arithmetic/interval.ts';
import * as surd from '../../../src/math/exact/surd.ts';
import { FAMILIES, type Question } from '../../../src/math/families.ts';
import { evaluate, evaluateTriple, withScalars } from '../../../src/math/formula/evaluate.ts';
import { courseForm, type Form, momentForm } from '../../../src/math/methods/forms.ts';
import { METHODS } from '../../../src/math/methods/index.ts';
import { solveBy, stableSolver } from '../../../src/math/methods/solvers.ts';
import { valuesOf } from '../../../src/math/methods/tree-method.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { CurvedFormula } from '../../../src/math/shapes/axial-quadric.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import type { FlatFormula } from '../../../src/math/shapes/planar.ts';
import { solveQuadratic } from '../../../src/math/solve-quadratic.ts';
import { rayCases } from './read-vectors.ts';

/*
 * What the methods are made of: the two forms against each other, bounds and enclosures against
 * exact arithmetic.
 */

const random = seeded(91);
const drawn: Question[] = FAMILIES().flatMap(({ make }) =>
  Array.from({ length: 25 }, () => make(random)),
);
const all: Question[] = [...rayCases, ...drawn];
const formulaOf = ({ shape }: Question) => definitionOf(shape).formula(shape);
const curved = all.filter((q) => formulaOf(q).family === 'curved');
const flat = all.filter((q) => formulaOf(q).family === 'flat');

function coefficientsIn<T>(q: Question, ar: Arithmetic<T>, form: Form) {
  const formula = formulaOf(q) as CurvedFormula;
  const values = valuesOf(q.shape, q.ray, ar);
  const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], ar, values);
  const D = form.discriminant(formula, withScalars(values, { A, B, C }), ar);
  return { A, B, C, D };
}

function meetingIn<T>(q: Question, ar: Arithmetic<T>, form: Form) {
  const formula = formulaOf(q) as FlatFormula;
  const values = valuesOf(q.shape, q.ray, ar);
  const rate = evaluate(formula.rate, ar, values);
  if (ar.sign(rate) === 0) return null;
  const withRate = withScalars(values, { rate });
  const t = evaluate(formula.t, ar, withRate);
  return form.meeting(formula, withScalars(withRate, { t }), ar);
}

const holding = ({ excesses }: { readonly excesses: readonly surd.Surd[] }): boolean[] =>
  excesses.map((excess) => exact.sign(excess) <= 0);

describe('the moment form is the course’s form, in exact arithmetic', () => {
  test(`D of ${curved.length} curved cases`, () => {
    for (const q of curved) {
      const course = coefficientsIn(q, exact, courseForm).D;
      const moment = coefficientsIn(q, exact, momentForm).D;
      expect([surd.compare(course, moment), JSON.stringify(q)]).toEqual([0, JSON.stringify(q)]);
    }
  });

  test(`X and every condition of ${flat.length} flat cases`, () => {
    for (const q of flat) {
      const course = meetingIn(q, exact, courseForm);
      const moment = meetingIn(q, exact, momentForm);
      expect(moment && holding(moment)).toEqual(course && holding(course));
      course?.x.forEach((c, i) => {
        expect(surd.compare(c, moment?.x[i] as surd.Surd)).toBe(0);
      });
    }
  });

  test('both outcomes of every condition were among them', () => {
    const seen = new Set<string>();
    for (const q of flat) {
      const moment = meetingIn(q, exact, momentForm);
      if (moment)
        holding(moment).forEach((h, i) => {
          seen.add(`${q.shape.kind} ${i} ${h}`);
        });
    }
    const expected = ['circle 0', ...[0, 1, 2, 3].map((i) => `square ${i}`)];
    expect([...seen].sort()).toEqual(expected.flatMap((s) => [`${s} false`, `${s} true`]).sort());
  });
});

/** |x|: what a bound on rounding errors is made of. */
const magnitude: Arithmetic<number> = {
  ...float64,
  of: Math.abs,
  sub: (a, b) => a + b,
  neg: (a) => a,
};

describe('moment: |δD| ≤ 12u of its terms, all taken positive', () => {
  const inRange = curved.filter((q) => {
    const { A, C, D } = coefficientsIn(q, magnitude, momentForm);
    return [A, C, D].every((x) => x > 1e-200 && x < 1e200);
  });

  test(`on ${inRange.length} cases`, () => {
    let worst = 0;
    for (const q of inRange) {
      // p = E − C is one rounding, relative to the difference: not |E| + |C|.
      const { ray } = q;
      const own = definitionOf(q.shape).values(q.shape);
      const center = own.vectors.C ?? own.vectors.V ?? ray.origin;
      const p = ray.origin.map((x, i) => x - (center[i] ?? 0));
      const formula = formulaOf(q) as CurvedFormula;
      const id = own.vectors.C ? 'C' : 'V';
      const values = {
        scalars: Object.fromEntries(Object.entries(own.scalars).map(([k, x]) => [k, Math.abs(x)])),
        vectors: {
          E: [Math.abs(p[0] ?? 0), Math.abs(p[1] ?? 0), Math.abs(p[2] ?? 0)] as const,
          [id]: [0, 0, 0] as const,
          d: [
            Math.abs(ray.direction[0]),
            Math.abs(ray.direction[1]),
            Math.abs(ray.direction[2]),
          ] as const,
        },
      };
      const A = evaluate(formula.A, magnitude, values);
      const terms = momentForm.discriminant(formula, withScalars(values, { A }), magnitude);
      const truth = coefficientsIn(q, exact, momentForm).D;
      const got = coefficientsIn(q, float64, momentForm).D;
      const off = Math.abs(exact.toNumber(exact.sub(exact.of(got), truth)));
      if (terms === 0) expect(off).toBe(0);
      else worst = Math.max(worst, off / terms / 2 ** -53);
    }
    expect(worst).toBeLessThan(12);
    // It is a bound that means something.
    expect(worst).toBeGreaterThan(1.5);
  });
});

describe('interval: every number it computes holds the exact one', () => {
  const holds = ({ lo, hi }: Interval, x: surd.Surd): boolean =>
    (lo === -Infinity || surd.compare(surd.fromNumber(lo), x) <= 0) &&
    (hi === Infinity || surd.compare(x, surd.fromNumber(hi)) <= 0);

  test('A, B, C, D and the roots', () => {
    let roots = 0;
    for (const q of curved) {
      const truth = coefficientsIn(q, exact, momentForm);
      const bounds = coefficientsIn(q, interval(), momentForm);
      for (const id of ['A', 'B', 'C', 'D'] as const) {
        expect([id, holds(bounds[id], truth[id])]).toEqual([id, true]);
      }
      const found = solveBy(stableSolver, bounds.A, bounds.B, bounds.C, bounds.D, interval());
      if (found.class === 'undecided') continue;
      const solved = solveBy(stableSolver, truth.A, truth.B, truth.C, truth.D, exact);
      found.roots.forEach((t, i) => {
        expect(holds(t, solved.roots[i] as surd.Surd), JSON.stringify(q)).toBe(true);
        roots += 1;
      });
    }
    expect(roots).toBeGreaterThan(1000);
  });

  test('the place in a plane', () => {
    for (const q of flat) {
      const truth = meetingIn(q, exact, momentForm);
      const bounds = meetingIn(q, interval(), momentForm);
      bounds?.x.forEach((c, i) => {
        if (truth) expect(holds(c, truth.x[i] as surd.Surd)).toBe(true);
      });
    }
  });
});

describe.each(METHODS)('solveQuadratic by $id', ({ id }) => {
  const solve = (A: number, B: number, C: number) => solveQuadratic(A, B, C, id);

  test.each([
    [1, -3, 2, 'two', [1, 2]],
    [-1, 3, -2, 'two', [1, 2]],
    [1, -2, 1, 'tangent', [1]],
    [1, 0, 1, 'none', []],
    [0, 2, -3, 'one', [1.5]],
    [0, 0, 1, 'none', []],
    [0, 0, 0, 'contained', []],
    [1, 0, -4, 'two', [-2, 2]],
    [1, 5, 0, 'two', [-5, 0]],
  ] as const)('%d, %d, %d: %s', (A, B, C, verdict, roots) => {
    const found = solve(A, B, C);
    expect(found.class).toBe(verdict);
    expect(found.roots.map((t) => t + 0)).toEqual(roots);
  });

  test('an overflow is undecided, unless the method has no range to leave', () => {
    const found = solve(1e300, 1e300, 1e-300);
    if (id === 'exact' || id === 'certified') expect(found.class).toBe('two');
    else expect(found).toEqual({ class: 'undecided', roots: [] });
  });

  test('a double root with long fractions: methods above float64 may tell, none says NaN', () => {
    const found = solve(0.1, 0.2, 0.1);
    expect(found.roots.some(Number.isNaN)).toBe(false);
  });
});

test('roots at both ends of the doubles stand in order: their difference overflows', () => {
  const end = 2 ** 1023;
  const found = solveQuadratic(-1 / end, 0, end, 'stable');
  expect(found).toEqual({ class: 'two', roots: [-end, end] });
});
