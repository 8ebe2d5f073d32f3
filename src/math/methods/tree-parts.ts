import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import type { Triple } from '../formula/evaluate.ts';
import type { CurvedDetails, DecidedBy, Hit, Intersection, Sign } from '../intersection.ts';
import type { Vec3 } from '../vec3.ts';
import type { Method, OwnParts } from './define.ts';

/** The parts of a method that walks its trees. */
export interface MethodParts<T> extends OwnParts<T> {
  readonly decidedBy: DecidedBy;
  readonly id: string;
}

/** A method that walks its trees: its functions are those of tree-method.ts, asked with itself. */
export type TreeMethod<T> = Method & MethodParts<T>;

export function rounded<T>([x, y, z]: Triple<T>, { toNumber }: Arithmetic<T>): Vec3 {
  return [toNumber(x), toNumber(y), toNumber(z)];
}

export function signOf<T>(x: T, ar: Arithmetic<T>): Sign | null {
  const sign = ar.sign(x);
  return Number.isNaN(sign) ? null : (sign as Sign);
}

/** The coefficients as they are shown. */
export function curvedDetails<T>([A, B, C]: Triple<T>, D: T, ar: Arithmetic<T>): CurvedDetails {
  const { toNumber } = ar;
  return {
    family: 'curved',
    A: toNumber(A),
    B: toNumber(B),
    C: toNumber(C),
    D: toNumber(D),
    signs: { A: signOf(A, ar), B: signOf(B, ar), C: signOf(C, ar), D: signOf(D, ar) },
  };
}

/**
 * The answer, or 'undecided' without hits if a number of a hit is NaN, or if t of a float method is
 * infinite: it overflowed on the way.
 */
export function answer(found: Intersection): Intersection {
  for (const hit of found.hits) {
    if (isBroken(hit, found.decidedBy !== 'exact'))
      return { ...found, class: 'undecided', hits: [] };
  }
  return found;
}

function isBroken({ t, point, normal }: Hit, isFloat: boolean): boolean {
  const lacks = (v: Vec3): boolean =>
    Number.isNaN(v[0]) || Number.isNaN(v[1]) || Number.isNaN(v[2]);
  return Number.isNaN(t) || lacks(point) || lacks(normal) || (isFloat && !Number.isFinite(t));
}
