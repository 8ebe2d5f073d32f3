import { atSpecialAngle, degreesIn } from '../../text/angles.ts';
import type { Typed, TypedBinary, TypedUnary } from '../../text/typed.ts';
import type { Dyadic } from './dyadic.ts';
import { bitLength } from './isqrt.ts';
import type { Surd } from './surd.ts';
import * as surd from './surd.ts';

/** Most bits of a power that is worked out exactly; a larger one is left to the doubles. */
const LONGEST = 20_000;

const one = (): Surd => surd.fromNumber(1);

/**
 * The exact value of what was typed: fractions and the root of one. Null for what is not one: π,
 * sin(1), √2 + √3.
 *
 * @param tree what the parser of typed numbers makes of a text.
 * @returns a number in the unit of the text; angles in radians.
 * @see NUMERICS.md, section 4: sums, products, quotients and signs of (u + v√D)/w.
 * @example
 * const third = exactOf({ op: 'number', text: '0.25' });
 * toNumber(third!); // → 0.25
 * exactOf({ op: 'constant', name: 'pi' }); // → null
 */
export function exactOf(tree: Typed): Surd | null {
  try {
    return numberOf(tree);
  } catch (error) {
    if (error instanceof RangeError) return null;
    throw error;
  }
}

function numberOf(tree: Typed): Surd | null {
  switch (tree.op) {
    case 'number':
      return decimal(tree.text);
    case 'constant':
      return null;
    case 'unit': {
      const of = numberOf(tree.of);
      return of && (tree.name === 'rad' || surd.isZero(of)) ? of : null;
    }
    case 'unary':
      return unary(tree);
    case 'binary':
      return binary(tree);
  }
}

/** '1.25e-3' = 125 / 10⁵. */
function decimal(text: string): Surd {
  const [, whole = '', fraction = '', exponent = '0'] =
    /^(\d*)\.?(\d*)(?:e([+-]?\d+))?$/.exec(text) ?? [];
  const digits = BigInt(whole + fraction);
  const places = fraction.length - Number(exponent);
  if (digits === 0n) return surd.fromNumber(0);
  const power = { m: 10n ** BigInt(Math.abs(places)), e: 0 };
  const m = { m: digits, e: 0 };
  return places > 0 ? surd.ratio(m, power) : surd.fromDyadic({ m: digits * power.m, e: 0 });
}

function unary(tree: TypedUnary): Surd | null {
  const degrees = degreesIn(tree);
  if (degrees) return ofDegrees(tree.name, numberOf(degrees));
  const of = numberOf(tree.of);
  if (!of) return null;
  switch (tree.name) {
    case '+':
      return of;
    case '-':
      return surd.neg(of);
    case 'abs':
      return surd.sign(of) < 0 ? surd.neg(of) : of;
    case 'sqrt':
      return surd.sqrt(of);
    case 'ln':
      return surd.compare(of, one()) === 0 ? surd.fromNumber(0) : null;
    default:
      // Elsewhere than at 0 these are transcendental (Lindemann).
      if (!surd.isZero(of)) return null;
      return surd.fromNumber(tree.name === 'cos' || tree.name === 'exp' ? 1 : 0);
  }
}

function ofDegrees(name: string, angle: Surd | null): Surd | null {
  const near = angle && surd.toNumber(angle);
  if (near === null || angle === null) return null;
  if (surd.compare(angle, surd.fromNumber(near)) !== 0) return null;
  const known = atSpecialAngle(name, near);
  if (!known) return null;
  const root = surd.sqrt(surd.div(surd.fromNumber(known.over), surd.fromNumber(known.under)));
  return known.sign < 0 ? surd.neg(root) : root;
}

function binary({ name, left, right }: TypedBinary): Surd | null {
  const a = numberOf(left);
  const b = numberOf(right);
  if (!a || !b) return null;
  switch (name) {
    case '+':
      return surd.add(a, b);
    case '-':
      return surd.sub(a, b);
    case '*':
      return surd.mul(a, b);
    case '/':
      return surd.div(a, b);
    default:
      return power(a, b);
  }
}

function power(base: Surd, exponent: Surd): Surd | null {
  const n = surd.toNumber(exponent);
  const isWhole = Number.isInteger(n) && surd.compare(exponent, surd.fromNumber(n)) === 0;
  const { u, v, w, D } = base;
  if (!isWhole || Math.abs(n) * (bits(u) + bits(v) + bits(w) + bits(D)) > LONGEST) return null;
  let result = one();
  for (let i = 0; i < Math.abs(n); i++) result = surd.mul(result, base);
  return n < 0 ? surd.div(one(), result) : result;
}

const bits = ({ m, e }: Dyadic): number => bitLength(m) + Math.abs(e);
