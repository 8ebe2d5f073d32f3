import { type Repeat, type Times, timesOf } from '../../state/picture/times.ts';
import type { TraceProgress } from '../../workers/trace-job.ts';
import type { Background } from './trace-queue.ts';
import type { TraceRequest } from './trace-request.ts';

/** Repeats that count, and one before them that only warms up. */
const REPEATS = 7;

/** Measures the times of pictures in turn, so that other load on the machine affects all alike. */
interface Repeats extends Background {
  /** Measures these pictures anew. */
  start(requests: readonly TraceRequest[]): void;
  stop(): void;
  /** Whether it measures this picture, or nothing. */
  isOf(request: TraceRequest): boolean;
  /** Null before enough repeats of the picture. */
  times(request: TraceRequest): Times | null;
  /** How far it is; null while nothing is measured. */
  progress(): RepeatProgress | null;
}

export interface RepeatProgress {
  /** Repeat of all pictures, from 0 (which does not count). */
  readonly repeat: number;
  readonly repeats: number;
  /** Estimated ms to the end; NaN before the first picture. */
  readonly msLeft: number;
}

export function createRepeats(): Repeats {
  const runs = new Map<string, Repeat[]>();
  let measured: readonly TraceRequest[] = [];
  let done = 0;
  let spent = 0;

  const total = (): number => measured.length * (REPEATS + 1);
  const at = (): TraceRequest | undefined => measured[done % measured.length];
  const known = new WeakMap<Repeat[], Times | null>();

  const stop = (): void => {
    measured = [];
  };

  return {
    start(requests) {
      measured = requests;
      done = 0;
      spent = 0;
      for (const { key } of requests) runs.delete(key);
    },
    stop,
    isOf: ({ key }) => measured.length === 0 || measured[0]?.key === key,
    next() {
      const request = at();
      if (!request) return null;
      return { ...request, key: `${request.key} ${done}` };
    },
    onResult(_, { state, ledger, msSpent, workers }: TraceProgress) {
      const request = at();
      if (!request) return;
      if (state === 'failed') return stop();
      spent += msSpent;
      if (done >= measured.length) {
        const all = [...(runs.get(request.key) ?? []), { ledger, waited: msSpent, workers }];
        runs.set(request.key, all);
      }
      done += 1;
      if (done >= total()) stop();
    },
    times({ key }) {
      const all = runs.get(key);
      if (!all || measured.some((request) => request.key === key)) return null;
      const found = known.get(all) ?? timesOf(all);
      known.set(all, found);
      return found;
    },
    progress() {
      if (measured.length === 0) return null;
      const msLeft = done === 0 ? Number.NaN : (spent / done) * (total() - done);
      return { repeat: Math.floor(done / measured.length), repeats: REPEATS, msLeft };
    },
  };
}
