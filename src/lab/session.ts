import { isFast } from '../math/batch.ts';
import { FAMILIES, type Family } from '../math/families.ts';
import { InvalidInput, METHODS } from '../math/index.ts';
import { quote } from '../math/shapes.ts';
import { batchesOf, type Form, type Sample, tasksOf } from './plan.ts';
import { multipleOf, type Price, priceOf } from './price.ts';
import { qualityOf } from './quality.ts';
import { type Clock, clockStep, measuring, type Plan, type Times } from './run.ts';
import { type Summary, summaryOf } from './summary.ts';

/** What is to be measured. */
export interface MeasureRequest extends Sample {
  readonly family: string;
  readonly plan: Plan;
}

/** What one question costs a method. */
export interface Timing {
  /** Nanoseconds a ray. */
  readonly ns: Price;
  /** As a multiple of the textbook method. */
  readonly times: Price;
}

/** A method on the rays of a request; a time is absent until a round of it is complete. */
export interface MeasuredRow {
  readonly id: string;
  readonly quality: Summary;
  readonly roots?: Timing;
  readonly classes?: Timing;
}

export interface Measured {
  readonly rays: number;
  /** Milliseconds: the smallest difference that the clock shows. */
  readonly clockStep: number;
  /** Rounds that are complete, and how many there will be at most. */
  readonly round: number;
  readonly rounds: number;
  /** 0 … 1 */
  readonly share: number;
  readonly secondsLeft: number;
  /** False for what was cancelled, or is still going on. */
  readonly complete: boolean;
  /** Whether certified's roots were found by WebAssembly. */
  readonly accelerated: boolean;
  readonly rows: readonly MeasuredRow[];
}

export const BASE_METHOD = 'textbook';

/**
 * Measures what was asked for and tells how far it is, sample by sample. Throws InvalidInput for an
 * unknown family.
 */
export function* measureSession(request: MeasureRequest, clock: Clock): Generator<Measured, void> {
  const family = familyOf(request.family);
  const batches = batchesOf(family, request);
  const rays = batches.reduce((sum, batch) => sum + batch.rays.count, 0);
  const qualities = METHODS.map((method) => ({
    id: method.id,
    quality: summaryOf(qualityOf(method, batches), batches),
  }));
  const { plan } = request;
  const step = clockStep(clock);
  const common = { rays, clockStep: step, rounds: plan.rounds, accelerated: isFast() };
  const untimed = { round: 0, share: 0, secondsLeft: Number.NaN, complete: false };
  yield { ...common, ...untimed, rows: qualities };
  const tasks = FORMS.flatMap((form) =>
    tasksOf(METHODS, batches, form).map((task) => ({ ...task, id: `${form} ${task.id}` })),
  );
  const start = clock();
  let last: Measured = { ...common, ...untimed, rows: qualities };
  for (const { round, done, total, times } of measuring(tasks, clock, plan, step)) {
    const rows =
      Math.max(0, round) === last.round
        ? last.rows
        : qualities.map((row) => ({ ...row, ...timingsOf(row.id, times, rays) }));
    const left = ((clock() - start) / done) * (total - done);
    last = {
      ...common,
      round: Math.max(0, round),
      share: done / total,
      secondsLeft: left / 1000,
      complete: false,
      rows,
    };
    yield last;
  }
  yield { ...last, share: 1, secondsLeft: 0, complete: true };
}

const FORMS: readonly Form[] = ['both', 'classes'];

export function familyOf(id: string): Family {
  const found = FAMILIES.find((family) => family.id === id);
  if (!found) throw new InvalidInput(`unknown family ${quote(id)}`);
  return found;
}

function timingsOf(id: string, times: Times, rays: number): Pick<MeasuredRow, 'roots' | 'classes'> {
  const roots = timingOf(times, 'both', id, rays);
  const classes = timingOf(times, 'classes', id, rays);
  return { ...(roots && { roots }), ...(classes && { classes }) };
}

function timingOf(times: Times, form: Form, id: string, rays: number): Timing | null {
  const roundsOf = (method: string): readonly number[] => times.get(`${form} ${method}`) ?? [];
  const scale = 1e6 / rays;
  const base = priceOf(roundsOf(BASE_METHOD), scale);
  const ns = id === BASE_METHOD ? base : priceOf(roundsOf(id), scale);
  return Number.isNaN(ns.value / base.value) ? null : { ns, times: multipleOf(ns, base) };
}
