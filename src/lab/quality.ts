import {
  type Answers,
  batchOf,
  createAnswers,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../math/batch.ts';
import { ulpDistance } from '../math/index.ts';
import type { Method } from '../math/shapes.ts';
import { rightDigitsOfDouble } from './digits.ts';
import type { Batch } from './plan.ts';
import { quantile, sorted } from './stats.ts';
import { type Judgement, judge } from './verdict.ts';

/** Indices of a ray: its batch, and its place in that batch. */
interface RayIndex {
  readonly batch: number;
  readonly ray: number;
}

/** What a method gets right and wrong on all rays of some batches. */
export interface Quality {
  readonly rays: number;
  readonly judged: Readonly<Record<Judgement, number>>;
  /** Every verdict but the right ones and the undecided. */
  readonly wrong: number;
  readonly undecided: number;
  /** Rays that are neither a plain hit nor a miss to the method: a kernel lists them one by one. */
  readonly listed: number;
  /** Errors in ulps of the roots of rays whose class is right, ascending. */
  readonly ulps: readonly number[];
  /**
   * Right digits that at least 9 of 10 rays have; NaN if no ray has a root. A ray whose verdict is
   * wrong or undecided has 0.
   */
  readonly digits: number;
  /** Right digits of the worst ray. */
  readonly leastDigits: number;
  /** The first ray with the wrong verdict, else the one with the fewest digits. */
  readonly worst: RayIndex | null;
}

const ONE_IN_TEN = 0.1;

export function qualityOf(method: Method, batches: readonly Batch[], kernelOf = batchOf): Quality {
  const judged: Record<Judgement, number> = {
    right: 0,
    misses: 0,
    invents: 0,
    misnames: 0,
    undecided: 0,
  };
  const ulps: number[] = [];
  const digits: number[] = [];
  let least = Number.POSITIVE_INFINITY;
  let worst: RayIndex | null = null;
  let listed = 0;
  batches.forEach((batch, b) => {
    const { shape, rays, verdicts } = batch;
    const kernel = kernelOf(method, shape);
    const out = createAnswers(rays.count);
    kernel.classes(rays, out);
    listed += out.rareCount;
    const byClasses = verdictsOfClasses(out, rays.count, kernel.met);
    kernel.both(rays, out);
    verdictsOfRoots(out, rays.count).forEach((verdict, i) => {
      const truth = verdicts[i] ?? 'none';
      const said = judge(verdict, truth);
      // The verdict has to be right for both questions: with roots, and class only.
      const judgement = said === 'right' ? judge(byClasses[i] ?? 'undecided', truth) : said;
      judged[judgement] += 1;
      const found = judgement === 'right' ? digitsAt(batch, out, i, ulps) : 0;
      if (Number.isNaN(found)) return;
      digits.push(found);
      // A wrong verdict ranks below one without a right digit.
      const rank = judgement === 'right' ? found : judgement === 'undecided' ? -1 : -2;
      if (rank < least) {
        least = rank;
        worst = { batch: b, ray: i };
      }
    });
  });
  const ascending = sorted(digits);
  return {
    rays: batches.reduce((sum, { rays }) => sum + rays.count, 0),
    judged,
    wrong: judged.misses + judged.invents + judged.misnames,
    undecided: judged.undecided,
    listed,
    ulps: sorted(ulps),
    digits: quantile(ascending, ONE_IN_TEN),
    leastDigits: ascending[0] ?? Number.NaN,
    worst,
  };
}

/** The smaller digit count of the two roots; NaN without roots. Appends their errors to `ulps`. */
function digitsAt({ t0, t1 }: Batch, out: Answers, i: number, ulps: number[]): number {
  let fewest = Number.NaN;
  for (const [own, nearest] of [
    [out.t0[i] as number, t0[i] as number],
    [out.t1[i] as number, t1[i] as number],
  ] as const) {
    if (Number.isNaN(nearest)) continue;
    ulps.push(ulpDistance(own, nearest));
    const digits = rightDigitsOfDouble(own, nearest);
    fewest = fewest <= digits ? fewest : digits;
  }
  return fewest;
}
