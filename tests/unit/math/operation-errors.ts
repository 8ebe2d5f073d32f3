import { productError, sumError } from '../../../src/math/float/eft.ts';
import { known, negative, type Off } from './running-error.ts';

/*
 * Running error analysis (running-error.ts), operation by operation: one that happens to be exact
 * adds nothing.
 */

const U = 2 ** -53;

/** `x` is rounded unless `rest` is 0. */
const rounded = (x: number, rest: number, off: number): Off => ({
  x,
  off: off + (rest === 0 ? 0 : U * Math.abs(x)),
});

export function add(a: Off, b: Off): Off {
  const x = a.x + b.x;
  return rounded(x, sumError(a.x, b.x, x), a.off + b.off);
}

export const sub = (a: Off, b: Off): Off => add(a, negative(b));

export function mul(a: Off, b: Off): Off {
  const x = a.x * b.x;
  const off = Math.abs(a.x) * b.off + Math.abs(b.x) * a.off + a.off * b.off;
  return rounded(x, productError(a.x, b.x, x), off);
}

export function div(a: Off, b: Off): Off {
  const x = a.x / b.x;
  return rounded(x, 1, (a.off + Math.abs(x) * b.off) / (Math.abs(b.x) - b.off));
}

export function sqrt({ x, off }: Off): Off {
  const found = Math.sqrt(x);
  return rounded(found, 1, off / (Math.sqrt(Math.max(x - off, 0)) + found));
}

export const abs = ({ x, off }: Off): Off => ({ x: Math.abs(x), off });

/** A size that others are measured by: what it is, a definition and not an approximation. */
export const defined = ({ x }: Off): Off => known(x);

/** x cut to the grid of `grid`: a definition, too. */
export const cut = (x: Off, grid: Off): Off => known(x.x + grid.x - grid.x);
