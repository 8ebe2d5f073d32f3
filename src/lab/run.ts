/** Something to be timed; one call works through a whole batch, so that the call itself costs nothing. */
export interface Task {
  readonly id: string;
  run(): void;
}

/** Milliseconds from any start, with whatever step the platform allows: performance.now. */
export type Clock = () => number;

export interface Plan {
  readonly rounds: number;
  /** A sample takes at least this many milliseconds, … */
  readonly least: number;
  /** … and at least this many steps of the clock. */
  readonly steps: number;
  /** Untimed rounds before, in which the engine compiles and forgets its first guesses. */
  readonly warmUp: number;
}

/** What the design asks for: 15 rounds of samples of 10 ms and 100 steps. */
export const USUAL: Plan = { rounds: 15, least: 10, steps: 100, warmUp: 3 };

/** The smallest difference that the clock shows, of a few tries. */
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
 * Milliseconds a call, per task and round. The tasks take turns within each round, so that whatever else the machine does meets
 * all of them alike; only ratios within one round say much.
 */
export function measure(
  tasks: readonly Task[],
  clock: Clock,
  plan: Plan = USUAL,
): Map<string, number[]> {
  const least = Math.max(plan.least, plan.steps * clockStep(clock));
  const times = new Map(tasks.map(({ id }) => [id, [] as number[]]));
  const repeats = new Map<string, number>();
  for (let round = -plan.warmUp; round < plan.rounds; round++) {
    for (const task of tasks) {
      const { spent, calls } = sample(task, clock, least, repeats.get(task.id) ?? 1);
      repeats.set(task.id, calls);
      if (round >= 0) times.get(task.id)?.push(spent / calls);
    }
  }
  return times;
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
