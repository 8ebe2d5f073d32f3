import type { Shape } from '../shapes/index.ts';
import { findShape } from '../shapes/lookup.ts';
import type { Planar } from '../shapes/numbers.ts';

export type { Planar } from '../shapes/numbers.ts';

/** The numbers of a flat shape; null for one that has no kernel of this family. */
export function planarOf(shape: Shape): Planar | null {
  const numbers = findShape(shape.kind)?.numbers;
  return numbers?.family === 'planar' ? numbers.read(shape) : null;
}
