import { quantile, sorted } from './stats.ts';

/**
 * Something to be timed. One call processes a whole batch, so that the call's own cost is small.
 */
export interface Task {
  readonly id: string;
  run(): void;
}

/** Milliseconds since some start, in steps that depend on the platform: performance.now. */
export type Clock = () => number;

export interface Plan {
  /** Largest number of rounds. */
  readonly rounds: number;
  /** Least milliseconds of a sample. */
  readonly least: number;
  /** Least steps of the clock in a sample. */
  readonly steps: number;
  /** Untimed rounds before, in which the engine compiles. */
  readonly warmUp: number;
  /** When fewer rounds are enough; absent: never. */
  readonly settles?: Settling | undefined;
}

/**
 * A measurement ends early after `rounds` rounds if for each task the lower quartile is at most a
 * share `spread` above the least time.
 */
interface Settling {
  readonly rounds: number;
  readonly spread: number;
}

/** 15 rounds of samples of 10 ms and 100 clock steps, so that a step is at most 1 % of a sample. */
const USUAL: Plan = { rounds: 15, least: 10, steps: 100, warmUp: 3 };

/** Milliseconds per call, by task id, one number for each round. */
export type Times = ReadonlyMap<string, readonly number[]>;

/** The state of a measurement after one more sample. */
interface Progress {
  /** Rounds that are complete; below 0 in the warm-up. */
  readonly round: number;
  /** Samples taken, and how many there will be at most. */
  readonly done: number;
  readonly total: number;
  readonly times: Times;
}

/** The smallest difference in ms that the clock shows in a few tries. */
export function clockStep(clock: Clock): number {
  let step = Number.POSITIVE_INFINITY;
  for (let k = 0; k < 10; k++) {
    const start = clock();
    let now = clock();
    while (now === start) now = clock();
    step = Math.min(step, now - start);
  }
  return step;
}

/**
 * Measures sample by sample; the caller may do other work between two samples, or stop. The tasks
 * take turns within each round, so that other load on the machine affects all of them alike.
 */
export function* measuring(
  tasks: readonly Task[],
  clock: Clock,
  plan: Plan,
  step: number,
): Generator<Progress, Times> {
  const least = Math.max(plan.least, plan.steps * step);
  const times = new Map(tasks.map(({ id }) => [id, [] as number[]]));
  const repeats = new Map<string, number>();
  const total = tasks.length * (plan.rounds + plan.warmUp);
  let done = 0;
  for (let round = -plan.warmUp; round < plan.rounds; round++) {
    for (const [k, task] of tasks.entries()) {
      const { spent, calls } = sample(task, clock, least, repeats.get(task.id) ?? 1);
      repeats.set(task.id, calls);
      if (round >= 0) times.get(task.id)?.push(spent / calls);
      done += 1;
      yield { round: k + 1 === tasks.length ? round + 1 : round, done, total, times };
    }
    if (plan.settles && hasSettled(times, plan.settles)) break;
  }
  return times;
}

/** Measures without a pause. */
export function measure(tasks: readonly Task[], clock: Clock, plan: Plan = USUAL): Times {
  const samples = measuring(tasks, clock, plan, clockStep(clock));
  for (;;) {
    const { done, value } = samples.next();
    if (done) return value;
  }
}

export function hasSettled(times: Times, { rounds, spread }: Settling): boolean {
  return [...times.values()].every((all) => {
    const ascending = sorted(all);
    const least = ascending[0] ?? Number.NaN;
    return all.length >= rounds && quantile(ascending, 0.25) <= (1 + spread) * least;
  });
}

/** Calls the task until the sample is long enough, with twice as many calls at each try. */
function sample(
  task: Task,
  clock: Clock,
  least: number,
  first: number,
): { spent: number; calls: number } {
  for (let calls = first; ; calls *= 2) {
    const start = clock();
    for (let k = 0; k < calls; k++) task.run();
    const spent = clock() - start;
    if (spent >= least) return { spent, calls };
  }
}
