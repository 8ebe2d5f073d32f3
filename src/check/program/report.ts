import { intersect } from '../../math/index.ts';
import { type Case, GROUPS, type GroupId } from './cases.ts';
import { judgeCase, type Output, type Verdict } from './judge.ts';
import { remarks } from './remarks.ts';
import { type Finding, findings } from './suspects.ts';

export interface Failure {
  readonly case: Case;
  readonly output: Output;
  readonly verdict: Verdict;
}

export interface FamilyReport {
  readonly group: GroupId;
  readonly family: string;
  readonly passed: number;
  readonly total: number;
  /** Right digits of the worst root; null if no root was compared. */
  readonly digits: number | null;
  /** "all right", or the reasons of the failures, the commonest first. */
  readonly says: string;
  readonly first: Failure | null;
}

/** How many cases of a group are right: by the program, and by methods of the ladder. */
export interface GroupScore {
  readonly id: GroupId;
  readonly title: string;
  readonly passed: number;
  readonly total: number;
  /** For hard cases only: in the other groups these methods get all right. */
  readonly others: readonly { readonly method: string; readonly passed: number }[];
}

export interface Report {
  readonly groups: readonly GroupScore[];
  /** Number of cases without a result; they count as not right. */
  readonly left: number;
  /**
   * It never returned a root for a valid input; then cases without a root do not count as right.
   */
  readonly silent: boolean;
  /** The common reason of all failures, if there are many; '' otherwise. */
  readonly common: string;
  /** Sentences on the results as a whole. */
  readonly remarks: readonly string[];
  readonly families: readonly FamilyReport[];
  readonly findings: readonly Finding[];
}

const MISSING: Output = { type: 'missing' };

/** The report by groups and families. `outputs` may be shorter than `cases` or have holes. */
export function reportOf(cases: readonly Case[], outputs: readonly (Output | undefined)[]): Report {
  const all = cases.map((_, i) => outputs[i] ?? MISSING);
  // Results for invalid inputs do not count as roots.
  const silent = all.every((output, i) => !cases[i]?.expected || isSilent(output));
  const run = cases.map((one, i): Failure => {
    const output = all[i] ?? MISSING;
    const verdict = judgeCase(one, output);
    return { case: one, output, verdict: silent && verdict.passed ? SILENCE : verdict };
  });
  const families = GROUPS.flatMap(({ id: group }) => {
    const inGroup = run.filter((one) => one.case.group === group);
    const names = group === 'invalid' ? [''] : [...new Set(inGroup.map((one) => one.case.family))];
    return names.flatMap((name) => {
      const members =
        group === 'invalid' ? inGroup : inGroup.filter((one) => one.case.family === name);
      return members.length > 0 ? [familyReport(group, name || 'invalid input', members)] : [];
    });
  });
  return {
    groups: GROUPS.map(({ id, title }) => scoreOf(id, title, run)),
    left: all.filter(({ type }) => type === 'missing').length,
    silent,
    common: commonReason(run),
    remarks: remarks(cases, all),
    families,
    findings: silent ? [] : findings(cases, all),
  };
}

const isSilent = (output: Output): boolean =>
  output.type === 'value'
    ? output.t.length === 0
    : output.type !== 'shape' || !output.meant || output.meant.length === 0;

const SILENCE: Verdict = {
  passed: false,
  digits: null,
  says: 'no root, but it never returns one',
};

/** Methods whose scores on hard cases are shown beside the program's. */
const COMPARED = ['textbook', 'certified'];

function scoreOf(id: GroupId, title: string, run: readonly Failure[]): GroupScore {
  const members = run.filter((one) => one.case.group === id);
  const methods = id === 'hard' ? COMPARED : [];
  return {
    ...{ id, title, total: members.length },
    passed: members.filter(({ verdict }) => verdict.passed).length,
    others: methods.map((method) => ({
      method,
      passed: members.filter((one) => isRightBy(method, one.case)).length,
    })),
  };
}

function isRightBy(method: string, one: Case): boolean {
  const { hits } = intersect(one.shape, one.ray, method);
  const output: Output = {
    type: 'value',
    t: hits.map(({ t }) => t),
    normal: hits.map(({ normal }) => normal),
  };
  return judgeCase(one, output).passed;
}

function commonReason(run: readonly Failure[]): string {
  const failures = run.filter(({ verdict }) => !verdict.passed);
  const [kind = '', ...others] = new Set(failures.map(({ verdict }) => kindOf(verdict.says)));
  return failures.length > 1 && others.length === 0 ? kind : '';
}

function familyReport(group: GroupId, family: string, members: readonly Failure[]): FamilyReport {
  const failures = members.filter(({ verdict }) => !verdict.passed);
  const digits = members.flatMap(({ verdict }) =>
    verdict.digits === null ? [] : [verdict.digits],
  );
  return {
    group,
    family,
    passed: members.length - failures.length,
    total: members.length,
    digits: digits.length === 0 ? null : Math.min(...digits),
    says: failures.length === 0 ? 'all right' : reasons(failures),
    first: simplest(failures),
  };
}

/** The failure whose input takes the fewest characters: the easiest to work out by hand. */
function simplest(failures: readonly Failure[]): Failure | null {
  const length = ({ case: { shape, ray } }: Failure): number => JSON.stringify([shape, ray]).length;
  const [first, ...others] = failures;
  return first
    ? others.reduce((best, one) => (length(one) < length(best) ? one : best), first)
    : null;
}

/** The reasons of failures without their numbers, counted. */
function reasons(failures: readonly Failure[]): string {
  const counts = new Map<string, number>();
  for (const { verdict } of failures) {
    const kind = kindOf(verdict.says);
    counts.set(kind, (counts.get(kind) ?? 0) + 1);
  }
  const sorted = [...counts].sort((a, b) => b[1] - a[1]);
  return sorted
    .slice(0, 2)
    .map(([kind, count]) => (counts.size === 1 ? kind : `${count}× ${kind}`))
    .join(', ');
}

function kindOf(says: string): string {
  if (/ digits? right$|no digit right$/.test(says)) return 'fewer than nine digits right';
  if (/^answers t = /.test(says)) return 'answers, although the input is invalid';
  if (/^t is -?[\d.]/.test(says)) return 't is a number, not an array of numbers';
  if (/^returned -?[\d.]/.test(says)) return 'returned a number: return { t: [ … ] }';
  if (/^t holds '/.test(says)) return 't holds text, not only numbers';
  return says;
}
