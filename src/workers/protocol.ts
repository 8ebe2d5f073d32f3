import type { EffectId } from '../scene/effects/index.ts';
import type { Scene } from '../scene/types.ts';
import type { RayTree, Tile, TileResult, TraceSettings } from '../tracer/types.ts';

/*
 * What page and trace worker say to each other. `job` tells an answer to a question that is no
 * longer asked.
 */

export type ToTraceWorker =
  /** Get ready: everything after is about this scene. */
  | {
      readonly type: 'scene';
      readonly job: number;
      readonly scene: Scene;
      readonly settings: TraceSettings;
    }
  | { readonly type: 'tile'; readonly job: number; readonly tile: Tile }
  | { readonly type: 'record'; readonly job: number; readonly x: number; readonly y: number };

export type FromTraceWorker =
  /** The bodies that were loaded. */
  | { readonly type: 'ready'; readonly job: number; readonly effects: readonly EffectId[] }
  | {
      readonly type: 'tile';
      readonly job: number;
      readonly result: TileResult;
      /** What the whole tile took. */
      readonly ms: number;
    }
  | { readonly type: 'tree'; readonly job: number; readonly tree: RayTree }
  | { readonly type: 'failed'; readonly job: number; readonly message: string };
