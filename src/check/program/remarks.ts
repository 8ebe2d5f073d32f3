import { intersect } from '../../math/index.ts';
import type { Case } from './cases.ts';
import { judgeCase, NEEDED_DIGITS, type Output } from './judge.ts';

interface Pair {
  readonly t: number;
  readonly truth: number;
}

/** Sentences on all results together that do not depend on the formulas. */
export function remarks(cases: readonly Case[], outputs: readonly Output[]): string[] {
  return [
    ...looseResults(outputs),
    unsorted(cases, outputs),
    nothingForTwo(cases, outputs),
    roundedRoots(cases, outputs) || fewDigits(cases, outputs),
  ].filter((words) => words !== '');
}

/** Least number of cases that count as evidence. */
const LEAST = 3;

/** What is not as agreed, but was understood. */
function looseResults(outputs: readonly Output[]): string[] {
  const count = (loose: string): number =>
    outputs.filter((output) => output.type === 'value' && output.loose === loose).length;
  const [nothing, arrays] = [count('nothing'), count('an array')];
  return [
    nothing > 0
      ? `Where it found no hit it returned no { t: [] }, in ${nothing} cases. That was ` +
        `understood; a miss is an empty array, not null or nothing.`
      : '',
    arrays > 0
      ? `In ${arrays} cases it returned a plain array. That was taken for t: return { t: [ … ] }.`
      : '',
  ];
}

/** Roots that would be right in ascending order. */
function unsorted(cases: readonly Case[], outputs: readonly Output[]): string {
  const count = cases.filter((one, i) => {
    const output = outputs[i];
    if (output?.type !== 'value' || output.t.length < 2 || !one.expected) return false;
    const [a = 0, b = 0] = output.t;
    const turned: Output = { type: 'value', t: [b, a], normal: null };
    return a > b && judgeCase(one, turned).passed;
  }).length;
  return count < LEAST
    ? ''
    : `In ${count} cases both roots are right, only not in ascending order: sort them before you ` +
        `return them.`;
}

/** Roots in other cases but none where there are two: probably a mistake in D. */
function nothingForTwo(cases: readonly Case[], outputs: readonly Output[]): string {
  const of = (one: Case, i: number): readonly number[] | null => {
    const output = outputs[i];
    return output?.type === 'value' && one.expected ? output.t : null;
  };
  const two = cases.flatMap((one, i) =>
    one.group !== 'hard' && one.expected?.t.length === 2 ? [of(one, i)] : [],
  );
  const some = cases.some((one, i) => (of(one, i)?.length ?? 0) > 0);
  const none = two.length > LEAST && two.every((t) => t?.length === 0);
  return some && none
    ? 'Where there are two roots it never returns one: look at D and its sign.'
    : '';
}

/** Pairs of a returned and a true root, of cases with the right number of roots. */
const pairsOf = (cases: readonly Case[], outputs: readonly Output[]): Pair[] =>
  cases.flatMap(({ expected, group }, i) => {
    const output = outputs[i];
    if (!expected || group === 'hard' || output?.type !== 'value') return [];
    if (output.t.length !== expected.t.length) return [];
    return output.t.map((t, k) => ({ t, truth: expected.t[k] ?? Number.NaN }));
  });

/** Whether each t is rounded to some decimals, digits or to float32 while the true one is not. */
function roundedRoots(cases: readonly Case[], outputs: readonly Output[]): string {
  const pairs = pairsOf(cases, outputs);
  const is = (round: (x: number) => number): boolean =>
    pairs.every(({ t }) => round(t) === t) &&
    pairs.filter(({ truth }) => round(truth) !== truth).length >= LEAST;
  const close = (round: (x: number) => number): boolean =>
    pairs.filter(({ t, truth }) => round(truth) === t).length >= 0.8 * pairs.length;
  for (let n = 0; n < NEEDED_DIGITS; n++) {
    const decimals = (x: number): number => Number(x.toFixed(n));
    if (is(decimals) && close(decimals)) {
      return `Every t is rounded to ${n} decimals: return all its digits.`;
    }
    const digits = (x: number): number => Number(x.toPrecision(n + 1));
    if (is(digits) && close(digits)) {
      return `Every t is rounded to ${n + 1} digits: return all of them.`;
    }
  }
  return is(Math.fround)
    ? 'Every t is a number of single precision (float32): compute and keep it in doubles.'
    : '';
}

/** Whether no root has more digits than float32, so that single precision is used somewhere. */
function fewDigits(cases: readonly Case[], outputs: readonly Output[]): string {
  const ordinary = cases.flatMap((one, i) => {
    const output = outputs[i];
    const own = one.group === 'ordinary' && output ? judgeCase(one, output).digits : null;
    return own === null || own === 0 ? [] : [{ one, own }];
  });
  const own = median(ordinary.map(({ own }) => own));
  const single = median(
    ordinary.map(({ one }) => {
      const { hits } = intersect(one.shape, one.ray, 'textbook32');
      const output: Output = { type: 'value', t: hits.map(({ t }) => t), normal: null };
      return judgeCase(one, output).digits ?? 0;
    }),
  );
  const alike = ordinary.length > LEAST && Math.abs(own - single) <= 1.5 && own < NEEDED_DIGITS;
  if (!alike) return '';
  return (
    `On ordinary cases about ${Math.round(own)} digits of t are right, as of the textbook ` +
    `method in single precision (float32); doubles give 15.`
  );
}

function median(values: readonly number[]): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[sorted.length >> 1] ?? Number.NaN;
}
