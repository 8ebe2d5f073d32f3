import { CIRCLE } from './circle.ts';
import { CONE } from './cone.ts';
import { CYLINDER } from './cylinder.ts';
import type { Example } from './define.ts';
import { HYPERBOLOID } from './hyperboloid.ts';
import { PARABOLOID } from './paraboloid.ts';
import { PLANE } from './plane.ts';
import { SPHERE } from './sphere.ts';
import { SQUARE } from './square.ts';

/** In the order of the menu of shapes; next and previous walk through it. */
export const GALLERY: readonly Example[] = [
  ...PLANE,
  ...CYLINDER,
  ...CONE,
  ...HYPERBOLOID,
  ...CIRCLE,
  ...SQUARE,
  ...SPHERE,
  ...PARABOLOID,
];
