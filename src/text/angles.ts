import type { Typed, TypedUnary } from './typed.ts';

const OF_ANGLES: readonly string[] = ['sin', 'cos', 'tan'];

/** The argument in degrees of a sine, cosine or tangent; null if it was not typed in degrees. */
export function degreesIn({ name, of }: TypedUnary): Typed | null {
  return OF_ANGLES.includes(name) ? withoutDegrees(of) : null;
}

/** The tree without its unit: -30 for -(30 deg). */
function withoutDegrees(tree: Typed): Typed | null {
  if (tree.op === 'unit') return tree.name === 'deg' ? tree.of : null;
  if (tree.op !== 'unary' || !'+-'.includes(tree.name)) return null;
  const of = withoutDegrees(tree.of);
  return of && { ...tree, of };
}

/** sign · √(over/under); under = 0 is a pole. */
interface SpecialValue {
  readonly sign: 1 | -1;
  readonly over: number;
  readonly under: number;
}

/** 4 sin² of the angles in degrees of the first quadrant whose sine is the root of a fraction. */
const FOUR_SINES: Readonly<Record<number, number>> = { 0: 0, 30: 1, 45: 2, 60: 3, 90: 4 };

/** The exact sine, cosine or tangent at a multiple of 30 or 45 degrees; null at other angles. */
export function atSpecialAngle(name: string, degrees: number): SpecialValue | null {
  const sine = sineAt(degrees);
  const cosine = sineAt(degrees + 90);
  if (!sine || !cosine) return null;
  if (name === 'sin') return sine;
  if (name === 'cos') return cosine;
  const sign = sine.sign === cosine.sign ? 1 : -1;
  return { sign, over: sine.over, under: cosine.over };
}

function sineAt(degrees: number): SpecialValue | null {
  const turned = ((degrees % 360) + 360) % 360;
  const half = turned % 180;
  const over = FOUR_SINES[half > 90 ? 180 - half : half];
  if (over === undefined) return null;
  return { sign: turned >= 180 && over > 0 ? -1 : 1, over, under: 4 };
}

/**
 * A hint that the angle of a sine, cosine or tangent is in radians, as for tan(30). Null if the
 * text has a unit or π (tan(30 deg), tan(0.5 rad), tan(pi/6)), or the angle is 0.
 */
export function angleHint(tree: Typed): string | null {
  if (tree.op === 'number' || tree.op === 'constant') return null;
  if (tree.op === 'binary') return angleHint(tree.left) ?? angleHint(tree.right);
  if (tree.op === 'unary' && OF_ANGLES.includes(tree.name) && !saysUnit(tree.of)) {
    const { name, argument } = tree;
    return `${name} is taken in radians; ${name}(${argument} deg) in degrees`;
  }
  return angleHint(tree.of);
}

/** Whether the tree contains a unit or π, or is 0. */
function saysUnit(tree: Typed): boolean {
  if (tree.op === 'binary') return saysUnit(tree.left) || saysUnit(tree.right);
  if (tree.op === 'number') return Number(tree.text) === 0;
  return tree.op !== 'unary' || saysUnit(tree.of);
}
