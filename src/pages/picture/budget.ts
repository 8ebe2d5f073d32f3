import { quartiles } from '../../lab/stats.ts';
import { BUDGET, type Budget } from '../../state/picture/budget.ts';
import { LEAST_REPEATS, type Spread } from '../../state/picture/times.ts';
import {
  type Choice,
  type Differences,
  differencesFrom,
  type Outcome,
  searchBudget,
  type Wanted,
} from '../../tracer/budget.ts';
import { totalOf } from '../../tracer/ledger.ts';
import type { TraceSettings } from '../../tracer/types.ts';
import type { TraceProgress } from '../../workers/trace-job.ts';
import type { Background } from './trace-queue.ts';
import type { TraceRequest } from './trace-request.ts';

/** A picture that was traced to see whether it keeps the budget. */
interface Candidate extends Wanted {
  readonly keeps: boolean;
  /** Pixels that were compared with the whole picture: all of them if it keeps the budget. */
  readonly seen: number;
  readonly over: number;
  /** The largest difference in levels, and its pixel; −1 without one. */
  readonly worst: number;
  readonly at: number;
  /** Pixels by CLASSES. */
  readonly counts: readonly number[];
  /** Questions that were asked as far as it was traced, and ms of all workers. */
  readonly questions: number;
  readonly ms: number;
  /** Times in repeats; null before they were made. */
  readonly time: Spread | null;
}

export interface BudgetState {
  readonly budget: Budget;
  readonly candidates: readonly Candidate[];
  /** The picture of which nothing is left out; null before it is traced. */
  readonly whole: Candidate | null;
  /** What is traced now; null while times are taken, and at the end. */
  readonly tracing: Wanted | null;
  /** Part of the repeats that are made, 0 … 1. */
  readonly timed: number;
  readonly runs: boolean;
  /** The cheapest one; null before it is found. The whole picture if none is cheaper. */
  readonly chosen: Candidate | null;
  readonly width: number;
}

/** Looks for the cheapest picture within a budget, one candidate after another. */
interface BudgetSearch extends Background {
  /** Sets the request of the whole picture, and the budget; null for none. */
  setPicture(request: TraceRequest | null, budget: Budget | null): void;
  /** Pauses the search while the shown picture is not finished. */
  setPaused(waits: boolean): void;
  stop(): void;
  again(): void;
  /** Null while nothing is looked for. */
  state(): BudgetState | null;
}

/** Methods that are timed, of those that keep the budget: the quickest at first sight. */
const MOST_TIMED = 3;

const textOf = (settings: TraceSettings): string => JSON.stringify(settings);

