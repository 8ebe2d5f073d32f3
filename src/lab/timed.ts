import {
  batchOf,
  createAnswers,
  type Kernel,
  kernelArray,
  packRays,
  type Target,
  targetOf,
  verdictsOfClasses,
} from '../math/batch.ts';
import type { Family } from '../math/families.ts';
import type { Ray, Shape } from '../math/index.ts';
import { seeded } from '../math/rng.ts';
import { DEFAULT_METHOD, findMethod, type Method } from '../math/shapes.ts';
import { type Batch, type Form, type Sample, tasksOf } from './plan.ts';
import type { Clock, Task } from './run.ts';

/** Order of the rays: as drawn, or hits first, which makes branches predictable. */
export type Order = 'random' | 'sorted';

const FORMS: readonly Form[] = ['both', 'classes'];

type Timed = Pick<Batch, 'shape' | 'rays'>;
type Drawn = ReturnType<Family['batch']>;

/**
 * The shapes of `batchesOf`, each with `count` rays, of which those of `batchesOf` are the first,
 * in the order asked for. There should be more rays than a branch predictor can learn.
 */
export function timedBatches(
  family: Family,
  { seed, shapes, count: compared, difficulty }: Sample,
  count: number,
  order: Order,
): Timed[] {
  const random = seeded(seed);
  let draws = 0;
  const counting = (): number => {
    draws += 1;
    return random();
  };
  return Array.from({ length: shapes }, () => {
    const again = seeded(seed);
    for (let k = 0; k < draws; k++) again();
    family.batch(counting, compared, difficulty);
    const drawn = family.batch(again, count, difficulty);
    const rays = order === 'sorted' ? hitsFirst(drawn) : drawn.rays;
    return { shape: drawn.shape, rays: packRays(rays, kernelArray) };
  });
}

function hitsFirst({ shape, rays }: Drawn): readonly Ray[] {
  const certified = findMethod(DEFAULT_METHOD);
  if (!certified) throw new RangeError(`no method ${DEFAULT_METHOD}`);
  const out = createAnswers(rays.length);
  const kernel = batchOf(certified, shape);
  kernel.classes(packRays(rays), out);
  const verdicts = verdictsOfClasses(out, rays.length, kernel.met);
  const meets = (_: Ray, i: number): boolean => verdicts[i] !== 'none';
  return [...rays.filter(meets), ...rays.filter((ray, i) => !meets(ray, i))];
}

/** A method with one question in one target; `rays` is the number that one run processes. */
export interface TimedTask extends Task {
  readonly method: string;
  readonly target: Target;
  readonly form: Form;
  readonly rays: number;
}

/** Whether all these shapes have a kernel of the method in the target. */
export const runsIn = (target: Target, method: Method, batches: readonly Timed[]): boolean =>
  batches.every(({ shape }) => targetOf(method, shape, target) === target);

/** Limits for the number of rays of each shape in a run. */
export interface Budget {
  /** Least number of rays. */
  readonly least: number;
  /** Approximate time limit of a run, in ms. */
  readonly most: number;
}

/** Tasks for each question, method, and target in which the method has a kernel. */
export function timedTasks(
  methods: readonly Method[],
  batches: readonly Timed[],
  targets: readonly Target[],
  clock: Clock,
  budget: Budget,
): TimedTask[] {
  const full = Math.max(0, ...batches.map(({ rays }) => rays.count));
  const out = createAnswers(full, kernelArray);
  return targets.flatMap((target) => {
    const kernelOf = (method: Method, shape: Shape): Kernel => batchOf(method, shape, target);
    return methods
      .filter((method) => runsIn(target, method, batches))
      .flatMap((method) =>
        FORMS.map((form) => {
          const met = batches.map(({ shape, rays }) => ({ shape, rays: { ...rays } }));
          const [task] = tasksOf([method], met, form, kernelOf, out);
          if (!task) throw new RangeError('a method makes a task');
          const rays = fill(task, met, full, clock, budget);
          return {
            ...task,
            id: `${target} ${form} ${method.id}`,
            method: method.id,
            target,
            form,
            rays,
          };
        }),
      );
  });
}

/**
 * Gives the task as many rays of each shape as the budget allows: four times as many at each try,
 * timed twice because a first run is slower. Returns the number of rays of a run.
 */
function fill(
  task: Task,
  met: readonly Timed[],
  full: number,
  clock: Clock,
  { least, most }: Budget,
) {
  for (let count = Math.min(least, full); ; count = Math.min(4 * count, full)) {
    for (const { rays } of met) rays.count = count;
    if (count === full) break;
    const took = [1, 2].map(() => {
      const start = clock();
      task.run();
      return clock() - start;
    });
    if (4 * Math.min(...took) > most) break;
  }
  return met.reduce((sum, { rays }) => sum + rays.count, 0);
}
