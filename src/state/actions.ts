import type { Shape, Vec3 } from '../math/index.ts';
import type { View } from './camera-view.ts';
import type { Between } from './heights.ts';
import type { Tangent } from './nearest-tangent.ts';
import type { Ask } from './prediction-ask.ts';
import type { AppState, PageId, Settings } from './state.ts';
import type { TypedTexts } from './typed-texts.ts';

/**
 * A new value, or a function that makes it from the value at the moment when the action arrives.
 * An edit that keeps a part of the value has to be a function: the page may have been drawn before
 * that part was last changed.
 */
export type Edit<T> = T | ((now: T) => T);

export const applied = <T>(edit: Edit<T>, now: T): T =>
  typeof edit === 'function' ? (edit as (now: T) => T)(now) : edit;

export type ParamValue = Vec3 | number | string;
/** Heights that a shape is kept between, and whether discs close it there. */
export interface EndsValue {
  readonly between: Between;
  readonly caps: boolean;
}
/** Texts of a page's settings; null takes a key back to its default. */
export type Changes = Readonly<Record<string, string | null>>;

/** Everything that can happen to the state. A dragged handle and a slider send the same action. */
export type Action =
  | { readonly type: 'shape'; readonly kind: string }
  /** `texts`: what was typed for the value or its components, under 'E.x', 'cone.c'. */
  | { readonly type: 'origin'; readonly value: Edit<Vec3>; readonly texts?: TypedTexts | undefined }
  | {
      readonly type: 'direction';
      readonly value: Edit<Vec3>;
      readonly texts?: TypedTexts | undefined;
    }
  | { readonly type: 'unit'; readonly on: boolean }
  | {
      readonly type: 'param';
      readonly key: string;
      readonly value: Edit<ParamValue>;
      readonly texts?: TypedTexts | undefined;
    }
  /** Null for a shape without ends; an edit is given the shape as well, for where to put them. */
  | {
      readonly type: 'ends';
      readonly value:
        | EndsValue
        | null
        | ((now: EndsValue | null, shape: Shape) => EndsValue | null);
    }
  | { readonly type: 'method'; readonly id: string }
  | { readonly type: 'view'; readonly view: View }
  | { readonly type: 'bead'; readonly t: Edit<number | null> }
  | { readonly type: 'reset'; readonly what: 'E' | 'd' | 'all' | { readonly param: string } }
  | { readonly type: 'page'; readonly page: PageId }
  /** Changes settings of the page that is shown. */
  | { readonly type: 'settings'; readonly values: Changes | ((now: Settings) => Changes) }
  | { readonly type: 'link'; readonly hash: string }
  /** Replaces the whole state: by one from a file, or one made from the present one. */
  | { readonly type: 'open'; readonly state: Edit<AppState> }
  | { readonly type: 'example'; readonly id: string }
  /** The next example, or the one before. */
  | { readonly type: 'browse'; readonly by: 1 | -1 }
  /** How many lines of the result are shown; null for all of them. */
  | { readonly type: 'reveal'; readonly lines: number | null }
  /** Chooses what is to be predicted. */
  | { readonly type: 'ask'; readonly ask: Ask }
  /** Show the answer to the example's question, or hide it. */
  | { readonly type: 'tell'; readonly on: boolean }
  /** The step of the derivation that is shown beside the scene, from 1; null closes it. */
  | { readonly type: 'derive'; readonly step: Edit<number | null> }
  /** Keep the ray and its hits as they are now, to compare with; or drop them. */
  | { readonly type: 'ghost'; readonly on: boolean }
  /** Moves ray and shape to near ones that touch exactly, if `find` gives such. */
  | { readonly type: 'tangent'; readonly find: (now: AppState) => Tangent | null }
  | { readonly type: 'say'; readonly problems: readonly string[] }
  | { readonly type: 'dismiss' }
  | { readonly type: 'undo' }
  | { readonly type: 'redo' };

export type Dispatch = (action: Action) => void;
