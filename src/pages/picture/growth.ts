import { quartiles } from '../../lab/stats.ts';
import { LEAST_REPEATS, type Spread } from '../../state/picture/times.ts';
import { type GrowthSeries, growthOf } from '../../tracer/growth.ts';
import { totalOf } from '../../tracer/ledger.ts';
import type { Cost } from '../../tracer/types.ts';
import type { Background } from './trace-queue.ts';
import type { TraceRequest } from './trace-request.ts';

/** What is known of a picture of a series; null while it was not traced. */
interface GrowthPrice {
  readonly x: number;
  readonly work: Cost | null;
  /** ms of all workers, in repeats. */
  readonly time: Spread | null;
}

export interface GrowthState {
  readonly series: readonly (Omit<GrowthSeries, 'points'> & {
    readonly points: readonly GrowthPrice[];
  })[];
  /** 0 while work is counted, then the repeat whose times are taken, of how many. */
  readonly repeat: number;
  readonly repeats: number;
  readonly runs: boolean;
  /** Part that is done, 0 … 1, and estimated ms to the end; NaN before the first picture. */
  readonly share: number;
  readonly msLeft: number;
}

/**
 * Traces the pictures of which the growth of the price is read: once for their work, which also
 * warms up, then by turns for their times.
 */
interface GrowthRun extends Background {
  /** Sets the picture whose growth is measured; null for none. */
  setPicture(request: TraceRequest | null): void;
  /** Pauses the measurement while the shown picture is not finished. */
  setPaused(waits: boolean): void;
  stop(): void;
  again(): void;
  /** Null while nothing was asked for. */
  state(): GrowthState | null;
}

export function createGrowth(): GrowthRun {
  let request: TraceRequest | null = null;
  let series: readonly GrowthSeries[] = [];
  let pictures: readonly GrowthSeries['points'][number][] = [];
  let work: Cost[] = [];
  let times: number[][] = [];
  let done = 0;
  let spent = 0;
  let stopped = false;
  let waits = false;
  let known: GrowthState | null = null;

  const total = (): number => pictures.length * (1 + LEAST_REPEATS);
  const runs = (): boolean => request !== null && !stopped && done < total();

  const begin = (): void => {
    series = request ? growthOf(request.scene, request.settings) : [];
    pictures = series.flatMap(({ points }) => points);
    work = [];
    times = pictures.map(() => []);
    done = 0;
    spent = 0;
    stopped = false;
    known = null;
  };

  const priceAt = (k: number): Pick<GrowthPrice, 'work' | 'time'> => {
    const all = times[k] ?? [];
    const { low, high } = quartiles(all);
    return {
      work: work[k] ?? null,
      time: all.length < LEAST_REPEATS ? null : { low, high },
    };
  };

  const stateNow = (): GrowthState => {
    let k = 0;
    return {
      series: series.map(({ points, ...one }) => ({
        ...one,
        points: points.map(({ x }) => ({ x, ...priceAt(k++) })),
      })),
      repeat: Math.min(LEAST_REPEATS, Math.floor(done / Math.max(1, pictures.length))),
      repeats: LEAST_REPEATS,
      runs: runs(),
      share: done / Math.max(1, total()),
      msLeft: done === 0 ? Number.NaN : (spent / done) * (total() - done),
    };
  };

  return {
    setPicture(next) {
      if (next?.key === request?.key) return;
      request = next;
      begin();
    },
    setPaused(now) {
      waits = now;
    },
    stop() {
      stopped = true;
      known = null;
    },
    again: begin,
    next() {
      const picture = pictures[done % pictures.length];
      if (!request || !picture || waits || !runs()) return null;
      const { scene, settings } = picture;
      return { key: `${request.key} growth ${done}`, scene, settings, atOnce: true };
    },
    onResult(_, { state, ledger, msSpent }) {
      known = null;
      if (state === 'failed') {
        stopped = true;
        return;
      }
      const cost = totalOf(ledger);
      const at = done % pictures.length;
      if (done < pictures.length) work[at] = cost;
      else times[at]?.push(cost.ms);
      spent += msSpent;
      done += 1;
    },
    state() {
      if (!request) return null;
      known ??= stateNow();
      return known;
    },
  };
}
