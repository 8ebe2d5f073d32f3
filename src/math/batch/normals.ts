import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { evaluateTriple, lift, type Values } from '../formula/evaluate.ts';
import type { CurvedFormula } from '../shapes/axial-quadric.ts';
import { withPoint } from '../shapes/planar.ts';

/** What a value may be: one number, or any that has these. */
interface Possible {
  readonly known: number | null;
  readonly zero: boolean;
  readonly infinite: boolean;
  readonly nan: boolean;
}

const known = (x: number): Possible => ({
  known: x,
  zero: x === 0,
  infinite: Math.abs(x) === Number.POSITIVE_INFINITY,
  nan: Number.isNaN(x),
});
const any = (nan: boolean): Possible => ({ known: null, zero: true, infinite: true, nan });

/** Follows a formula with numbers of `ar` to where a NaN may come from. */
function possibilities(ar: Arithmetic<number>): Arithmetic<Possible> {
  type Binary = (a: number, b: number) => number;
  const binary =
    (of: Binary, makesNaN: (a: Possible, b: Possible) => boolean) =>
    (a: Possible, b: Possible): Possible =>
      a.known !== null && b.known !== null
        ? known(of(a.known, b.known))
        : any(a.nan || b.nan || makesNaN(a, b));
  const unary =
    (of: (a: number) => number, makesNaN: boolean) =>
    (a: Possible): Possible =>
      a.known === null ? any(a.nan || makesNaN) : known(of(a.known));
  const bothInfinite = (a: Possible, b: Possible): boolean => a.infinite && b.infinite;
  return {
    id: 'possibilities',
    of: (x) => known(ar.of(x)),
    add: binary(ar.add, bothInfinite),
    sub: binary(ar.sub, bothInfinite),
    mul: binary(ar.mul, (a, b) => (a.zero && b.infinite) || (a.infinite && b.zero)),
    div: binary(ar.div, (a, b) => (a.zero && b.zero) || bothInfinite(a, b)),
    neg: unary(ar.neg, false),
    sqr: unary(ar.sqr, false),
    sqrt: unary(ar.sqrt, true),
    sign: () => Number.NaN,
    toNumber: () => Number.NaN,
  };
}

/**
 * Whether a hit, so far away that a coordinate overflowed, may lack its normal: 0·∞. Then a method
 * answers 'undecided', which roots alone do not tell.
 *
 * @param values what the shape's symbols stand for, as stored.
 */
export function mayLackNormal(
  { normal }: CurvedFormula,
  values: Values<number>,
  ar: Arithmetic<number>,
): boolean {
  const possible = possibilities(ar);
  const anywhere = any(false);
  const at = withPoint(lift(values, possible), [anywhere, anywhere, anywhere]);
  return evaluateTriple(normal, possible, at).some(({ nan }) => nan);
}

/** |x| is from `least` to `most`. */
interface Size {
  readonly least: number;
  readonly most: number;
}

/** Bounds of sizes; `told` gets each. */
function sizes(told: (size: Size) => void): Arithmetic<Size> {
  const size = (least: number, most: number): Size => {
    told({ least, most });
    return { least, most };
  };
  const product = (a: Size, b: Size): Size =>
    size(a.least * b.least, a.most === 0 || b.most === 0 ? 0 : a.most * b.most);
  const sum = (a: Size, b: Size): Size => size(0, a.most + b.most);
  return {
    id: 'sizes',
    of: (x) => size(Math.abs(x), Math.abs(x)),
    add: sum,
    sub: sum,
    mul: product,
    div: (a, b) => size(a.least / b.most, a.most / b.least),
    neg: (a) => a,
    sqr: (a) => product(a, a),
    sqrt: ({ least, most }) => size(Math.sqrt(least), Math.sqrt(most)),
    sign: () => Number.NaN,
    toNumber: () => Number.NaN,
  };
}

/**
 * A bound of all numbers on the way to the normal at a place within `most`; Infinity: none is
 * known.
 *
 * @param values what the shape's symbols stand for, as stored.
 */
export function largestIn({ normal }: CurvedFormula, values: Values<number>, most: number): number {
  let largest = 0;
  const ar = sizes((size) => {
    largest = Math.max(largest, size.most);
  });
  const anywhere = { least: 0, most };
  evaluateTriple(normal, ar, withPoint(lift(values, ar), [anywhere, anywhere, anywhere]));
  return Number.isNaN(largest) ? Number.POSITIVE_INFINITY : largest;
}
