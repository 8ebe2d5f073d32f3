import type { Dyadic, Sign } from './dyadic.ts';
import * as dy from './dyadic.ts';
import type { Surd } from './surd-type.ts';

/** The sign of u + v√D: when the two terms pull apart, u² against v²D decides. */
export function signOfSum(u: Dyadic, v: Dyadic, D: Dyadic): Sign {
  const signU = dy.sign(u);
  const signV = D.m === 0n ? 0 : dy.sign(v);
  if (signV === 0 || signU === signV) return signU;
  if (signU === 0) return signV;
  const larger = dy.compare(dy.sqr(u), dy.mul(dy.sqr(v), D));
  return larger === 0 ? 0 : larger > 0 ? signU : signV;
}

/**
 * The sign of a, decided by whole numbers.
 *
 * @param a of any unit.
 * @returns no unit: −1, 0 or 1.
 * @see NUMERICS.md, section 4: sums, products, quotients and signs of (u + v√D)/w.
 * @example
 * sign(sub(fromNumber(2), fromNumber(3))); // → -1
 */
export function sign(a: Surd): Sign {
  const top = signOfSum(a.u, a.v, a.D);
  return a.w.m > 0n || top === 0 ? top : top > 0 ? -1 : 1;
}

/**
 * Whether it is 0, exactly.
 *
 * @param a of any unit.
 * @example
 * isZero(fromNumber(-0)); // → true
 */
export const isZero = (a: Surd): boolean => sign(a) === 0;

/** u² − v²D, the product of u + v√D and its conjugate. */
export const norm = (a: Surd): Dyadic => dy.sub(dy.sqr(a.u), dy.mul(dy.sqr(a.v), a.D));
