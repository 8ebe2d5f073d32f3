import { isWhole, type MapFrame, newMapFrame, paint } from '../../../lab/atlas/frame.ts';
import { type Probe, probeFor } from '../../../lab/atlas/probe.ts';
import type { MapRequest } from '../../../lab/atlas/request.ts';
import { type MapSummary, summaryOf } from '../../../lab/atlas/summary.ts';
import type { LabReply } from '../../../lab/messages.ts';
import type { LabWorker, Spawn } from '../lab-jobs.ts';

/** A map with the pixels that have been computed. */
export interface MapState {
  readonly request: MapRequest | null;
  /** Null before the first pixel; of the request before until pixels of this one arrive. */
  readonly frame: MapFrame | null;
  /** The request of `frame`, which may be an earlier one. */
  readonly shown: MapRequest | null;
  readonly running: boolean;
  /** Part of the pixels that are there, 0 … 1. */
  readonly share: number;
  /** Null until the map is complete. */
  readonly summary: MapSummary | null;
  readonly probe: Probe | null;
  /** Why it ended early; '' if it did not. */
  readonly failed: string;
}

export const EMPTY_MAP: MapState = {
  request: null,
  frame: null,
  shown: null,
  running: false,
  share: 0,
  summary: null,
  probe: null,
  failed: '',
};

interface MapJobs {
  state(): MapState;
  /** Starts the map, unless it is there or on its way already. */
  show(request: MapRequest): void;
  /** Goes on with a map that was cancelled. */
  again(): void;
  cancel(): void;
  /** Ends the workers, when another page is shown. */
  rest(): void;
}

/** Most workers of one map: more would wait for each other on most devices. */
const MOST_WORKERS = 4;

/** Draws one map after the other with some workers, which stay for the next one. */
export function mapJobs(spawn: Spawn, changed: () => void, cores: number): MapJobs {
  const parts = Math.min(Math.max(1, cores), MOST_WORKERS);
  let workers: LabWorker[] = [];
  let loading: Promise<void> | null = null;
  /** Grows when workers are ended, so that workers still being loaded are ended on arrival. */
  let era = 0;
  let job = 0;
  let next: MapFrame = newMapFrame();
  let state: MapState = EMPTY_MAP;
  const put = (change: Partial<MapState>): void => {
    state = { ...state, ...change };
    changed();
  };

  function fail(reason: string): void {
    stop();
    put({ running: false, failed: reason });
  }

  /** Ends the workers; results of theirs that still arrive are ignored. */
  function stop(): void {
    for (const worker of workers) worker.terminate();
    workers = [];
    loading = null;
    era += 1;
    job += 1;
  }

  function listen(worker: LabWorker): void {
    worker.onmessage = ({ data }) => {
      if (workers.includes(worker)) take(data);
    };
    worker.onerror = (event) => {
      if (workers.includes(worker)) fail(event.message || 'the worker could not be started');
    };
  }

  function take(data: LabReply): void {
    if (data.type === 'failed') {
      fail(data.message);
      return;
    }
    if (data.type === 'probed' && data.job === job) put({ probe: data.probe });
    if (data.type !== 'mapped' || data.job !== job || !state.request) return;
    const { request } = state;
    paint(next, data.part, data.block);
    const share = next.done / next.marks.length;
    if (!isWhole(next)) {
      // A frame is shown once its coarsest pixels are complete; until then the one before stays.
      const isSeen = state.frame === next || !next.block.includes(255);
      put({ share, ...(isSeen && { frame: next, shown: request }) });
      return;
    }
    const summary = summaryOf(request, next);
    put({ share, frame: next, shown: request, running: false, summary });
    workers[0]?.postMessage({ type: 'probe', job, request: probeFor(request, next) });
  }

  async function load(): Promise<void> {
    const own = era;
    const made = await Promise.all(Array.from({ length: parts }, spawn));
    if (own !== era) {
      for (const worker of made) worker.terminate();
      return;
    }
    workers = made;
    loading = null;
    for (const worker of made) listen(worker);
  }

  async function start(request: MapRequest): Promise<void> {
    job += 1;
    const own = job;
    next = newMapFrame();
    put({ request, running: true, share: 0, summary: null, probe: null, failed: '' });
    try {
      if (workers.length === 0) {
        loading ??= load();
        await loading;
      }
      if (own !== job) return;
      workers.forEach((worker, part) => {
        worker.postMessage({ type: 'map', job, request, part, parts: workers.length });
      });
    } catch (error) {
      loading = null;
      if (own === job) fail(error instanceof Error ? error.message : String(error));
    }
  }

  return {
    state: () => state,
    show(request) {
      if (!sameMap(state.request, request)) void start(request);
    },
    again() {
      if (state.request) void start(state.request);
    },
    cancel() {
      stop();
      put({ running: false });
    },
    rest() {
      stop();
      const { running } = state;
      state = { ...state, running: false, ...(running && { request: null }) };
    },
  };
}

/** Whether two requests are equal; −0 and 0 differ, which JSON alone does not show. */
export const sameMap = (a: MapRequest | null, b: MapRequest): boolean =>
  a !== null && textOf(a) === textOf(b);
const textOf = (request: MapRequest): string =>
  JSON.stringify(request, (_, value) => (Object.is(value, -0) ? '-0' : value));
