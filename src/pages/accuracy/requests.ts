import { BUSY, rounded } from '../../lab/price.ts';
import { spreadOfRows } from '../../lab/sentence.ts';
import type { Measured, MeasureRequest } from '../../lab/session.ts';
import type { SweepRequest } from '../../lab/sweep.ts';
import type { AccuracySettings } from '../../state/accuracy/settings.ts';
import { familyName } from './plot-headings.ts';

/**
 * Enough rays for the share of 9 in 10 to mean something, and few enough for the exact method to
 * pass them in 10 ms.
 */
const SHAPES = 6;
const COUNT = 512;
/**
 * The best quarter of the rounds within 2 % of the best: later ones would hardly change a figure
 * that is shown.
 */
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

/** Where the numbers come from, in a line. */
export function provenanceOf(
  measured: Measured | null,
  request: MeasureRequest,
  sweep: SweepRequest,
): string {
  const device = `${browserName(navigator.userAgent)}, ${navigator.hardwareConcurrency} cores, ${crossOriginIsolated ? 'isolated' : 'not isolated'}`;
  const title = familyName(request.family);
  const rays = `times of ${request.shapes} shapes × ${request.count} rays “${title}”, seed ${request.seed}; how hard: ${sweep.shapes} × ${sweep.count} a point`;
  if (!measured || measured.round === 0)
    return `${device}; ${rays}. Digits are counted against exact on every ray.`;
  const spread = spreadOfRows(measured.rows, 'roots');
  const busy = `times of the best round; one in four took at least ${Math.round(100 * spread)} % longer${spread > BUSY ? ': the machine was busy' : ''}`;
  const step = `timer step ${stepWords(measured.clockStep)}`;
  const roots = `certified’s roots by ${measured.accelerated ? 'WebAssembly' : 'script alone'}`;
  return `${device}; ${step}; ${measured.round} rounds, ${rays}; ${roots}; ${busy}. Digits are counted against exact on every ray.`;
}

/** 5 µs, 1 ms: a step of a clock has no more than two figures worth telling. */
const stepWords = (ms: number): string =>
  ms < 0.9995 ? `${rounded(1000 * ms, 2)} µs` : `${rounded(ms, 2)} ms`;

function browserName(agent: string): string {
  const found = /(Firefox|Edg|OPR|Chrome)\/([\d]+)/.exec(agent) ?? /(Version)\/([\d]+)/.exec(agent);
  const names: Readonly<Record<string, string>> = { Edg: 'Edge', OPR: 'Opera', Version: 'Safari' };
  return found ? `${names[found[1] ?? ''] ?? found[1]} ${found[2]}` : 'unknown browser';
}
