import type { Vec3 } from './vec3.ts';

/** R(t) = E + t d: `origin` is E, `direction` is d, any non-zero vector; t counts in lengths of d. */
export interface Ray {
  readonly origin: Vec3;
  readonly direction: Vec3;
}
