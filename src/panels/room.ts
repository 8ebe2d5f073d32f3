import type { Values } from '../math/formula/evaluate.ts';
import type { Expr, VectorExpr } from '../math/formula/expr.ts';
import { AXES, axisIndex } from '../math/vec3.ts';
import { display } from '../text/format.ts';

/** Characters with numbers put in that fit: under the symbols, behind them in the same line, behind them in half a line. */
const ROOM = { below: 58, behind: 32, half: 20 };

/** How many digits a line can have without being broken, and whether it has to be broken even with the fewest. */
export function digitsFor(
  expr: Expr,
  values: Values<number>,
  place: keyof typeof ROOM,
): { digits: number; long: boolean } {
  for (const digits of [6, 5, 4]) {
    if (charactersOf(expr, values, digits) <= ROOM[place]) return { digits, long: false };
  }
  return { digits: 2, long: true };
}

/** About as many characters as the typeset line has; a pair of parentheses counts for each negative number. */
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
  if (expr.op === 'difference') {
    return vector(expr.left, values, digits) + vector(expr.right, values, digits) + 3;
  }
  const v = values.vectors[expr.id];
  return AXES.reduce((sum, axis) => sum + 2 + number(v?.[axisIndex(axis)] ?? 0, digits), 0);
}
