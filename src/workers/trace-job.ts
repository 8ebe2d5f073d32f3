import type { EffectId } from '../scene/effects/index.ts';
import type { Scene } from '../scene/types.ts';
import { addLedgers, EMPTY_LEDGER } from '../tracer/ledger.ts';
import type { Ledger, Progress, RayTree, TraceSettings } from '../tracer/types.ts';
import { type Frame, newFrame, paintTile } from './frame.ts';
import type { FromTraceWorker, ToTraceWorker } from './protocol.ts';
import { createTiles, STEPS } from './tiles.ts';

/**
 * What the driver needs of a worker; the browser's own Worker fits, and so does a fake one:
 *
 *   const clock = () => performance.now();
 *   const pool = createTracePool({ spawn: () => new TraceWorker(), workers: 2, clock });
 *   const job = pool.start(scene, settings, { progress: (state) => … });
 *   job.cancel();                     // or pool.start(…) again: the old job reports nothing more
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

interface TracePoolOptions {
  readonly spawn: () => WorkerLike;
  /** Number of workers: the device's cores, MOST_WORKERS at most. */
  readonly workers: number;
  /** Time in ms. */
  readonly clock: () => number;
}

export const MOST_WORKERS = 8;

/** For the views that show it. */
export type { Frame } from './frame.ts';

export interface TraceProgress extends Progress {
  readonly frame: Frame;
  readonly ledger: Ledger;
  /** Effects whose bodies the workers have loaded. */
  readonly effects: readonly EffectId[];
}

export interface TraceJob {
  readonly id: number;
  cancel(): void;
  /** The ray tree of one pixel; rejects if the job is cancelled or replaced before the answer. */
  record(x: number, y: number): Promise<RayTree>;
}

interface TraceListener {
  /** Called at every tile, and at the end. */
  progress(state: TraceProgress): void;
}

export interface TracePool {
  /** Starts a job, and cancels the one before. `atOnce`: without coarse passes before. */
  start(scene: Scene, settings: TraceSettings, listener: TraceListener, atOnce?: boolean): TraceJob;
  /** Ends the workers. */
  dispose(): void;
}

/** A worker of the pool with its state. */
interface Member {
  readonly worker: WorkerLike;
  /** Whether it has loaded this job's scene. */
  ready: boolean;
  /** Tiles of this job that it has been given and has not returned. */
  tiles: number;
  /** Whether it has sent a message; before its first one it may take long to load. */
  hasReplied: boolean;
  /** When it last sent a message, or was given a tile while it was idle, in ms of the clock. */
  lastHeard: number;
}

/** Tiles given to a worker at a time: one to trace and one waiting. */
const TILES_A_WORKER = 2;

/** A worker silent for more ms when a job ends is replaced, since it would delay the next job. */
const LONGEST_SILENCE = 250;

interface Run {
  readonly id: number;
  readonly listener: TraceListener;
  readonly frame: Frame;
  readonly tiles: ReturnType<typeof createTiles>;
  readonly started: number;
  ledger: Ledger;
  done: number;
  effects: readonly EffectId[];
  state: Progress['state'];
  message: string;
  readonly questions: Question[];
}

interface Question {
  readonly x: number;
  readonly y: number;
  readonly answer: (tree: RayTree) => void;
  readonly refuse: (why: Error) => void;
}

