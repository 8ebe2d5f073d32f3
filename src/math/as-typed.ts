import { type TypedNumber, typed } from './arithmetic/typed.ts';
import type { Values } from './formula/evaluate.ts';
import type { Intersection } from './intersection.ts';
import { momentForm } from './methods/forms.ts';
import { stableSolver } from './methods/solvers.ts';
import { intersectValues } from './methods/tree-method.ts';
import type { MethodParts } from './methods/tree-parts.ts';
import type { Ray } from './ray.ts';
import type { Shape } from './shapes/index.ts';

/**
 * By squares alone: in no condition do two roots meet that only differ in sign from each other's
 * squares.
 */
const TYPED_METHOD: MethodParts<TypedNumber> = {
  arithmetic: typed,
  form: momentForm,
  solver: stableSolver,
  decidedBy: 'exact',
  id: 'as-typed',
};

/**
 * What shape and ray have in common when their numbers are taken as typed, `values`, and not as the
 * doubles that store them. The class is exact; it is undecided where roots of different numbers
 * would have to be compared. Roots and points are rounded.
 *
 * @param shape and `ray`: the doubles that store the numbers.
 * @param values the same numbers as typed, by symbol, E and d among the vectors.
 * @see NUMERICS.md, section 1: formulas; section 4: P1 and P4, of the numbers as typed.
 * @example
 * const sphere = { kind: 'sphere', center: [0, 0, 0], radius: 1 } as const;
 * const ray = { origin: [4, 0.1, 0], direction: [-1, 0, 0] } as const;
 * const stored = valuesOf(sphere, ray, exact);
 * intersectTyped(sphere, ray, stored).class; // → 'two'
 */
export const intersectTyped = (shape: Shape, ray: Ray, values: Values<TypedNumber>): Intersection =>
  intersectValues(shape, ray, values, TYPED_METHOD);
