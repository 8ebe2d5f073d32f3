import type { Dyadic } from './dyadic.ts';

/**
 * (u + v√D)/w, exactly: what a root of a quadratic is, and every point and normal made from one.
 * w ≠ 0 and D ≥ 0; v = 0 makes it rational. Nothing is reduced, so one value has many forms: ask
 * `isZero` and `compare`, never the fields.
 */
export interface Surd {
  readonly u: Dyadic;
  readonly v: Dyadic;
  readonly w: Dyadic;
  readonly D: Dyadic;
}
