import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import type { Triple } from '../formula/evaluate.ts';
import type { DecidedBy, Intersection, Sign } from '../intersection.ts';
import type { Vec3 } from '../vec3.ts';
import type { Form } from './forms.ts';
import type { Solver } from './solvers.ts';

/** What a method that walks its trees is made of. */
export interface MethodParts<T> {
  readonly arithmetic: Arithmetic<T>;
  readonly form: Form;
  readonly solver: Solver;
  readonly decidedBy: DecidedBy;
  readonly id: string;
}

export function rounded<T>([x, y, z]: Triple<T>, { toNumber }: Arithmetic<T>): Vec3 {
  return [toNumber(x), toNumber(y), toNumber(z)];
}

export function signOf<T>(x: T, ar: Arithmetic<T>): Sign | null {
  const sign = ar.sign(x);
  return Number.isNaN(sign) ? null : (sign as Sign);
}

/**
 * A float method whose roots or points overflowed into NaN says that it cannot tell, rather than
 * print them.
 */
export function answer(found: Intersection): Intersection {
  const numbers = found.hits.flatMap(({ t, point, normal }) => [t, ...point, ...normal]);
  const broken =
    numbers.some(Number.isNaN) ||
    (found.decidedBy !== 'exact' && found.hits.some(({ t }) => !Number.isFinite(t)));
  return broken ? { ...found, class: 'undecided', hits: [] } : found;
}
