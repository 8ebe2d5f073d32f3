import { measure, type Plan, type Task } from '../../src/lab/run.ts';
import { type Quartiles, quartiles } from '../../src/lab/stats.ts';
import { batchOf, createAnswers, kernelArray, type Rays, targetOf } from '../../src/math/batch.ts';
import type { Family } from '../../src/math/families.ts';
import { seeded } from '../../src/math/rng.ts';
import type { Method } from '../../src/math/shapes.ts';
import { type Drawn, draw, ORDERS, type Order, put, room } from './rays.ts';

/*
 * What a batch costs. All methods in both targets take turns within each round, shape by shape;
 * a round's times of all shapes are added, and only ratios within one round are told.
 */

export const TARGETS = ['simd', 'typescript'] as const;
export type Target = (typeof TARGETS)[number];
export type Form = 'both' | 'classes' | 'first';

/** One thing that is timed. */
export interface Asked {
  readonly method: Method;
  readonly target: Target;
  readonly form: Form;
}

export const nameOf = (id: string, target: Target, form: Form): string => `${id} ${target} ${form}`;

/** Milliseconds a round, all shapes together, by `nameOf`; and rays in one. */
export interface Prices {
  readonly times: Readonly<Record<Order, ReadonlyMap<string, readonly number[]>>>;
  readonly rays: number;
}

export interface Sample {
  readonly seed: number;
  readonly shapes: number;
  readonly count: number;
}

/** The processor's time of this process: the wall clock mostly measures the neighbours. */
export function clock(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

/** What has no SIMD kernel for a shape is left out there. */
export function pricesOf(
  family: Family,
  { seed, shapes, count }: Sample,
  asked: readonly Asked[],
  plan: Plan,
  orders: readonly Order[] = ORDERS,
): Prices {
  const random = seeded(seed);
  const rays = room(count);
  const out = createAnswers(count, kernelArray);
  const sums: Record<Order, Map<string, number[]>> = { random: new Map(), sorted: new Map() };
  for (let k = 0; k < shapes; k++) {
    const drawn = draw(family, random, count);
    for (const order of orders) {
      put(rays, drawn.rays[order]);
      const times = measure(tasksFor(drawn, rays, asked, out), clock, plan);
      for (const [id, rounds] of times) addTo(sums[order], id, rounds);
    }
  }
  return { times: sums, rays: shapes * count };
}

function tasksFor(
  { shape }: Drawn,
  rays: Rays,
  asked: readonly Asked[],
  out: ReturnType<typeof createAnswers>,
): Task[] {
  return asked.flatMap(({ method, target, form }) => {
    if (targetOf(method, shape, target) !== target) return [];
    const kernel = batchOf(method, shape, target);
    const run = {
      both: () => kernel.both(rays, out),
      classes: () => kernel.classes(rays, out),
      first: () => kernel.first(rays, 0, Number.POSITIVE_INFINITY, out),
    }[form];
    return [{ id: nameOf(method.id, target, form), run }];
  });
}

function addTo(sums: Map<string, number[]>, id: string, rounds: readonly number[]): void {
  const before = sums.get(id);
  sums.set(
    id,
    rounds.map((x, i) => x + (before?.[i] ?? 0)),
  );
}

/** Of the rounds' ratios; null where one of the two was not measured. */
export function ratioOf(
  times: ReadonlyMap<string, readonly number[]>,
  id: string,
  base: string,
): Quartiles | null {
  const mine = times.get(id);
  const other = times.get(base);
  if (!mine || !other) return null;
  return quartiles(mine.map((x, i) => x / (other[i] as number)));
}
