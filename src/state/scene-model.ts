import type { Drawing, Patch, Stage } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';
import type { View } from './camera-view.ts';
import type { Handle } from './handles.ts';

/**
 * How a stretch of the ray is drawn: behind E, on the way to a hit, inside, or after the last hit.
 */
export type Stretch = 'behind' | 'before' | 'inside' | 'after';

export interface RaySegment {
  readonly from: number;
  readonly to: number;
  readonly stretch: Stretch;
}

/**
 * 'first' is the first visible hit (filled disc), 'other' a later one (ring), 'behind' has t < 0,
 * 'outside' misses a figure in its plane, 'cut' is beyond an end of the shape (these three ×).
 */
export type HitRole = 'first' | 'other' | 'behind' | 'outside' | 'cut';

export interface HitMark {
  /** Subscript of t, P and N: 1 or 2. */
  readonly index: number;
  /** In place of t, for a root of a second surface. */
  readonly letter?: 's';
  /** What stands beside it in place of its t: of a cap, or of a root that is cut off. */
  readonly words?: string;
  readonly role: HitRole;
  readonly t: number;
  readonly point: Vec3;
  /** Null where the course's normal is exactly zero (a vertex), or for a point that is no hit. */
  readonly normal: Vec3 | null;
  /** How long its arrow is, in world lengths; absent for the length that shows a direction. */
  readonly normalLength?: number;
  /** False when the point lies outside the drawn part of the world. */
  readonly drawn: boolean;
}

/** A line or a closed polygon, in world coordinates; dotted where it is a trail of hits. */
export interface FigureLine {
  readonly points: readonly Vec3[];
  readonly closed: boolean;
  readonly ink: 'shape' | 'ink3' | 'hit' | 'normal' | 'level';
}

/** An arrow at a hit, named 'n' or '−N' with the hit's index. */
export interface NormalArrow {
  readonly letter: string;
  readonly index: number;
  readonly at: Vec3;
  readonly direction: Vec3;
  /** In world lengths; null for the length that shows a direction. */
  readonly length: number | null;
}

export interface GhostModel {
  /** Word that labels it in the scene. */
  readonly title: string;
  readonly origin: Vec3;
  readonly direction: Vec3;
  /** The interval of its t that is drawn. */
  readonly from: number;
  readonly to: number;
  readonly hits: readonly Vec3[];
  /** The point beside which its word is written; null for its E. */
  readonly beside: Vec3 | null;
}

/** A prediction of where the first hit is: a place on the ray. */
export interface MarkModel {
  /** What stands beside it. */
  readonly title: string;
  /** It can still be put elsewhere. */
  readonly isOpen: boolean;
  /** From the mark to the hit, in t, once that is known; null where nothing is hit. */
  readonly gap: { readonly from: number; readonly to: number; readonly text: string } | null;
}

/**
 * Everything that the 3D view shows, in world coordinates. `drawing` and `stage` keep their
 * identity while they do not change.
 */
export interface SceneModel {
  readonly shapeTitle: string;
  readonly stage: Stage;
  readonly drawing: Drawing;
  readonly ray: {
    readonly origin: Vec3;
    readonly direction: Vec3;
    /** Clipped to the stage, ascending, without gaps; empty when the ray passes the stage by. */
    readonly segments: readonly RaySegment[];
    /** Marks on the ray at whole multiples of a round step in t. */
    readonly ticks: readonly number[];
    readonly originDrawn: boolean;
  };
  readonly hits: readonly HitMark[];
  /** Points that the camera has in the frame beside E, hits and the shape's own. */
  readonly framed?: readonly Vec3[];
  /** A ray that was kept to compare with, and where it hit; drawn faintly. */
  readonly ghost: GhostModel | null;
  /** What a step of the derivation draws into the scene, and where the hits of a slider were. */
  readonly figures?: readonly FigureLine[];
  /** Level surfaces near a hit: walls without an outline. */
  readonly levels?: readonly Patch[];
  /** Normals beside the course's: of another length, or the other way. */
  readonly arrows?: readonly NormalArrow[];
  readonly bead: { readonly t: number; readonly point: Vec3; readonly drawn: boolean } | null;
  /** The bead is a prediction; absent and null where none was asked for. */
  readonly mark?: MarkModel | null;
  /** What can be dragged. */
  readonly handles: readonly Handle[];
  readonly view: View;
  /** What the picture cannot show, in words: "t₂ lies outside the drawn part". */
  readonly notes: readonly string[];
  /** The whole scene in words, for people who do not see it. */
  readonly description: string;
}
