import type { EffectId } from '../scene/effects/index.ts';
import type { Scene } from '../scene/types.ts';
import type { Ledger, RayTree, TraceSettings } from '../tracer/types.ts';
import type { FromTraceWorker, ToTraceWorker } from './protocol.ts';

/**
 * What the driver needs of a worker; the browser's own Worker fits, and so does a fake one:
 *
 *   const pool = createTracePool({ spawn: () => new TraceWorker(), workers: 2, clock: () => performance.now() });
 *   const job = pool.start(scene, settings, { progress: (state) => … });
 *   job.cancel();                     // or pool.start(…) again: the old job says nothing more
 *   const tree = await job.record(x, y);
 */
export interface WorkerLike {
  postMessage(message: ToTraceWorker): void;
  addEventListener(
    type: 'message',
    listen: (event: { readonly data: FromTraceWorker }) => void,
  ): void;
  addEventListener(type: 'error', listen: (event: { readonly message?: string }) => void): void;
  terminate(): void;
}

export interface TracePoolOptions {
  readonly spawn: () => WorkerLike;
  /** The device's cores, at most MOST_WORKERS of them. */
  readonly workers: number;
  /** Milliseconds. */
  readonly clock: () => number;
}

export const MOST_WORKERS = 8;

/** The picture so far: coarse blocks are filled, so it can be shown at any time. The arrays are written on as tiles arrive. */
export interface Frame {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
  /** What each pixel's middle camera ray met, and where (NaN: nothing); right for pixels that are traced. */
  readonly surface: Int32Array;
  readonly t: Float64Array;
}

export type TraceState = 'loading' | 'tracing' | 'finished' | 'cancelled' | 'failed';

export interface TraceProgress {
  readonly state: TraceState;
  readonly frame: Frame;
  readonly ledger: Ledger;
  /** Pixels. */
  readonly done: number;
  readonly total: number;
  /** The size of the blocks: 1 when the finest pass runs. */
  readonly step: number;
  /** Since the start, and to the end by what has been measured so far (NaN before the first tile). */
  readonly msSpent: number;
  readonly msLeft: number;
  readonly workers: number;
  /** The bodies that the workers have loaded. */
  readonly effects: readonly EffectId[];
  /** Why it failed; '' otherwise. */
  readonly message: string;
}

export interface TraceJob {
  readonly id: number;
  cancel(): void;
  /** The ray tree of one pixel; rejects if the job is cancelled or replaced before the answer. */
  record(x: number, y: number): Promise<RayTree>;
}

export interface TraceListener {
  /** At every tile, and at the end. */
  progress(state: TraceProgress): void;
}

export interface TracePool {
  /** Starts at once; what ran before is cancelled. */
  start(scene: Scene, settings: TraceSettings, listener: TraceListener): TraceJob;
  /** Ends the workers. */
  dispose(): void;
}
