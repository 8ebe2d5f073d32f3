import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { exact } from '../../../../src/math/arithmetic/exact.ts';
import type { Dyadic } from '../../../../src/math/exact/dyadic.ts';
import { bracket } from '../../../../src/math/exact/faithful.ts';
import type { Surd } from '../../../../src/math/exact/surd.ts';
import * as surd from '../../../../src/math/exact/surd.ts';
import { roundedRoots, solveExact } from './solve-exact.ts';

/*
 * The curved cases, with the course's formulas written out once more: this tests the arithmetic (a
 * point E + t d and its normal are surds over √D), not the shapes.
 */
type Vec = [number, number, number];
type Numbers = (number | string)[];
interface Case {
  id: string;
  shape: { kind: string; slope?: number; flare?: number; radius?: number } & Record<
    string,
    unknown
  >;
  ray: { origin: Vec; direction: Vec };
  expect: {
    class: string;
    degree: number;
    discriminantSign: number;
    coefficients: Numbers;
    roots: Numbers;
    faithful: Numbers[];
    points: Numbers[];
    normals: Numbers[];
    singular: boolean[];
  };
}
const url = new URL('../../../vectors/rays.jsonl', import.meta.url);
const curved = readFileSync(url, 'utf8')
  .trim()
  .split('\n')
  .map((line): Case => JSON.parse(line))
  .filter(({ shape }) => ['cylinder', 'cone', 'hyperboloid'].includes(shape.kind));

const { of, add, sub, mul, sqr, neg } = exact;
/** x² + z² − a y², as a bilinear form. */
const form = (a: Surd, p: Surd[], q: Surd[]) =>
  [of(1), neg(a), of(1)].map((k, i) => mul(k, mul(at(p, i), at(q, i)))).reduce(add);
const at = (p: Surd[], i: number): Surd => p[i] ?? of(Number.NaN);

function coefficients({ shape, ray }: Case) {
  const a = shape.slope === undefined ? of(shape.flare ?? 0) : sqr(of(shape.slope));
  const rho = sqr(of(shape.radius ?? 0));
  const center = (shape.vertex ?? shape.center) as Vec;
  const d = ray.direction.map(of);
  const p = ray.origin.map((x, i) => sub(of(x), of(center[i] ?? Number.NaN)));
  const B = mul(of(2), form(a, d, p));
  return { a, d, center, A: form(a, d, d), B, C: sub(form(a, p, p), rho) };
}

const dyadic = ({ u, w }: Surd): Dyadic => ({ m: u.m * w.m, e: u.e - w.e });
const rounded = (v: Surd[]) => v.map(exact.toNumber);
const bits = (v: Numbers) => v.map(Number);

test('1000 cases or nearly, of three shapes', () => expect(curved.length).toBe(950));

test('class, degree, coefficients and roots are bit-equal', () => {
  for (const c of curved) {
    const { A, B, C } = coefficients(c);
    const solution = solveExact(dyadic(A), dyadic(B), dyadic(C));
    const { class: name, degree, discriminantSign } = c.expect;
    expect(solution, c.id).toMatchObject({ class: name, degree, discriminantSign });
    expect(rounded([A, B, C]), c.id).toEqual(bits(c.expect.coefficients));
    expect(roundedRoots(solution), c.id).toEqual(bits(c.expect.roots));
    expect(solution.roots.map(bracket), c.id).toEqual(c.expect.faithful.map(bits));
  }
});

test('points and normals from the exact root are bit-equal', () => {
  for (const c of curved) {
    const { a, d, center, A, B, C } = coefficients(c);
    for (const [k, t] of solveExact(dyadic(A), dyadic(B), dyadic(C)).roots.entries()) {
      const point = c.ray.origin.map((x, i) => add(of(x), mul(t, at(d, i))));
      const [x, y, z] = point.map((x, i) => sub(x, of(center[i] ?? Number.NaN)));
      const normal = [x ?? t, neg(mul(a, y ?? t)), z ?? t];
      expect(rounded(point), c.id).toEqual(bits(c.expect.points[k] ?? []));
      expect(rounded(normal), c.id).toEqual(bits(c.expect.normals[k] ?? []));
      expect(normal.every(surd.isZero), c.id).toBe(c.expect.singular[k]);
    }
  }
});
