import type { EffectId } from '../scene/effects/index.ts';
import type { Scene } from '../scene/types.ts';
import type { RayTree, Tile, TileResult, TraceSettings } from '../tracer/types.ts';

/* Messages between page and trace worker. By `job`, replies to a cancelled job are recognised. */

export type ToTraceWorker =
  /** Prepares a scene, which all later messages are about. */
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
      /** Time of the tile in ms. */
      readonly ms: number;
    }
  | { readonly type: 'tree'; readonly job: number; readonly tree: RayTree }
  | { readonly type: 'failed'; readonly job: number; readonly message: string };
