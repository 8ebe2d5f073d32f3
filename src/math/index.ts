/**
 * The face of the math module: everything outside of src/math that is not a page of ours should
 * need only this.
 */
export { ulpDistance } from './float/ulp.ts';
export { coefficients, intersect, solveQuadratic } from './intersect.ts';
export type {
  Coefficients,
  DecidedBy,
  Hit,
  Intersection,
  IntersectionClass,
  QuadraticAnswer,
  Verdict,
} from './intersection.ts';
export { InvalidInput } from './invalid-input.ts';
export { METHODS } from './methods/index.ts';
export type { Ray } from './ray.ts';
export { SHAPES, type Shape } from './shapes/index.ts';
export type { Given, Vec3 } from './vec3.ts';
