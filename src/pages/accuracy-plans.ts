import type { Measured, MeasureRequest } from '../lab/session.ts';
import { relativeSpread } from '../lab/stats.ts';
import type { SweepRequest } from '../lab/sweep.ts';
import { findFamily } from '../math/families.ts';
import type { AccuracySettings } from '../state/accuracy/settings.ts';
import { display } from '../text/format.ts';

/** Enough rays for the share of 9 in 10 to mean something, and few enough for the exact rung to pass them in 10 ms. */
const SHAPES = 6;
const COUNT = 512;
/** Quartiles within 2 % of the median: no later round would change a figure that is shown. */
const SETTLES = { rounds: 7, spread: 0.02 };

export const measureRequest = ({ family, dial, seed }: AccuracySettings): MeasureRequest => ({
  family,
  seed,
  shapes: SHAPES,
  count: COUNT,
  difficulty: dial ?? undefined,
  plan: { rounds: 15, least: 10, steps: 100, warmUp: 3, settles: SETTLES },
});

const SWEEP_COUNT = 128;
/** Every whole power of ten, for the usual dial from 0 to 12. */
const SWEEP_POINTS = 13;

export const sweepRequest = ({ hard, seed }: AccuracySettings): SweepRequest => ({
  family: hard,
  seed,
  shapes: SHAPES,
  count: SWEEP_COUNT,
  points: SWEEP_POINTS,
});

/** Whether what was measured is what is asked for now. */
export const sameRays = (a: MeasureRequest | null, b: MeasureRequest): boolean =>
  a !== null && a.family === b.family && a.seed === b.seed && a.difficulty === b.difficulty;

/** Above this the middle half of the rounds differ so much that something else was running. */
const BUSY = 0.1;

/** Where the numbers come from, in a line. */
export function provenanceOf(
  measured: Measured | null,
  request: MeasureRequest,
  sweep: SweepRequest,
): string {
  const device = `${browserName(navigator.userAgent)}, ${navigator.hardwareConcurrency} cores, ${crossOriginIsolated ? 'isolated' : 'not isolated'}`;
  const title = findFamily(request.family)?.title ?? request.family;
  const rays = `times of ${request.shapes} shapes × ${request.count} rays “${title}”, seed ${request.seed}; how hard: ${sweep.shapes} × ${sweep.count} a point`;
  if (!measured || measured.round === 0)
    return `${device}; ${rays}. Digits are counted against exact on every ray.`;
  const spread = Math.max(
    ...measured.rows.flatMap(({ roots }) => (roots ? [relativeSpread(roots.ns)] : [])),
  );
  const busy = `quartiles up to ${Math.round(100 * spread)} % apart${spread > BUSY ? ': the machine looked busy' : ''}`;
  const step = `timer step ${display(1000 * measured.clockStep, 3)} µs`;
  const roots = `certified’s roots by ${measured.accelerated ? 'WebAssembly' : 'script alone'}`;
  return `${device}; ${step}; ${measured.round} rounds, ${rays}; ${roots}; ${busy}. Digits are counted against exact on every ray.`;
}

function browserName(agent: string): string {
  const found = /(Firefox|Edg|OPR|Chrome)\/([\d]+)/.exec(agent) ?? /(Version)\/([\d]+)/.exec(agent);
  const names: Readonly<Record<string, string>> = { Edg: 'Edge', OPR: 'Opera', Version: 'Safari' };
  return found ? `${names[found[1] ?? ''] ?? found[1]} ${found[2]}` : 'unknown browser';
}
