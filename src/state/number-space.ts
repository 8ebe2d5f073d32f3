import type { Expr, Step, Values, VectorExpr } from '../math/formula.ts';
import { AXES, axisIndex } from '../math/shapes.ts';
import { display } from '../text/format.ts';

/** The space for a formula with its numbers put in: how many lines of how many characters. */
export interface NumberSpace {
  readonly line: number;
  readonly lines: number;
  /** Smaller type over the whole width of the panel, broken between pieces if need be. */
  readonly long: boolean;
  /** On the line after the formula. */
  readonly below: boolean;
}

const BEHIND: NumberSpace = { line: 32, lines: 1, long: false, below: false };
const BELOW: NumberSpace = { line: 58, lines: 1, long: false, below: true };
/** Space beside a result of more than `SHORT` characters. */
const NARROW: NumberSpace = { ...BELOW, line: 50 };
const SHORT = 9;
const WIDE: NumberSpace = { line: 78, lines: 1, long: true, below: true };
export const LONG: NumberSpace = { ...WIDE, lines: 2 };
/** Most digits of −B, √D and 2A in the line of t, which has no more than these three numbers. */
const FRACTION_DIGITS = 11;
const HALF = 20;

/** The spaces of a step's line, in the order in which they are tried. */
export function spacesOf({ id, worked, value }: Step): readonly NumberSpace[] {
  if (worked) return [BEHIND];
  const below = display(value ?? 0).length > SHORT ? NARROW : BELOW;
  return id === 'D' ? [BEHIND, below, WIDE, LONG] : [below, WIDE, LONG];
}

/** Whether the line with so many digits has room there. */
export function fitsInto(
  { expr, worked }: Step,
  values: Values<number>,
  digits: number,
  { line, lines }: NumberSpace,
): boolean {
  if (worked) return digits <= FRACTION_DIGITS;
  if (lines === 1) return charactersOf(expr, values, digits) <= line;
  let [used, free] = [0, 0];
  for (const piece of piecesOf(expr, values, digits)) {
    if (piece > line) return false;
    if (piece > free) [used, free] = [used + 1, line];
    free -= piece;
  }
  return used <= lines;
}

/** Whether a condition leaves room for another one beside it. */
export function isHalf(expr: Expr, values: Values<number>): boolean {
  return charactersOf(expr, values, 4) <= HALF;
}

/** Characters of the pieces between which a line may be broken: terms, sides of a dot product. */
function piecesOf(expr: Expr, values: Values<number>, digits: number): number[] {
  if (expr.op === 'sum') {
    return expr.terms.map((term) => charactersOf(term.expr, values, digits) + 3);
  }
  if (expr.op === 'dot') {
    return [expr.left, expr.right].map((side) => vector(side, values, digits) + 3);
  }
  return [charactersOf(expr, values, digits)];
}

/**
 * Estimated width of a typeset line in characters; each negative number counts as in parentheses.
 */
function charactersOf(expr: Expr, values: Values<number>, digits: number): number {
  const of = (e: Expr): number => charactersOf(e, values, digits);
  const total = (all: readonly Expr[]): number => all.reduce((sum, e) => sum + of(e), 0);
  switch (expr.op) {
    case 'number':
      return number(expr.value, digits);
    case 'scalar':
      return number(values.scalars[expr.id] ?? 0, digits);
    case 'component':
      return number(values.vectors[expr.vector]?.[axisIndex(expr.axis)] ?? 0, digits);
    case 'sum':
      return total(expr.terms.map((term) => term.expr)) + 3 * expr.terms.length;
    case 'product':
      return total(expr.factors);
    case 'quotient':
      return Math.max(of(expr.over), of(expr.under));
    case 'plus-minus':
      return of(expr.left) + of(expr.right) + 3;
    case 'negative':
    case 'square':
    case 'root':
      return of(expr.of) + 1;
    case 'dot':
      return vector(expr.left, values, digits) + vector(expr.right, values, digits) + 3;
    case 'norm':
      return vector(expr.of, values, digits) + 2;
  }
}

function number(x: number, digits: number): number {
  return display(x, digits).length + (x < 0 ? 2 : 0);
}

function vector(expr: VectorExpr, values: Values<number>, digits: number): number {
  if (expr.op !== 'vector') {
    const [a, b] = expr.op === 'moved' ? [expr.from, expr.step] : [expr.left, expr.right];
    return vector(a, values, digits) + vector(b, values, digits) + 3;
  }
  const v = values.vectors[expr.id];
  return AXES.reduce((sum, axis) => sum + 2 + number(v?.[axisIndex(axis)] ?? 0, digits), 0);
}
