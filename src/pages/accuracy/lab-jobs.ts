import type { LabReply, LabRequest } from '../../lab/messages.ts';
import type { Measured, MeasureRequest } from '../../lab/session.ts';
import type { SweepPoint, SweepRequest } from '../../lab/sweep.ts';
import { lazy } from '../../ui/lazy.ts';
import { moduleWorker, startWatched } from '../../workers/life.ts';

/** The part of the Worker interface that the page uses. */
export interface LabWorker {
  postMessage(request: LabRequest): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<LabReply>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

export type Spawn = () => Promise<LabWorker>;

/** A job in a worker of its own. Cancelling it keeps its results. */
interface Job<Request, Result> {
  readonly request: Request | null;
  readonly result: Result | null;
  readonly running: boolean;
  /** Why it failed; '' if it did not. */
  readonly failed: string;
  start(request: Request): void;
  cancel(): void;
}

export const measureJob = (spawn: Spawn, changed: () => void): Job<MeasureRequest, Measured> =>
  createJob(
    spawn,
    changed,
    (request: MeasureRequest) => ({ type: 'measure', request }),
    (before, reply) => (reply.type === 'measured' ? reply.measured : before),
  );

export const sweepJob = (
  spawn: Spawn,
  changed: () => void,
): Job<SweepRequest, readonly SweepPoint[]> =>
  createJob(
    spawn,
    changed,
    (request: SweepRequest) => ({ type: 'sweep', request }),
    (before, reply) => (reply.type === 'swept' ? [...(before ?? []), reply.point] : before),
  );

function createJob<Request, Result>(
  spawn: Spawn,
  changed: () => void,
  ask: (request: Request) => LabRequest,
  take: (before: Result | null, reply: LabReply) => Result | null,
): Job<Request, Result> {
  let worker: LabWorker | null = null;
  // A job may be cancelled while its worker is loaded: only the latest start counts.
  let turn = 0;
  const state = {
    request: null as Request | null,
    result: null as Result | null,
    running: false,
    failed: '',
  };

  function stop(): void {
    turn += 1;
    worker?.terminate();
    worker = null;
    state.running = false;
  }

  function fail(reason: string): void {
    stop();
    state.failed = reason;
    changed();
  }

  function listen(next: LabWorker): void {
    next.onmessage = ({ data }) => {
      if (next !== worker) return;
      if (data.type === 'failed') return fail(data.message);
      state.result = take(state.result, data);
      if (data.type === 'done') stop();
      changed();
    };
    next.onerror = (event) => {
      if (next === worker) fail(event.message || 'the worker could not be started');
    };
  }

  async function start(request: Request): Promise<void> {
    stop();
    const own = turn;
    Object.assign(state, { request, result: null, running: true, failed: '' });
    changed();
    try {
      const next = await spawn();
      if (own !== turn) return next.terminate();
      worker = next;
      listen(next);
      next.postMessage(ask(request));
    } catch (error) {
      if (own === turn) fail(error instanceof Error ? error.message : String(error));
    }
  }

  return {
    get request() {
      return state.request;
    },
    get result() {
      return state.result;
    },
    get running() {
      return state.running;
    },
    get failed() {
      return state.failed;
    },
    start: (request) => void start(request),
    cancel() {
      stop();
      changed();
    },
  };
}

/** Starts a worker; the offline file holds its code inline. */
export async function spawnLab(): Promise<LabWorker> {
  if (import.meta.env.MODE === 'single') {
    const { default: Lab } = await lazy(() => import('../../workers/lab.ts?worker&inline'));
    return startWatched((options) => new Lab(options));
  }
  const { default: url } = await lazy(() => import('../../workers/lab.ts?worker&url'));
  return startWatched((options) => moduleWorker(url, options));
}
