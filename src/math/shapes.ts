/** Door: the registry of shapes and methods as pages need it, vectors, and refusals. */

export { alongRay } from './along.ts';
export { intersectTyped } from './as-typed.ts';
export { borderConditions, type Span, spanInFigure } from './figure.ts';
export { DEFAULT_METHOD, findMethod, intersectWhole } from './find-method.ts';
export { stepped } from './float/stepped.ts';
export { nextDown, nextUp } from './float/ulp.ts';
export type { CurvedDetails, FlatDetails, PlaneHit, Sign } from './intersection.ts';
export { quote, refused } from './invalid-input.ts';
export type { Method } from './methods/define.ts';
export type { CircleNear, Formula, Naming } from './shapes/define.ts';
export type { ShapeKind } from './shapes/index.ts';
export { checkedShape, definitionOf, findShape, knownAs } from './shapes/lookup.ts';
export {
  type AxisParam,
  checkParam,
  type NumberParam,
  type Param,
  type VectorParam,
} from './shapes/params.ts';
export { short } from './shapes/short.ts';
export { sideOf } from './side.ts';
export { unitVector } from './unit.ts';
export { AXES, type Axis, axisIndex, withComponent } from './vec3.ts';
