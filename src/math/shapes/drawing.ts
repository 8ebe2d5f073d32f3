import type { Vec3 } from '../vec3.ts';

/**
 * The part of the world that a picture shows: a ball, and the heights that unbounded shapes are
 * drawn between.
 */
export interface Stage {
  readonly center: Vec3;
  /** Radius of the ball that the camera frames, in world lengths. */
  readonly radius: number;
  /** Height of the ground grid. */
  readonly ground: number;
  /** Heights between which an unbounded surface is drawn. */
  readonly low: number;
  readonly high: number;
}

/**
 * How a patch ends: at a true edge of the figure, at a cut through a surface that goes on, or in a
 * point.
 */
export type PatchEnd = 'edge' | 'rim' | 'goes-on' | 'point' | 'joins';

/**
 * A piece of a surface as data: u and v run over [0, 1]. The canvas decides how finely to sample
 * it. `closed` says that u = 1 meets u = 0. 'rim' is a cut drawn solid, 'goes-on' one drawn fading
 * and dashed.
 */
export interface Patch {
  at(u: number, v: number): Vec3;
  /** The gradient of the surface there (not normalised; zero at a singular point). */
  normal(u: number, v: number): Vec3;
  readonly closed: boolean;
  /** Values of v at which a thin line v = const is drawn (unit heights, unit radii). */
  readonly rings: readonly number[];
  readonly start: PatchEnd;
  readonly end: PatchEnd;
  /** For a patch that is not closed: how its sides u = 0 and u = 1 end. */
  readonly sides: PatchEnd;
  /** Where along v a bend needs samples close together; 1 for straight profiles. */
  readonly stepsV: number;
}

/**
 * A place of the shape that can be taken hold of to change a parameter. A point goes where it is
 * dragged. A length, or a number that follows from one, is read off how far the place is from
 * `from`: along a direction, or, about an axis, on any radius; the picture takes the one that is
 * seen best.
 */
export type Grip =
  | { readonly type: 'point'; readonly param: string; readonly at: Vec3 }
  | {
      readonly type: 'reach';
      readonly param: string;
      readonly from: Vec3;
      readonly direction: { readonly along: Vec3 } | { readonly about: Vec3 };
      /** A length, not negative. */
      readonly reach: number;
      /** The parameter is a length too, and not a slope or the like. */
      readonly isLength: boolean;
      value(reach: number): number;
    };

/** What a shape asks to have drawn, in world coordinates. */
export interface Drawing extends Figure {
  readonly grips: readonly Grip[];
}

/** The same without what can be taken hold of. */
export interface Figure {
  readonly patches: readonly Patch[];
  /** Straight helper lines, such as the axis. */
  readonly lines: readonly { readonly from: Vec3; readonly to: Vec3 }[];
  /** Named points of the shape: V, C, P. */
  readonly marks: readonly { readonly symbol: string; readonly at: Vec3 }[];
  /**
   * Normal arrows that belong to the shape itself (plane, circle, square), as a direction of any
   * length.
   */
  readonly normals: readonly { readonly at: Vec3; readonly direction: Vec3 }[];
}
