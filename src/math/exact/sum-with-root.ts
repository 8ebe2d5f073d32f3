import type { Dyadic } from './dyadic.ts';
import * as dy from './dyadic.ts';
import { bitLength, isqrt } from './isqrt.ts';

/** Bits of √D that are kept: two machine words, so that u + v√D may cancel about 60 of them. */
const ROOT_BITS = 128;

/** u + v√D, off by less than |v| units of the root's last bit. v and D must not be 0. */
export const sumWithRoot = (u: Dyadic, v: Dyadic, D: Dyadic): Dyadic =>
  dy.add(u, dy.mul(v, rootOf(D)));

/** Whether that `sum` has a relative error under 2^-63, and hence the right sign. */
export function hasLeadingBits(sum: Dyadic, u: Dyadic, v: Dyadic, D: Dyadic): boolean {
  // Terms of one sign keep at least 126 bits.
  if (u.m < 0n === v.m < 0n) return true;
  const errorBelow = bitLength(v.m) + v.e + rootOf(D).e;
  return sum.m !== 0n && bitLength(sum.m) - 1 + sum.e - errorBelow >= 63;
}

/**
 * The last root taken. Both hits of a ray, with their points and normals, are surds over one and
 * the same D object; this is a memo only, and no result depends on it.
 */
let last: { readonly D: Dyadic; readonly root: Dyadic } | null = null;

function rootOf(D: Dyadic): Dyadic {
  if (last?.D !== D) last = { D, root: rootBelow(D) };
  return last.root;
}

/** √D cut to its first 128 bits: less than one unit too low. */
function rootBelow(D: Dyadic): Dyadic {
  let up = 2 * ROOT_BITS - bitLength(D.m);
  // 255 or 256 bits under the root, whichever leaves an even exponent.
  if (((D.e - up) & 1) !== 0) up -= 1;
  const m = up >= 0 ? D.m << BigInt(up) : D.m >> BigInt(-up);
  return { m: isqrt(m), e: (D.e - up) / 2 };
}
