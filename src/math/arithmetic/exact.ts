import type { Surd } from '../exact/surd.ts';
import * as surd from '../exact/surd.ts';
import type { Arithmetic } from './arithmetic.ts';

/**
 * Exact numbers (u + v√D)/w. Closed under + − × ÷ as long as one square root is in play, which
 * holds for every formula of the course; a second one, or a root of a root, throws RangeError.
 */
export const exact: Arithmetic<Surd> = {
  id: 'exact',
  of: surd.fromNumber,
  add: surd.add,
  sub: surd.sub,
  mul: surd.mul,
  div: surd.div,
  neg: surd.neg,
  sqr: surd.sqr,
  sqrt: surd.sqrt,
  sign: surd.sign,
  toNumber: surd.toNumber,
};
