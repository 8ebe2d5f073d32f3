import type { Vec3 } from './vec3.ts';

/** What the whole line of a ray has in common with a shape, t of any sign. */
export type IntersectionClass = 'two' | 'tangent' | 'one' | 'none' | 'contained';

/**
 * 'undecided' is the answer of a method that cannot tell: an overflow, a NaN, an interval around
 * zero.
 */
export type Verdict = IntersectionClass | 'undecided';

/** Which stage of a method gave the class. */
export type DecidedBy = 'formula' | 'filter' | 'double-double' | 'exact';

/** Of an exact number. */
export type Sign = -1 | 0 | 1;

/**
 * What becomes of a root where a shape has ends: it is a hit, it is cut off, or the line goes
 * through a cap there.
 */
export type Fate = 'hit' | 'cut' | 'cap';

/** A point where the line meets the shape. */
export interface Hit {
  /** In lengths of d. */
  readonly t: number;
  /** E + t d, from the root before it was rounded where the method has it; in units of length. */
  readonly point: Vec3;
  /** The course's normal, not normalised; [0, 0, 0] where it is exactly zero. */
  readonly normal: Vec3;
  /** The normal is exactly zero: a cone's vertex, a cylinder of radius 0, … */
  readonly singular: boolean;
  /** Only where the shape has ends: of a root that is `cut` nothing is there. */
  readonly fate?: Fate;
}

/**
 * A t² + B t + C, in units as in `Coefficients`, and its discriminant, in the square of that unit.
 * The signs are the method's own; null where it cannot tell.
 */
export interface CurvedDetails {
  readonly family: 'curved';
  readonly A: number;
  readonly B: number;
  readonly C: number;
  readonly D: number;
  readonly signs: Readonly<Record<'A' | 'B' | 'C' | 'D', Sign | null>>;
}

/** Where the line meets a figure's plane, inside the figure or not. */
export interface PlaneHit extends Hit {
  /** Which of the figure's conditions hold, in the order of its formula. */
  readonly holds: readonly (boolean | null)[];
  /** Rim and edge are inside; null where the method cannot tell. Always true for a plane. */
  readonly inside: boolean | null;
  /**
   * Euclidean distance from the figure in units of length; 0 inside, Infinity where the method
   * cannot count so far.
   */
  readonly distance: number;
}

/** What decides about a flat shape: t = −N·(E − P) / (N·d), and the figure's conditions there. */
export interface FlatDetails {
  readonly family: 'flat';
  /** N·(E − P) and N·d, in lengths of N times units of length. */
  readonly offset: number;
  readonly rate: number;
  readonly signs: Readonly<Record<'offset' | 'rate', Sign | null>>;
  /** Where the line meets the plane, inside the figure or not; null for a line parallel to it. */
  readonly plane: PlaneHit | null;
  /**
   * For a line that lies in the plane: does it meet the figure? Null otherwise, or where the method
   * cannot tell.
   */
  readonly meetsFigure: boolean | null;
}

/** What `intersect` answers. */
export interface Intersection {
  /** Of the whole line. */
  readonly class: Verdict;
  /** Ascending in t; a tangent has one hit. */
  readonly hits: readonly Hit[];
  /** The `id` of the method. */
  readonly method: string;
  readonly decidedBy: DecidedBy;
  readonly details: CurvedDetails | FlatDetails;
  /**
   * The hit that a ray starting on the shape (`from`) starts at: it is not among `hits`, while
   * `class` is still the whole line's.
   */
  readonly dropped?: Hit;
}

/**
 * Of f(t) = A t² + B t + C, all in the unit of f: lengths squared, for a flat shape lengths of N
 * times units of length.
 */
export interface Coefficients {
  readonly A: number;
  readonly B: number;
  readonly C: number;
}

/** What `solveQuadratic` answers. */
export interface QuadraticAnswer {
  /** As for a line: 'one' where A = 0, 'contained' where all three are 0. */
  readonly class: Verdict;
  /** Ascending, in the unit of B / A; a tangent has one root. */
  readonly roots: readonly number[];
}
