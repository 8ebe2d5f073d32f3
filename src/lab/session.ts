import { isFast, type Target } from '../math/batch.ts';
import { FAMILIES, type Family } from '../math/families.ts';
import { InvalidInput, METHODS } from '../math/index.ts';
import { quote } from '../math/shapes.ts';
import { batchesOf, type Form, type Sample } from './plan.ts';
import { multipleOf, type Price, priceOf } from './price.ts';
import { qualityOf } from './quality.ts';
import { type Clock, clockStep, measuring, type Plan, type Times } from './run.ts';
import { type Summary, summaryOf } from './summary.ts';
import {
  type Budget,
  type Order,
  runsIn,
  type TimedTask,
  timedBatches,
  timedTasks,
} from './timed.ts';

/**
 * A measurement: verdicts and digits on the rays of the sample; times on `timed` rays of each
 * shape, of which the sample's are the first.
 */
export interface MeasureRequest extends Sample {
  readonly family: string;
  readonly timed: number;
  readonly order: Order;
  readonly budget: Budget;
  readonly plan: Plan;
}

/** The cost of one question to a method. */
export interface Timing {
  /** Nanoseconds per ray. */
  readonly ns: Price;
  /** As a multiple of the textbook method in the same target. */
  readonly times: Price;
}

/**
 * A method on the rays of a request, in one target; a time is absent until a round of it is
 * complete, and where the method or the textbook has no kernel in the target.
 */
export interface MeasuredRow {
  readonly id: string;
  readonly quality: Summary;
  readonly roots?: Timing;
  readonly classes?: Timing;
}

/** The rows of all methods, by target: verdicts are the same in each, times are not. */
export type Columns = Readonly<Record<Target, readonly MeasuredRow[]>>;

export interface Measured {
  readonly rays: number;
  /** The smallest difference that the clock shows, in ms. */
  readonly clockStep: number;
  /** Rounds that are complete, and how many there will be at most. */
  readonly round: number;
  readonly rounds: number;
  /** Part of the work that is done, 0 … 1. */
  readonly share: number;
  readonly secondsLeft: number;
  /** False while it is running, or if it was cancelled. */
  readonly complete: boolean;
  /** Whether the textbook has a SIMD kernel, with which all others in that target are compared. */
  readonly simd: boolean;
  /** Why it has none, as a sentence; '' if it has. */
  readonly noSimd: string;
  /** Largest number of rays that one run of a task processes. */
  readonly timedRays: number;
  readonly columns: Columns;
}

export const BASE_METHOD = 'textbook';

/**
 * Measures sample by sample and yields what is known so far.
 *
 * @param whyNot why there is no WebAssembly with SIMD; null if there is.
 * @throws InvalidInput for an unknown family.
 */
export function* measureSession(
  request: MeasureRequest,
  clock: Clock,
  whyNot: string | null = null,
): Generator<Measured, void> {
  const family = familyOf(request.family);
  const batches = batchesOf(family, request);
  const rays = batches.reduce((sum, batch) => sum + batch.rays.count, 0);
  const qualities = METHODS.map((method) => ({
    id: method.id,
    quality: summaryOf(qualityOf(method, batches), batches),
  }));
  const { plan } = request;
  const step = clockStep(clock);
  const untimed = { round: 0, share: 0, secondsLeft: Number.NaN, complete: false };

  const columns = { simd: qualities, typescript: qualities };
  const base = METHODS.filter(({ id }) => id === BASE_METHOD);
  const simd = base.every((method) => runsIn('simd', method, batches));
  const noSimd = simd ? '' : noSimdWords(whyNot);
  const common = { rays, clockStep: step, rounds: plan.rounds, simd, noSimd };
  const targets: readonly Target[] = simd ? ['simd', 'typescript'] : ['typescript'];
  yield { ...common, ...untimed, timedRays: 0, columns };
  const timed = timedBatches(family, request, request.timed, request.order);
  const tasks = timedTasks(METHODS, timed, targets, clock, request.budget);
  const timedRays = Math.max(...tasks.map((task) => task.rays));
  const start = clock();
  let last: Measured = { ...common, ...untimed, timedRays, columns };
  for (const { round, done, total, times } of measuring(tasks, clock, plan, step)) {
    const isNew = Math.max(0, round) !== last.round;
    const left = ((clock() - start) / done) * (total - done);
    last = {
      ...last,
      round: Math.max(0, round),
      share: done / total,
      secondsLeft: left / 1000,
      ...(isNew && { columns: columnsOf(qualities, tasks, times) }),
    };
    yield last;
  }
  yield { ...last, share: 1, secondsLeft: 0, complete: true };
}

const noSimdWords = (whyNot: string | null): string =>
  isFast()
    ? 'Not all of these shapes have a SIMD kernel of the textbook formula.'
    : (whyNot ?? 'WebAssembly with SIMD is not in use here.');

export function familyOf(id: string): Family {
  const found = FAMILIES().find((family) => family.id === id);
  if (!found) throw new InvalidInput(`unknown family ${quote(id)}`);
  return found;
}

function columnsOf(
  rows: readonly MeasuredRow[],
  tasks: readonly TimedTask[],
  times: Times,
): Columns {
  const price = (target: Target, form: Form, method: string): Price | null => {
    const task = tasks.find(
      (one) => one.target === target && one.form === form && one.method === method,
    );
    return task ? priceOf(times.get(task.id) ?? [], 1e6 / task.rays) : null;
  };
  const column = (target: Target): readonly MeasuredRow[] => {
    const timing = (form: Form, id: string): Timing | null => {
      const base = price(target, form, BASE_METHOD);
      const ns = id === BASE_METHOD ? base : price(target, form, id);
      if (!ns || !base || Number.isNaN(ns.value / base.value)) return null;
      return { ns, times: multipleOf(ns, base) };
    };
    return rows.map(({ id, quality }) => {
      const roots = timing('both', id);
      const classes = timing('classes', id);
      return { id, quality, ...(roots && { roots }), ...(classes && { classes }) };
    });
  };
  return { simd: column('simd'), typescript: column('typescript') };
}
