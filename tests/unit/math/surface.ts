import type { Arithmetic } from '../../../src/math/arithmetic/arithmetic.ts';
import { exact } from '../../../src/math/arithmetic/exact.ts';
import { float64 } from '../../../src/math/arithmetic/float64.ts';
import type { Surd } from '../../../src/math/exact/surd.ts';
import {
  evaluate,
  evaluateTriple,
  lift,
  type Triple,
  type Values,
  withScalars,
  withVector,
} from '../../../src/math/formula/evaluate.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';

/*
 * The surface's own equation, asked in several number systems. It knows nothing of A, B, C: what is
 * found here about roots is found by looking at the surface along the ray.
 */

function at<T>(shape: Shape, x: Triple<T>, ar: Arithmetic<T>): Values<T> {
  const own = lift(definitionOf(shape).values(shape), ar);
  return withVector(withScalars(own, { x: x[0], y: x[1], z: x[2] }), 'X', x);
}

function leftMinusRight<T>(shape: Shape, x: Triple<T>, ar: Arithmetic<T>): T {
  const { left, right } = definitionOf(shape).surface;
  const values = at(shape, x, ar);
  return ar.sub(evaluate(left, ar, values), evaluate(right, ar, values));
}

/** left − right of the surface's equation at X, as a program in doubles gets it. */
export const residual = (shape: Shape, x: Vec3): number => leftMinusRight(shape, x, float64);

/**
 * Every term with its absolute value and every minus a plus: what a rounding error is to be
 * measured against.
 */
const magnitude: Arithmetic<number> = {
  ...float64,
  of: Math.abs,
  sub: float64.add,
  neg: (a) => a,
};

const size = (x: Vec3): Vec3 => [Math.abs(x[0]), Math.abs(x[1]), Math.abs(x[2])];

/** How large the terms of the equation are at most, for coordinates up to |x|. */
export const termsAt = (shape: Shape, x: Vec3): number => leftMinusRight(shape, size(x), magnitude);

/** f(t), exactly: the equation at E + t d. */
export function fAt(shape: Shape, { origin, direction }: Ray, t: Surd): Surd {
  const coordinate = (i: 0 | 1 | 2): Surd =>
    exact.add(exact.of(origin[i]), exact.mul(t, exact.of(direction[i])));
  return leftMinusRight(shape, [coordinate(0), coordinate(1), coordinate(2)], exact);
}

const HALF = exact.of(0.5);

/** A, B, C of f from three of its values, exactly; a quadratic has no more to it. */
export function polynomial(shape: Shape, ray: Ray): { A: Surd; B: Surd; C: Surd } {
  const [before, C, after] = [-1, 0, 1].map((t) => fAt(shape, ray, exact.of(t))) as [
    Surd,
    Surd,
    Surd,
  ];
  const A = exact.sub(exact.mul(exact.add(after, before), HALF), C);
  return { A, B: exact.mul(exact.sub(after, before), HALF), C };
}

/**
 * ∇(left − right) at X, exactly: for a polynomial of second degree (f(X + e) − f(X − e))/2 is the
 * derivative itself, not an approximation of it.
 */
export function gradient(shape: Shape, x: Vec3): Triple<Surd> {
  const point: Triple<Surd> = [exact.of(x[0]), exact.of(x[1]), exact.of(x[2])];
  const moved = (i: number, by: number): Surd => {
    const there = point.map((c, k) => (k === i ? exact.add(c, exact.of(by)) : c));
    return leftMinusRight(shape, there as unknown as Triple<Surd>, exact);
  };
  const along = (i: number): Surd => exact.mul(exact.sub(moved(i, 1), moved(i, -1)), HALF);
  return [along(0), along(1), along(2)];
}

/** The course's normal at X, from its tree (N itself for a flat shape), exactly. */
export function courseNormal(shape: Shape, x: Vec3): Triple<Surd> {
  const values = at<Surd>(shape, [exact.of(x[0]), exact.of(x[1]), exact.of(x[2])], exact);
  const formula = definitionOf(shape).formula(shape);
  if (formula.family === 'curved') return evaluateTriple(formula.normal, exact, values);
  return values.vectors.N as Triple<Surd>;
}

/** How large the terms of the gradient are at most, for coordinates up to |x|. */
export function gradientTerms(shape: Shape, x: Vec3): number {
  const formula = definitionOf(shape).formula(shape);
  const values = at(shape, size(x), magnitude);
  const terms =
    formula.family === 'curved'
      ? evaluateTriple(formula.normal, magnitude, values)
      : (values.vectors.N as Vec3);
  return 2 * Math.hypot(...terms.map(Math.abs));
}
