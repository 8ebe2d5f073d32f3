import { nextDown, nextUp } from '../float/ulp.ts';
import { toNumber } from './round.ts';
import type { Surd } from './surd.ts';
import { compare, fromNumber } from './surd.ts';

/**
 * The doubles around a, lower first; twice the same if a is a double. Beyond the doubles one of
 * them is infinite; a negative surd above the subnormals lies between −MIN_VALUE and −0.
 */
export function bracket(a: Surd): readonly [number, number] {
  const near = toNumber(a);
  if (near === Infinity) return [Number.MAX_VALUE, Infinity];
  if (near === -Infinity) return [-Infinity, -Number.MAX_VALUE];
  const side = compare(a, fromNumber(near));
  if (side === 0) return [near, near];
  return side > 0 ? [near, nextUp(near)] : [nextDown(near), near];
}

/** Whether x is one of the doubles around a; +0 and −0 count as one. */
export function isFaithful(a: Surd, x: number): boolean {
  const [low, high] = bracket(a);
  return x === low || x === high;
}
