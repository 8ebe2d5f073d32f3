import { digitsRight } from '../exercises/digits.ts';
import type { Case } from './cases.ts';

/** What a program returned for a case. */
export type Output =
  | {
      readonly type: 'value';
      readonly t: readonly number[];
      readonly normal: readonly (readonly number[])[] | null;
      /** What was returned in place of { t }, and taken for it. */
      readonly loose?: 'an array' | 'nothing';
    }
  | { readonly type: 'threw'; readonly message: string; readonly line: number | null }
  /** A result that is not of the form `{ t, normal? }`. */
  | {
      readonly type: 'shape';
      readonly message: string;
      /** The roots that it evidently contains; null if there are none. */
      readonly meant: readonly number[] | null;
    }
  /** The watchdog ended the run in this case. */
  | { readonly type: 'stopped' }
  /** No result: the run ended before this case, or a file has none for it. */
  | { readonly type: 'missing' };

export interface Verdict {
  readonly passed: boolean;
  /** Right digits of the worst root, 0 to 16; null if there are no roots to compare. */
  readonly digits: number | null;
  /** Why it failed; '' if it passed. */
  readonly says: string;
}

/**
 * Least right digits of a root that passes. Programs that avoid cancellation have 12 or more.
 */
export const NEEDED_DIGITS = 9;

/** Largest sine of the angle between a normal and the right one; its point is rounded as well. */
const NORMAL_TOLERANCE = 1e-6;

const passed = (digits: number | null): Verdict => ({ passed: true, digits, says: '' });
const failed = (says: string, digits: number | null = null): Verdict => ({
  passed: false,
  digits,
  says,
});

export function judgeCase({ expected, family }: Case, output: Output): Verdict {
  switch (output.type) {
    case 'stopped':
      return failed('did not end within a second');
    case 'missing':
      return failed('no result');
    case 'shape':
      return failed(output.message);
    case 'threw': {
      if (!expected) return passed(null);
      const where = output.line === null ? '' : ` in line ${output.line}`;
      return failed(`threw${where}: ${output.message}`);
    }
    case 'value': {
      if (!expected) return invalidAccepted(output.t, family);
      return judgeRoots(expected.t, expected.class, output.t) ?? judgeNormals(expected, output);
    }
  }
}

function invalidAccepted(t: readonly number[], family: string): Verdict {
  if (t.length === 0) return passed(null);
  return failed(`answers t = ${listed(t)} although ${family}: throw, or return no t`);
}

const listed = (t: readonly number[]): string => t.map((x) => String(x)).join(', ');

/** The verdict on wrong roots; null if they are right. */
function judgeRoots(
  truth: readonly number[],
  verdict: string,
  t: readonly number[],
): Verdict | null {
  if (t.some(Number.isNaN)) return failed(`NaN for ${meantBy(verdict)}`, 0);
  if (t.length !== truth.length) return failed(countWrong(truth, verdict, t), 0);
  if (t.some((x, i) => x < (t[i - 1] ?? x)))
    return failed('the roots are not in ascending order', 0);
  const digits = worstDigits(truth, t);
  if (digits === null || digits >= NEEDED_DIGITS) return null;
  const at = t.findIndex((x, i) => digitsOf(x, truth[i] ?? Number.NaN, truth) === digits);
  const whole = Math.floor(digits);
  const left = whole < 1 ? 'no digit' : `${whole} digit${whole === 1 ? '' : 's'}`;
  return failed(`t = ${t[at]} for ${truth[at]}: ${left} right`, digits);
}

function meantBy(verdict: string): string {
  if (verdict === 'contained') return '“the whole line”';
  return verdict === 'none' ? '“no root”' : 'a root';
}

function countWrong(truth: readonly number[], verdict: string, t: readonly number[]): string {
  if (verdict === 'tangent' && t.length === 2) return 'the one root is returned twice';
  if (verdict === 'contained') return `${t.length} roots for “the whole line”: return no t`;
  if (t.length > truth.length)
    return truth.length === 0 ? 'a hit where there is none' : 'a root too many';
  return t.length === 0 ? 'misses the hit' : 'misses one of two hits';
}

/** Right digits of a root. For an exact 0 they are counted relative to the other root, or to 1. */
function digitsOf(x: number, truth: number, all: readonly number[]): number {
  if (truth !== 0) return digitsRight(x, truth);
  const scale = Math.max(1, ...all.map(Math.abs));
  return digitsRight(scale + x, scale);
}

const worstDigits = (truth: readonly number[], t: readonly number[]): number | null =>
  truth.length === 0
    ? null
    : Math.min(...truth.map((x, i) => digitsOf(t[i] ?? Number.NaN, x, truth)));

function judgeNormals(
  { t: truth, normal }: NonNullable<Case['expected']>,
  output: Extract<Output, { type: 'value' }>,
): Verdict {
  const digits = worstDigits(truth, output.t);
  if (!output.normal) return passed(digits);
  if (output.normal.length !== normal.length) {
    return failed(`${output.normal.length} normals for ${normal.length} roots`, digits);
  }
  const wrong = normal.some((n, i) => !sameDirection(output.normal?.[i] ?? [], n));
  return wrong ? failed('a normal points elsewhere', digits) : passed(digits);
}

/** Whether v is a positive multiple of `truth`. A normal that is exactly zero matches any. */
export function sameDirection(v: readonly number[], truth: readonly number[]): boolean {
  const size = Math.hypot(...truth);
  if (size === 0) return true;
  const own = Math.hypot(...v);
  if (!Number.isFinite(size)) return !Number.isFinite(own);
  if (!(own > 0) || v.length !== truth.length) return false;
  return truth.every((x, i) => Math.abs((v[i] ?? 0) / own - x / size) <= NORMAL_TOLERANCE);
}
