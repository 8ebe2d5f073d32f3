import type { Vec3 } from './vec3.ts';

/** R(t) = E + t d. */
export interface Ray {
  /** E, where t = 0; in units of length. */
  readonly origin: Vec3;
  /** d, any non-zero vector: t counts in its lengths. */
  readonly direction: Vec3;
}
