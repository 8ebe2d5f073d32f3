import { displayParts, MINUS } from '../../text/format.ts';
import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import { float64 } from '../arithmetic/float64.ts';
import { type Ratio, ratios } from '../arithmetic/ratios.ts';
import { evaluate, type Values } from './evaluate.ts';
import { type Expr, scalar } from './expr.ts';
import { isWorked } from './print/leaves.ts';

/** How a line is written with its numbers put in. */
export interface Written {
  /** Whether −B, √D, 2A and N·d stand there worked out. */
  readonly worked: boolean;
  /** Significant digits of each number. */
  readonly digits: number;
}

/** Digits of a result on the page. */
const RESULT_DIGITS = 6;

/**
 * Whether a reader who works the line out from the numbers that are printed in it, without any
 * rounding, gets the printed result in all its digits. False also where the line has no value.
 *
 * @param expr the line, a tree.
 * @param values doubles by symbol, in the units of the formula: what is rounded for print.
 * @param written how the line stands there.
 * @param result a double, in the unit of the line; six digits of it are printed.
 * @param branch the sign taken at ±.
 * @example
 * const values = { scalars: { B: 1.23456, A: 1, C: 0.25 }, vectors: {} };
 * const D = 1.23456 * 1.23456 - 1;
 * reproduces(DISCRIMINANT, values, { worked: false, digits: 6 }, D); // → true
 * reproduces(DISCRIMINANT, values, { worked: false, digits: 3 }, D); // → false
 */
export function reproduces(
  expr: Expr,
  values: Values<number>,
  written: Written,
  result: number,
  branch: 1 | -1 = 1,
): boolean {
  if (expr.op === 'norm') {
    const squared = recomputed({ op: 'dot', left: expr.of, right: expr.of }, values, written);
    return squared !== null && rootRoundsTo(squared, result, RESULT_DIGITS);
  }
  const value = recomputed(expr, values, written, branch);
  return value !== null && roundsTo(value, result, RESULT_DIGITS);
}

/**
 * The exact value of the line as it is printed; null where a number of it is not finite, or it has
 * no value.
 *
 * @param expr the line, a tree.
 * @param values doubles by symbol, in the units of the formula.
 * @param written how the line stands there; `branch` is the sign taken at ±.
 * @returns in the unit of the line.
 * @see NUMERICS.md, section 7
 * @example
 * const half = over(scalar('a'), num(2));
 * recomputed(half, { scalars: { a: 1.25 }, vectors: {} }, { worked: false, digits: 2 });
 * // → { n: 13n, d: 2n, e: -1 }
 */
export function recomputed(
  expr: Expr,
  values: Values<number>,
  { worked, digits }: Written,
  branch: 1 | -1 = 1,
): Ratio | null {
  const decimal = (x: Ratio | number): Ratio => (typeof x === 'number' ? asPrinted(x, digits) : x);
  const both = (f: typeof ratios.add) => (a: Ratio | number, b: Ratio | number) =>
    f(decimal(a), decimal(b));
  const one = (f: typeof ratios.neg) => (a: Ratio | number) => f(decimal(a));
  const { add, sub, mul, div, neg, sqr } = ratios;
  // A number becomes a decimal where the line needs it: most lines hold few of the values.
  const inDecimals: Arithmetic<Ratio | number> = {
    ...ratios,
    add: both(add),
    sub: both(sub),
    mul: both(mul),
    div: both(div),
    neg: one(neg),
    sqr: one(sqr),
  };
  try {
    const scalars = { ...values.scalars };
    const put = worked ? workedOut(expr, values, scalars) : expr;
    return decimal(evaluate(put, inDecimals, { ...values, scalars }, branch));
  } catch (error) {
    // No value for a symbol, a division by zero, the root of a negative number.
    if (error instanceof RangeError) return null;
    throw error;
  }
}

