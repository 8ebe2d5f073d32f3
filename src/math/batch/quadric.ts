import type { Shape } from '../shapes/index.ts';
import { findShape } from '../shapes/lookup.ts';
import type { Quadric, QuadricNumbers } from '../shapes/numbers.ts';

export type { Quadric } from '../shapes/numbers.ts';

/** How a kind's numbers are read for kernels that are exact in their class and roots, or null. */
export function numbersOf(kind: Shape['kind']): QuadricNumbers<Shape> | null {
  const numbers = findShape(kind)?.numbers;
  return numbers?.family === 'quadric' ? numbers : null;
}

/**
 * The shape's numbers for kernels that are exact in their class and roots; null: it has none.
 *
 * @param shape as for `intersect`, checked before.
 * @example
 * quadricOf({ kind: 'paraboloid', vertex: [0, 0, 0], width: 2 }); // → null
 * quadricOf({ kind: 'cylinder', center: [1, 0, 0], radius: 2 })?.r; // → 2
 */
export function quadricOf(shape: Shape): Quadric | null {
  return numbersOf(shape.kind)?.read(shape) ?? null;
}