export function createTracePool({ spawn, workers, clock }: TracePoolOptions): TracePool {
  let members: Member[] = [];
  let run: Run | undefined;
  let jobs = 0;

  function newMember(): Member {
    const member: Member = {
      worker: spawn(),
      ready: true,
      tiles: 0,
      hasReplied: false,
      lastHeard: clock(),
    };
    member.worker.addEventListener('message', ({ data }) => receive(member, data));
    member.worker.addEventListener('error', ({ message }) => {
      fail(message || 'a worker could not be started');
    });
    return member;
  }

  /** Fills the pool; terminates workers that are still busy with an old job. */
  function refill(): void {
    const wanted = Math.min(Math.max(1, Math.floor(workers)), MOST_WORKERS);
    const kept = members.filter(
      (member) =>
        !owes(member) || !member.hasReplied || clock() - member.lastHeard < LONGEST_SILENCE,
    );
    for (const member of members) if (!kept.includes(member)) member.worker.terminate();
    members = kept;
    while (members.length < wanted) members.push(newMember());
  }

  const owes = ({ ready, tiles }: Member): boolean => !ready || tiles > 0;
  const runs = ({ state }: Run): boolean => state === 'loading' || state === 'tracing';

  function receive(member: Member, data: FromTraceWorker): void {
    member.lastHeard = clock();
    member.hasReplied = true;
    if (!run || data.job !== run.id) return;
    if (data.type === 'tree') settle(run, data.tree);
    else if (data.type === 'failed') fail(data.message);
    else if (data.type === 'ready') begin(run, member, data.effects);
    else take(run, member, data);
  }

  function begin(current: Run, member: Member, effects: readonly EffectId[]): void {
    member.ready = true;
    current.effects = effects;
    if (!runs(current)) return;
    current.state = 'tracing';
    report(current);
    feed(current, member);
  }

  function take(
    current: Run,
    member: Member,
    { result, ms }: Extract<FromTraceWorker, { readonly type: 'tile' }>,
  ): void {
    member.tiles -= 1;
    if (!runs(current)) return;
    const pixels = result.surface.length;
    current.ledger = addLedgers(current.ledger, result.ledger);
    current.done += pixels;
    current.tiles.took(pixels, ms);
    paintTile(current.frame, result);
    if (current.done === current.tiles.total) current.state = 'finished';
    else feed(current, member);
    report(current);
  }

  function feed({ id, tiles }: Run, member: Member): void {
    while (member.ready && member.tiles < TILES_A_WORKER) {
      const tile = tiles.next();
      if (!tile) return;
      if (member.tiles === 0) member.lastHeard = clock();
      member.tiles += 1;
      member.worker.postMessage({ type: 'tile', job: id, tile });
    }
  }

  function report({ listener, frame, ledger, done, tiles, started, effects, state, message }: Run) {
    const msSpent = clock() - started;
    listener.progress({
      state,
      frame,
      ledger,
      done,
      total: tiles.total,
      step: tiles.step(),
      msSpent,
      msLeft: done === 0 ? Number.NaN : (msSpent * (tiles.total - done)) / done,
      workers: members.length,
      effects,
      message,
    });
  }

  function settle({ questions }: Run, tree: RayTree): void {
    const at = questions.findIndex(({ x, y }) => x === tree.x && y === tree.y);
    const [question] = at < 0 ? [] : questions.splice(at, 1);
    question?.answer(tree);
  }

  function end(state: Progress['state'], message: string): void {
    if (!run) return;
    for (const { refuse } of run.questions.splice(0)) refuse(new Error(message || 'cancelled'));
    if (!runs(run)) return;
    run.state = state;
    run.message = message;
    report(run);
  }

  /** Ends the job and its workers; the next job starts new ones. */
  function fail(message: string): void {
    close();
    end('failed', message);
  }

  function close(): void {
    for (const { worker } of members) worker.terminate();
    members = [];
  }

  return {
    start(scene, settings, listener, atOnce = false) {
      end('cancelled', '');
      refill();
      jobs += 1;
      const id = jobs;
      const started: Run = {
        id,
        listener,
        frame: newFrame(
          settings.width,
          settings.height,
          settings.film === true || settings.part !== undefined,
        ),
        tiles: createTiles(
          settings.width,
          settings.height,
          members.length,
          atOnce ? [1] : STEPS,
          settings.part,
        ),
        started: clock(),
        ledger: EMPTY_LEDGER,
        done: 0,
        effects: [],
        state: 'loading',
        message: '',
        questions: [],
      };
      run = started;
      for (const member of members) {
        if (!owes(member)) member.lastHeard = clock();
        member.ready = false;
        member.tiles = 0;
        member.worker.postMessage({ type: 'scene', job: id, scene, settings });
      }
      report(started);
      return {
        id,
        cancel() {
          if (run?.id === id) end('cancelled', '');
        },
        record(x, y) {
          const [member] = members;
          if (run?.id !== id || !member) return Promise.reject(new Error('cancelled'));
          return new Promise((answer, refuse) => {
            started.questions.push({ x, y, answer, refuse });
            member.worker.postMessage({ type: 'record', job: id, x, y });
          });
        },
      };
    },
    dispose() {
      end('cancelled', '');
      close();
      run = undefined;
    },
  };
}
