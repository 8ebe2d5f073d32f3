import type { Typed, TypedUnary } from './typed.ts';

const OF_ANGLES: ReadonlySet<string> = new Set(['sin', 'cos', 'tan']);

/**
 * The angle in degrees of which a sine, cosine or tangent is taken; null where it was not typed as
 * degrees.
 */
export function degreesIn({ name, of }: TypedUnary): Typed | null {
  return OF_ANGLES.has(name) ? withoutDegrees(of) : null;
}

/** -30 for -(30 deg). */
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

/** 4 sin² of the angles of the first quadrant whose sine is a root of a fraction. */
const FOUR_SINES = new Map([
  [0, 0],
  [30, 1],
  [45, 2],
  [60, 3],
  [90, 4],
]);

/** sin, cos or tan at a multiple of 30 or 45 degrees; null elsewhere. */
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
  const over = FOUR_SINES.get(half > 90 ? 180 - half : half);
  if (over === undefined) return null;
  return { sign: turned >= 180 && over > 0 ? -1 : 1, over, under: 4 };
}

/**
 * A word on a sine, cosine or tangent of a bare number: it is taken in radians, and tan(30) may
 * mean degrees. Null where the text says which it is: tan(30 deg), tan(0.5 rad), tan(pi/6), and for
 * an angle of 0.
 */
export function angleHint(tree: Typed): string | null {
  if (tree.op === 'number' || tree.op === 'constant') return null;
  if (tree.op === 'binary') return angleHint(tree.left) ?? angleHint(tree.right);
  if (tree.op === 'unary' && OF_ANGLES.has(tree.name) && !saysUnit(tree.of)) {
    const { name, argument } = tree;
    return `${name} is taken in radians; ${name}(${argument} deg) in degrees`;
  }
  return angleHint(tree.of);
}

/** Whether a unit or π occurs in it, or it is 0. */
function saysUnit(tree: Typed): boolean {
  if (tree.op === 'binary') return saysUnit(tree.left) || saysUnit(tree.right);
  if (tree.op === 'number') return Number(tree.text) === 0;
  return tree.op !== 'unary' || saysUnit(tree.of);
}
