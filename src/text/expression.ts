import { atSpecialAngle, degreesIn } from './angles.ts';
import { binaryOps, unaryOps } from './checked-ops.ts';
import type { ConstantName, Typed, TypedUnary, UnitName } from './typed.ts';

export const CONSTANTS: Readonly<Record<ConstantName, number>> = {
  pi: Math.PI,
  infinity: Number.POSITIVE_INFINITY,
};
export const UNITS: Readonly<Record<UnitName, number>> = { deg: Math.PI / 180, rad: 1 };

/** The value in doubles. Infinite and NaN values are passed on; over- and underflow are refused. */
export function evaluate(tree: Typed): number {
  switch (tree.op) {
    case 'number':
      return Number(tree.text);
    case 'constant':
      return CONSTANTS[tree.name];
    case 'unit':
      return named(binaryOps, '*')(evaluate(tree.of), UNITS[tree.name]);
    case 'unary':
      return atDegrees(tree) ?? named(unaryOps, tree.name)(evaluate(tree.of));
    case 'binary':
      return named(binaryOps, tree.name)(evaluate(tree.left), evaluate(tree.right));
  }
}

/**
 * The exact value at special angles: sin(30 deg) is 0.5, the sine of the double near π/6 is not.
 */
function atDegrees(tree: TypedUnary): number | null {
  const degrees = degreesIn(tree);
  const known = degrees && atSpecialAngle(tree.name, evaluate(degrees));
  return known && known.sign * Math.sqrt(known.over / known.under);
}

function named<F>(table: Readonly<Record<string, F>>, name: string): F {
  const found = table[name];
  if (!found) throw new RangeError(`no operation ${name}`);
  return found;
}
