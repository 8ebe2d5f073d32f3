import {
  createTracePool,
  MOST_WORKERS,
  type TraceJob,
  type TraceProgress,
  type WorkerLike,
} from '../../workers/trace-job.ts';
import type { TraceRequest } from './trace-request.ts';

/** Finished pictures that are kept to come back to; each takes up to 16 bytes a pixel. */
const MOST_KEPT = 16;

/**
 * Traces what is wanted, one picture after the other with all workers, so that times can be
 * compared.
 */
export interface TraceQueue {
  /**
   * The pictures that are needed now, the most urgent first. What runs and is not among them ends.
   */
  want(requests: readonly TraceRequest[]): void;
  /** Progress of a picture; null if it was not started. */
  seen(request: TraceRequest): TraceProgress | null;
  /** What is traced at this moment. */
  current(): TraceRequest | null;
  /** Cancels the running trace; it restarts by `again`, or when another picture is wanted. */
  cancel(): void;
  /** Traces these pictures again from the start. */
  again(requests: readonly TraceRequest[]): void;
  /** Stops all tracing until the next call of `want`. */
  rest(): void;
}

/** Pictures that are traced when all that is wanted has been: repeats, more samples. */
export interface Background {
  /** The next one, under a key of its own; null for none. */
  next(): TraceRequest | null;
  /** Whether tracing can end early; `onResult` then gets the unfinished picture. */
  isEnough?(request: TraceRequest, soFar: TraceProgress): boolean;
  /** Takes a finished one, or one that failed. */
  onResult(request: TraceRequest, result: TraceProgress): void;
}

interface TraceQueueTools {
  readonly background?: Background;
  readonly spawn: () => WorkerLike;
  readonly workers: number;
  /** Called when there are new pixels or a new state. */
  readonly changed: () => void;
}

/** Number of workers: the device's cores, within the limits of the pool. */
export const coresOf = ({
  hardwareConcurrency,
}: {
  readonly hardwareConcurrency?: number;
}): number => Math.max(1, Math.min(hardwareConcurrency || 1, MOST_WORKERS));

/** Least ms between two drawings of a picture that is traced: drawing takes time from tracing. */
const MS_A_LOOK = 100;

const isUnderWay = ({ state }: TraceProgress): boolean =>
  state === 'loading' || state === 'tracing';

export function createTraceQueue({
  spawn,
  workers,
  changed,
  background,
}: TraceQueueTools): TraceQueue {
  const seen = new Map<string, TraceProgress>();
  const stopped = new Set<string>();
  let wanted: readonly TraceRequest[] = [];
  let running: {
    readonly request: TraceRequest;
    readonly job: TraceJob;
    readonly later: boolean;
  } | null = null;
  let pool: ReturnType<typeof createTracePool> | null = null;

  const open = (): NonNullable<typeof pool> => {
    pool ??= createTracePool({ spawn, workers, clock: () => performance.now() });
    return pool;
  };

  const isOpen = (request: TraceRequest): boolean => {
    const state = seen.get(request.key)?.state;
    return state !== 'finished' && state !== 'failed' && !stopped.has(request.key);
  };

  const drop = (): void => {
    if (!running) return;
    const { request, job } = running;
    running = null;
    job.cancel();
    if (!stopped.has(request.key)) seen.delete(request.key);
  };

  const go = (): void => {
    const next = wanted.find(isOpen);
    const later = next ? null : background?.next();
    const key = (next ?? later)?.key;
    if (running && running.request.key === key) return;
    drop();
    if (next) start(next);
    else if (later) startLater(later);
  };

  /** Its progress is not shown: drawing would take time from it. */
  const startLater = (request: TraceRequest): void => {
    let over = false;
    const job = open().start(
      request.scene,
      request.settings,
      {
        progress(state) {
          if (over) return;
          if (isUnderWay(state)) {
            if (state.done === 0 || !background?.isEnough?.(request, state)) return;
            over = true;
            job.cancel();
          }
          over = true;
          if (state.state === 'cancelled') return;
          if (running?.request === request) running = null;
          background?.onResult(request, state);
          changed();
        },
      },
      request.atOnce,
    );
    if (!over) running = { request, job, later: true };
  };

  const start = (request: TraceRequest): void => {
    let looked = Number.NEGATIVE_INFINITY;
    const progress = (state: TraceProgress): void => {
      // A job that was replaced may still post a message.
      if (running !== null && running.request !== request) return;
      seen.set(request.key, state);
      if (!isUnderWay(state)) {
        running = null;
        forget();
      } else if (performance.now() - looked < MS_A_LOOK) return;
      looked = performance.now();
      changed();
    };
    const job = open().start(request.scene, request.settings, { progress }, request.atOnce);
    if (isOpen(request)) running = { request, job, later: false };
  };

  /** Drops the oldest pictures that are no longer wanted. */
  const forget = (): void => {
    const idle = [...seen.keys()].filter((key) => !wanted.some((request) => request.key === key));
    for (const key of idle.slice(0, Math.max(0, seen.size - MOST_KEPT))) seen.delete(key);
  };

  return {
    want(requests) {
      const same = requests.map(({ key }) => key).join() === wanted.map(({ key }) => key).join();
      if (!same) stopped.clear();
      wanted = requests;
      go();
    },
    seen: ({ key }) => seen.get(key) ?? null,
    current: () => (running && !running.later ? running.request : null),
    cancel() {
      for (const { key } of wanted.filter(isOpen)) stopped.add(key);
      const job = running?.job;
      running = null;
      job?.cancel();
      changed();
    },
    again(requests) {
      for (const { key } of requests) seen.delete(key);
      stopped.clear();
      drop();
      changed();
    },
    rest() {
      drop();
    },
  };
}
