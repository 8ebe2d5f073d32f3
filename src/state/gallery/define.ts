import type { IntersectionClass } from '../../math/intersection.ts';

/** A state worth looking at. It is a link like any other, so whatever a preset can show, a person can send. */
export interface Preset {
  readonly id: string;
  readonly title: string;
  /** One sentence: what to look at. */
  readonly look: string;
  readonly link: string;
  /** What exact arithmetic says of it; held to that by a test. */
  readonly class: IntersectionClass;
}
