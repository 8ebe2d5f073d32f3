import type { Shape } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import type { MapFrame } from './frame.ts';
import { markByte, VERDICTS } from './marks.ts';
import { PIXELS, SIDE } from './window.ts';

/** Where the exact sign of a quantity changes from a pixel to the one beside or above it. */
export interface Border {
  /** What is 0 there, as it is written: D = 0. */
  readonly title: string;
  /** Pixels whose neighbour to the right has another sign. */
  readonly right: Int32Array;
  /** Pixels whose neighbour above has another sign. */
  readonly above: Int32Array;
}

/** The sign at a pixel; NaN where there is none, and no border is drawn. */
type SignAt = (pixel: number) => number;

/**
 * The exact borders between classes. Every sign is exact: that of A and of N·d by intervals or
 * whole numbers, and D's, inside and outside, by certified's class, which is the exact one.
 */
export function bordersOf(shape: Shape, frame: MapFrame): readonly Border[] {
  const formula = definitionOf(shape).formula(shape);
  const { marks, truth, leading } = frame;
  const isAsked = (pixel: number): boolean => (marks[pixel] as number) < markByte('nothing');
  const leadingAt: SignAt = (pixel) => (leading[pixel] as number) - 1;
  const verdict = (pixel: number) => VERDICTS[truth[pixel] as number];
  if (formula.family === 'flat') {
    const inside: SignAt = (pixel) =>
      leadingAt(pixel) === 0 ? Number.NaN : verdict(pixel) === 'one' ? 1 : -1;
    return found(isAsked, [
      ['N·d = 0', leadingAt],
      ...(formula.bound ? [['rim', inside] as const] : []),
    ]);
  }
  const discriminant: SignAt = (pixel) => {
    const said = verdict(pixel);
    if (said === 'two') return 1;
    if (said === 'tangent') return 0;
    // Where A is 0, D is B².
    if (leadingAt(pixel) === 0) return said === 'one' ? 1 : 0;
    return -1;
  };
  return found(isAsked, [
    ['D = 0', discriminant],
    ['A = 0', leadingAt],
  ]);
}

function found(
  isAsked: (pixel: number) => boolean,
  quantities: readonly (readonly [title: string, sign: SignAt])[],
): Border[] {
  return quantities.flatMap(([title, sign]) => {
    const right: number[] = [];
    const above: number[] = [];
    const signs = Float64Array.from({ length: PIXELS }, (_, pixel) =>
      isAsked(pixel) ? sign(pixel) : Number.NaN,
    );
    const differ = (a: number, b: number): boolean => {
      const [one, other] = [signs[a] as number, signs[b] as number];
      return one !== other && !Number.isNaN(one) && !Number.isNaN(other);
    };
    for (let pixel = 0; pixel < PIXELS; pixel++) {
      if (pixel % SIDE < SIDE - 1 && differ(pixel, pixel + 1)) right.push(pixel);
      if (pixel + SIDE < PIXELS && differ(pixel, pixel + SIDE)) above.push(pixel);
    }
    const all = { title, right: Int32Array.from(right), above: Int32Array.from(above) };
    return right.length + above.length > 0 ? [all] : [];
  });
}

/**
 * For each pixel the number of steps, also diagonal ones, to the nearest pixel beside the border.
 */
export function distancesFrom({ right, above }: Border): Int16Array {
  const steps = new Int16Array(PIXELS).fill(-1);
  let edge: number[] = [];
  const reach = (pixel: number, at: number, into: number[]): void => {
    if (steps[pixel] !== -1) return;
    steps[pixel] = at;
    into.push(pixel);
  };
  for (const pixel of right) {
    reach(pixel, 0, edge);
    reach(pixel + 1, 0, edge);
  }
  for (const pixel of above) {
    reach(pixel, 0, edge);
    reach(pixel + SIDE, 0, edge);
  }
  for (let at = 1; edge.length > 0; at++) {
    const next: number[] = [];
    for (const pixel of edge) {
      const column = pixel % SIDE;
      const row = (pixel - column) / SIDE;
      for (let y = Math.max(0, row - 1); y <= Math.min(SIDE - 1, row + 1); y++) {
        for (let x = Math.max(0, column - 1); x <= Math.min(SIDE - 1, column + 1); x++) {
          reach(y * SIDE + x, at, next);
        }
      }
    }
    edge = next;
  }
  return steps;
}
