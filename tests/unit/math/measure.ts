import { findFamily, type Question } from '../../../src/math/families.ts';
import { findMethod } from '../../../src/math/find-method.ts';
import { ulpDistance } from '../../../src/math/float/ulp.ts';
import type { Intersection } from '../../../src/math/intersection.ts';
import type { Method } from '../../../src/math/methods/define.ts';
import { exact } from '../../../src/math/methods/exact.ts';
import { seeded } from '../../../src/math/rng.ts';

/** A question with its exact answer. */
export interface Judged extends Question {
  readonly truth: Intersection;
}

export function judged(questions: readonly Question[]): Judged[] {
  return questions.map(({ shape, ray }) => ({ shape, ray, truth: exact.intersect(shape, ray) }));
}

export function drawJudged(id: string, count: number, seed: number, difficulty?: number): Judged[] {
  const family = findFamily(id);
  if (!family) throw new Error(`no family ${id}`);
  const random = seeded(seed);
  return judged(Array.from({ length: count }, () => family.make(random, difficulty)));
}

interface Score {
  readonly count: number;
  /** Another class than the exact one. */
  readonly wrong: number;
  readonly undecided: number;
  /** Of the roots of rightly classed rays, how many doubles they are off; ascending. */
  readonly ulps: readonly number[];
}

export const method = (id: string): Method => findMethod(id) as Method;

export function score(id: string, questions: readonly Judged[]): Score {
  const tested = method(id);
  let wrong = 0;
  let undecided = 0;
  const ulps: number[] = [];
  for (const { shape, ray, truth } of questions) {
    const found = tested.intersect(shape, ray);
    if (found.class === 'undecided') undecided += 1;
    else if (found.class !== truth.class) wrong += 1;
    else ulps.push(...found.hits.map(({ t }, i) => ulpDistance(t, truth.hits[i]?.t ?? Number.NaN)));
  }
  return { count: questions.length, wrong, undecided, ulps: ulps.sort((a, b) => a - b) };
}

/** Digits lost, in bits: half of the roots are off by less than 2^this doubles. */
export const medianBits = ({ ulps }: Score): number =>
  Math.log2(1 + (ulps[ulps.length >> 1] ?? Number.NaN));
export const worst = ({ ulps }: Score): number => ulps.at(-1) ?? Number.NaN;
export const wrongShare = ({ wrong, count }: Score): number => wrong / count;
