import { BUSY, rounded } from '../../lab/price.ts';
import { grouped, spreadOfRows } from '../../lab/sentence.ts';
import type { Measured, MeasureRequest } from '../../lab/session.ts';
import type { SweepRequest } from '../../lab/sweep.ts';
import { familyName } from './family-name.ts';

/** One line on how the numbers were measured. */
export function provenanceOf(
  measured: Measured | null,
  request: MeasureRequest,
  sweep: SweepRequest,
): string {
  const { shapes, count, seed, order } = request;
  const isolated = crossOriginIsolated ? 'isolated' : 'not isolated';
  const browser = browserName(navigator.userAgent);
  const device = `${browser}, ${navigator.hardwareConcurrency} cores, ${isolated}`;
  const counted = `${shapes} shapes × ${count} rays “${familyName(request.family)}”, seed ${seed}`;
  const swept = `how hard: ${sweep.shapes} × ${sweep.count} a point`;
  const rays = `verdicts and digits, against exact: ${counted}; ${swept}`;
  if (!measured || measured.round === 0) return `${device}; ${rays}.`;
  const { clockStep, round, timedRays } = measured;
  const spread = spreadOfRows([...measured.columns.simd, ...measured.columns.typescript], 'roots');
  const share = `${Math.round(100 * spread)} %`;
  const longer = `one round in four took at least ${share} longer than the best quarter`;
  const busy = spread > BUSY ? `${longer}: the machine was busy` : longer;
  const met = order === 'sorted' ? 'hits first, then misses' : 'in random order';
  const passes = `up to ${grouped(timedRays)} rays a pass, fewer for dear methods`;
  const times = `times: the lower quartile of ${round} rounds on ${passes}, ${met}; ${busy}`;
  return `${device}; timer step ${stepWords(clockStep)}; ${times}; ${rays}.`;
}

/** A step of the clock in two figures: 5 µs, 1 ms. */
const stepWords = (ms: number): string =>
  ms < 0.9995 ? `${rounded(1000 * ms, 2)} µs` : `${rounded(ms, 2)} ms`;

function browserName(agent: string): string {
  const found = /(Firefox|Edg|OPR|Chrome)\/([\d]+)/.exec(agent) ?? /(Version)\/([\d]+)/.exec(agent);
  const names: Readonly<Record<string, string>> = { Edg: 'Edge', OPR: 'Opera', Version: 'Safari' };
  return found ? `${names[found[1] ?? ''] ?? found[1]} ${found[2]}` : 'unknown browser';
}