/**
 * Whether every number that is put in is finite.
 *
 * @param expr the line, a tree.
 * @param values doubles by symbol, in the units of the formula.
 * @param worked whether −B, √D, 2A and N·d stand there worked out.
 * @example
 * isWritable(scalar('D'), { scalars: { D: Infinity }, vectors: {} }, false); // → false
 */
export function isWritable(expr: Expr, values: Values<number>, worked: boolean): boolean {
  if (worked && isWorked(expr)) return Number.isFinite(evaluate(expr, float64, values));
  switch (expr.op) {
    case 'scalar':
      return Number.isFinite(values.scalars[expr.id]);
    case 'sum':
      return expr.terms.every((term) => isWritable(term.expr, values, worked));
    case 'product':
      return expr.factors.every((factor) => isWritable(factor, values, worked));
    case 'quotient':
      return isWritable(expr.over, values, worked) && isWritable(expr.under, values, worked);
    case 'plus-minus':
      return isWritable(expr.left, values, worked) && isWritable(expr.right, values, worked);
    case 'negative':
    case 'square':
    case 'root':
      return isWritable(expr.of, values, worked);
    // Vectors are input, and input is finite.
    default:
      return true;
  }
}

/** The tree with a new symbol for each part that is printed as one number. */
function workedOut(expr: Expr, values: Values<number>, scalars: Record<string, number>): Expr {
  const of = (e: Expr): Expr => workedOut(e, values, scalars);
  if (isWorked(expr)) {
    const id = `worked ${Object.keys(scalars).length}`;
    scalars[id] = evaluate(expr, float64, values);
    return scalar(id);
  }
  if (expr.op === 'quotient') return { op: 'quotient', over: of(expr.over), under: of(expr.under) };
  if (expr.op === 'plus-minus') {
    return { op: 'plus-minus', left: of(expr.left), right: of(expr.right) };
  }
  return expr;
}

/**
 * The decimal number that is printed for x, exactly.
 *
 * @param x a finite double, of any unit.
 * @param digits significant digits, a whole number from 1 on.
 * @returns in the unit of x.
 * @see NUMERICS.md, section 7
 * @throws RangeError where x is not finite.
 * @example
 * asPrinted(0.1, 6); // → { n: 1n, d: 1n, e: -1 }
 * asPrinted(Infinity, 6); // throws RangeError: no decimal for Infinity
 */
export function asPrinted(x: number, digits: number): Ratio {
  if (!Number.isFinite(x)) throw new RangeError(`no decimal for ${x}`);
  const { mantissa, exponent } = displayParts(x, digits);
  const [whole = '', fraction = ''] = mantissa.replace(MINUS, '').split('.');
  const figures = BigInt(whole + fraction);
  return { n: x < 0 ? -figures : figures, d: 1n, e: (exponent ?? 0) - fraction.length };
}

/** Whether `value`, rounded to so many significant digits, is printed as `result` is. */
function roundsTo(value: Ratio, result: number, digits: number): boolean {
  if (result === 0) return value.n === 0n;
  if (!Number.isFinite(result)) return false;
  const [low, high] = around(result, digits);
  return isAtMost(low, value) && isAtMost(value, high);
}

/** The same of √`squared`, for a length. */
function rootRoundsTo(squared: Ratio, result: number, digits: number): boolean {
  if (result === 0) return squared.n === 0n;
  if (!(result > 0 && Number.isFinite(result))) return false;
  const [low, high] = around(result, digits);
  return isAtMost(ratios.sqr(low), squared) && isAtMost(squared, ratios.sqr(high));
}

/** The interval of all numbers printed as `result`, half a last digit each way. Not for 0. */
function around(result: number, digits: number): [low: Ratio, high: Ratio] {
  const printed = asPrinted(result, digits);
  const last = Number(result.toExponential(digits - 1).split('e')[1]) - digits + 1;
  const half = { n: 5n, d: 1n, e: last - 1 };
  return [ratios.sub(printed, half), ratios.add(printed, half)];
}

const isAtMost = (a: Ratio, b: Ratio): boolean => ratios.sign(ratios.sub(a, b)) <= 0;
