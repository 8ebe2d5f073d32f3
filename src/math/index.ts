/**
 * The face of the math module: everything outside of src/math that is not a page of ours should
 * need only this.
 */
export { ulpDistance } from './float/ulp.ts';
export { coefficients, intersect } from './intersect.ts';
export type {
  Coefficients,
  DecidedBy,
  Fate,
  Hit,
  Intersection,
  IntersectionClass,
  QuadraticAnswer,
  Verdict,
} from './intersection.ts';
export { InvalidInput } from './invalid-input.ts';
export { METHODS } from './methods/index.ts';
export {
  firstAmong,
  type Prepared,
  type PreparedHit,
  type PrepareOptions,
  prepareWith,
} from './prepare/prepare.ts';
export { createHit, type HitRoom } from './prepare/sharp.ts';
export { type PrepareAnyOptions, prepare } from './prepare.ts';
export type { Ray } from './ray.ts';
export type { Ends } from './shapes/checked.ts';
export { type Circle, circle } from './shapes/circle.ts';
export { type Cone, cone } from './shapes/cone.ts';
export { type Cylinder, cylinder } from './shapes/cylinder.ts';
export { type Hyperboloid, hyperboloid } from './shapes/hyperboloid.ts';
export { SHAPES, type Shape, type Solid } from './shapes/index.ts';
export { type Paraboloid, paraboloid } from './shapes/paraboloid.ts';
export { type Plane, plane } from './shapes/plane.ts';
export { type Sphere, sphere } from './shapes/sphere.ts';
export { type Square, square } from './shapes/square.ts';
export { solveQuadratic } from './solve-quadratic.ts';
export type { Given, Vec3 } from './vec3.ts';