export function createBudgetSearch(): BudgetSearch {
  let request: TraceRequest | null = null;
  let budget: Budget | null = null;
  let search: Generator<Wanted, Choice, Outcome> | null = null;
  let wanted: Wanted | null = null;
  let choice: Choice | null = null;
  let film: Float64Array | null = null;
  let differences: Differences | null = null;
  let candidates: Candidate[] = [];
  let timed: readonly Candidate[] = [];
  let times: number[][] = [];
  let made = 0;
  let stopped = false;
  let waits = false;
  let known: BudgetState | null = null;

  const repeats = (): number => timed.length * (1 + LEAST_REPEATS);
  const runs = (): boolean => request !== null && !stopped && (wanted !== null || made < repeats());

  const differencesNow = (): Differences | null =>
    film && budget ? differencesFrom(film, budget) : null;

  const begin = (): void => {
    search = request && budget && searchBudget(request.scene, wholeOf(request));
    choice = null;
    film = null;
    differences = null;
    candidates = [];
    timed = [];
    times = [];
    made = 0;
    stopped = false;
    known = null;
    const first = search?.next();
    wanted = first && !first.done ? first.value : null;
  };

  const wholeOf = ({ settings }: TraceRequest): TraceSettings => ({ ...settings, film: true });

  /** Goes on with what became of the candidate. */
  const advance = (outcome: Outcome): void => {
    const turn = search?.next(outcome);
    if (!turn?.done) {
      wanted = turn?.value ?? null;
      return;
    }
    wanted = null;
    choice = turn.value;
    timed = toTime(choice);
    times = timed.map(() => []);
  };

  const find = (settings: TraceSettings): Candidate | undefined =>
    candidates.find((one) => textOf(one.settings) === textOf(settings));

  /** The whole picture, the choice, and the same by the quickest of the methods that keep it. */
  const toTime = ({ settings, methods }: Choice): readonly Candidate[] => {
    const [whole, own] = [candidates[0], find(settings)];
    const others = methods.flatMap((one) => find(one) ?? []);
    const quickest = others.sort((a, b) => a.ms - b.ms).slice(0, MOST_TIMED);
    return [...(whole ? [whole] : []), ...(own && own !== whole ? [own] : []), ...quickest];
  };

  const judge = (progress: TraceProgress): void => {
    if (!wanted) return;
    const { frame, ledger, state } = progress;
    if (wanted.step === 'whole') {
      film = frame.film;
      differences = differencesNow();
    }
    if (frame.film) differences?.look(frame.film, frame.block);
    const found = differences;
    if (!found) return;
    const { questions, ms } = totalOf(ledger);
    const keeps = state === 'finished' && !found.breaks();
    candidates.push({
      ...wanted,
      ...{ keeps, questions, ms, time: null },
      ...{ seen: found.seen(), over: found.over(), worst: found.worst(), at: found.at() },
      counts: [...found.counts()],
    });
    differences = differencesNow();
    advance({ keeps, ledger, questions });
  };

  const timeOf = (candidate: Candidate): Spread | null => {
    const at = timed.indexOf(candidate);
    const all = times[at] ?? [];
    if (at < 0 || all.length < LEAST_REPEATS) return null;
    const { low, high } = quartiles(all);
    return { low, high };
  };

  /** Effects and bounces are chosen by work; of methods, which do the same work, by time. */
  const chosenNow = (): Candidate | null => {
    const own = choice && find(choice.settings);
    if (!own || !choice) return null;
    const same = [own, ...choice.methods.flatMap((one) => find(one) ?? [])];
    const low = (one: Candidate): number => timeOf(one)?.low ?? Number.POSITIVE_INFINITY;
    return same.reduce((best, one) => (low(one) < low(best) ? one : best), own);
  };

  const stateNow = (of: TraceRequest, within: Budget): BudgetState => {
    const seen = (one: Candidate): Candidate => ({ ...one, time: timeOf(one) });
    const [whole] = candidates;
    const chosen = chosenNow();
    return {
      budget: within,
      candidates: candidates.map(seen),
      whole: whole ? seen(whole) : null,
      tracing: stopped ? null : wanted,
      timed: made / Math.max(1, repeats()),
      runs: runs(),
      chosen: chosen && seen(chosen),
      width: of.settings.width,
    };
  };

  return {
    setPicture(next, within) {
      const same = within && budget && BUDGET.texts(within).join() === BUDGET.texts(budget).join();
      if (next?.key === request?.key && (same || within === budget)) return;
      request = within && next;
      budget = within;
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
      if (!request || waits || !runs()) return null;
      const { scene, key } = request;
      // The key stays the same until the result arrives: `next` is called at each drawing.
      const own = `${key} budget ${candidates.length} ${made}`;
      if (wanted) return { key: own, scene, settings: wanted.settings };
      const candidate = timed[made % timed.length];
      if (!candidate) return null;
      const { film: _, ...settings } = candidate.settings;
      return { key: own, scene, settings, atOnce: true };
    },
    isEnough(_, { frame }) {
      if (!wanted || wanted.step === 'whole' || !frame.film) return false;
      differences?.look(frame.film, frame.block);
      return differences?.breaks() ?? false;
    },
    onResult(_, progress) {
      known = null;
      if (progress.state === 'failed') {
        stopped = true;
        return;
      }
      if (wanted) return judge(progress);
      if (made >= timed.length) times[made % timed.length]?.push(totalOf(progress.ledger).ms);
      made += 1;
    },
    state() {
      if (!request || !budget) return null;
      known ??= stateNow(request, budget);
      return known;
    },
  };
}
