import { BUSY } from '../../lab/price.ts';
import { quartiles, sorted } from '../../lab/stats.ts';
import type { EffectId } from '../../scene/effects/index.ts';
import type { Ledger } from '../../tracer/types.ts';

/** One repeat of a picture by warm workers. */
export interface Repeat {
  readonly ledger: Ledger;
  /** From start to end, in ms. */
  readonly waited: number;
  readonly workers: number;
}

/** Lower and upper quartile of repeats, in ms: other load on the machine only adds. */
export interface Spread {
  readonly low: number;
  readonly high: number;
}

/** Times of a picture in repeats. */
export interface Times {
  /** Of each effect that runs, all workers added up. */
  readonly of: Readonly<Partial<Record<EffectId | 'camera', Spread>>>;
  readonly work: Spread;
  readonly waited: Spread;
  /**
   * Of the repeat whose `waited` is nearest to the lower quartile, in ms: waited = work / workers +
   * rest. The rest is the transfer of scene and tiles, and the wait for the last worker.
   */
  readonly typical: {
    readonly work: number;
    readonly workers: number;
    readonly rest: number;
    readonly waited: number;
  };
  readonly repeats: number;
  /** Of the wait: upper quartile over lower quartile, minus 1. */
  readonly spread: number;
  readonly busy: boolean;
}

/** Fewest repeats from which times are shown. */
export const LEAST_REPEATS = 5;

/** Null for fewer than LEAST_REPEATS. */
export function timesOf(runs: readonly Repeat[]): Times | null {
  if (runs.length < LEAST_REPEATS) return null;
  const spreadOf = (of: (run: Repeat) => number): Spread => {
    const { low, high } = quartiles(runs.map(of));
    return { low, high };
  };
  const waited = spreadOf((run) => run.waited);
  const ids = Object.keys(runs[0]?.ledger.effects ?? {}) as EffectId[];
  const nearest = sorted(runs.map((run) => run.waited)).reduce((best, wait) =>
    Math.abs(wait - waited.low) < Math.abs(best - waited.low) ? wait : best,
  );
  const run = runs.find((one) => one.waited === nearest) as Repeat;
  const work = workOf(run);
  const spread = waited.high / waited.low - 1;
  return {
    of: {
      camera: spreadOf(({ ledger }) => ledger.camera.ms),
      ...Object.fromEntries(
        ids.map((id) => [id, spreadOf(({ ledger }) => ledger.effects[id]?.ms ?? 0)]),
      ),
    },
    work: spreadOf(workOf),
    waited,
    typical: {
      work,
      workers: run.workers,
      rest: run.waited - work / run.workers,
      waited: run.waited,
    },
    repeats: runs.length,
    spread,
    busy: spread > BUSY,
  };
}

/** ms of all workers together. */
const workOf = ({ ledger }: Repeat): number =>
  Object.values(ledger.effects).reduce((sum, { ms }) => sum + ms, ledger.camera.ms);
