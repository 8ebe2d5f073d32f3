import type { Arithmetic, Triple } from '../math/formula.ts';
import type { Vec3 } from '../math/index.ts';
import type { Answer, Answers } from './types.ts';

/** A student's own finite value of a quantity; undefined without one. */
export function ownNumber<T>(own: Answers, id: string, ar: Arithmetic<T>): T | undefined {
  const x = own[id];
  return typeof x === 'number' && Number.isFinite(x) ? ar.of(x) : undefined;
}

export const ownTriple = <T>(own: Answers, id: string, ar: Arithmetic<T>): Triple<T> | undefined =>
  usableTriple(own[id], ar);

export function usableTriple<T>(v: Answer | undefined, ar: Arithmetic<T>): Triple<T> | undefined {
  if (typeof v !== 'object' || !v.every(Number.isFinite)) return undefined;
  return [ar.of(v[0]), ar.of(v[1]), ar.of(v[2])];
}

export const roundedTriple = <T>([x, y, z]: Triple<T>, { toNumber }: Arithmetic<T>): Vec3 => [
  toNumber(x),
  toNumber(y),
  toNumber(z),
];
