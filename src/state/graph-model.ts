import type { HitRole, MarkModel } from './scene-model.ts';
import type { PlacedStretch } from './stretches.ts';

/** The graph of f on the ray's own t scale. */
export interface GraphModel {
  /** Coefficients of f(t) = A t² + B t + C as doubles (A = 0 for a line). */
  readonly A: number;
  readonly B: number;
  readonly C: number;
  /** The interval of t that is shown. */
  readonly from: number;
  readonly to: number;
  /** The interval of f(t) that is shown. */
  readonly low: number;
  readonly high: number;
  readonly roots: readonly {
    readonly index: number;
    readonly t: number;
    readonly role: HitRole;
    readonly double: boolean;
  }[];
  /** Where the ray goes through a cap, and f there. */
  readonly caps: readonly {
    readonly end: 'low' | 'high';
    readonly t: number;
    readonly f: number;
    readonly role: HitRole;
  }[];
  readonly stretches: readonly PlacedStretch[];
  /** t, f(t) and R(t) of the bead. */
  readonly bead: {
    readonly t: number;
    readonly f: number;
    readonly point: readonly [number, number, number];
  };
  /** The vertex of f, and the distance of the roots from it in t (NaN without roots). */
  readonly square?: { readonly t: number; readonly f: number; readonly half: number };
  /** Coefficients of f for the ghost, and its roots; null without one. */
  readonly ghost: {
    readonly A: number;
    readonly B: number;
    readonly C: number;
    readonly roots: readonly number[];
  } | null;
  /** Where the first hit was expected, at the bead; absent and null where that is not asked. */
  readonly mark?: MarkModel | null;
  /**
   * For a number that played: the roots at its other values, and f where the class changes. `above`
   * is the value minus the present one, in parts of the whole sweep.
   */
  readonly trail?: {
    readonly roots: readonly { readonly t: number; readonly above: number }[];
    readonly curves: readonly { readonly A: number; readonly B: number; readonly C: number }[];
  };
  /** f vanishes everywhere: the ray lies in the surface. */
  readonly contained: boolean;
  /** The results are hidden, to be predicted: nothing is shown but the ray's t with the mark. */
  readonly concealed: boolean;
  /** What cannot be shown at this scale, in words; null when all is shown. */
  readonly note: string | null;
  /** The graph in words. */
  readonly description: string;
}
