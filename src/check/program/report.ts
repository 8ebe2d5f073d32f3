import { intersect } from '../../math/index.ts';
import { definitionOf, findShape } from '../../math/shapes.ts';
import { shortest } from '../../text/format.ts';
import { type BranchId, CASE_BRANCHES, caseBranch } from './branches.ts';
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

/** The cases that a program usually has code of its own for. */
export interface BranchReport {
  readonly id: BranchId;
  readonly title: string;
  readonly passed: number;
  readonly total: number;
  /** "all right", or the reasons of the failures, the commonest first, and for which shapes. */
  readonly says: string;
  /** The simplest failure for its commonest reason; null without one. */
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
  /** Ordinary cases first. */
  readonly branches: readonly BranchReport[];
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
    branches: branchesOf(run),
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
  const [kind = '', ...others] = new Set(failures.map(({ verdict }) => reasonOf(verdict.says)));
  return failures.length > 1 && others.length === 0 ? kind : '';
}

function branchesOf(run: readonly Failure[]): BranchReport[] {
  const of = run.map((one) => ({ one, branch: caseBranch(one.case, one.case.group) }));
  return CASE_BRANCHES.flatMap(({ id, title }): BranchReport[] => {
    const members = of.filter(({ branch }) => branch === id).map(({ one }) => one);
    if (members.length === 0) return [];
    const failures = members.filter(({ verdict }) => !verdict.passed);
    const [usual] = counted(failures);
    return [
      {
        ...{ id, title, passed: members.length - failures.length, total: members.length },
        says: failures.length === 0 ? 'all right' : reasons(failures) + onlyFor(failures, members),
        first: simplest(failures.filter(({ verdict }) => reasonOf(verdict.says) === usual?.[0])),
      },
    ];
  });
}

/** " (cone, sphere)" if some shapes of the members have no failure. */
function onlyFor(failures: readonly Failure[], members: readonly Failure[]): string {
  const kindsOf = (all: readonly Failure[]) => [...new Set(all.map((one) => one.case.shape.kind))];
  const kinds = kindsOf(failures);
  if (kinds.length === kindsOf(members).length) return '';
  return ` (${kinds.map((kind) => findShape(kind)?.title).join(', ')})`;
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

/** The reasons of failures without their numbers, the commonest first. */
function counted(failures: readonly Failure[]): (readonly [string, number])[] {
  const counts = new Map<string, number>();
  for (const { verdict } of failures) {
    const reason = reasonOf(verdict.says);
    counts.set(reason, (counts.get(reason) ?? 0) + 1);
  }
  return [...counts].sort((a, b) => b[1] - a[1]);
}

function reasons(failures: readonly Failure[]): string {
  const counts = counted(failures);
  return counts
    .slice(0, 2)
    .map(([reason, count]) => (counts.length === 1 ? reason : `${count}× ${reason}`))
    .join(', ');
}

/** Why a case failed, without its numbers. */
export function reasonOf(says: string): string {
  if (/ digits? right$|no digit right$/.test(says)) return 'fewer than nine digits right';
  if (/^answers t = /.test(says)) return 'answers, although the input is invalid';
  if (/^t is -?[\d.]/.test(says)) return 't is a number, not an array of numbers';
  if (/^returned -?[\d.]/.test(says)) return 'returned a number: return { t: [ … ] }';
  if (/^t holds '/.test(says)) return 't holds text, not only numbers';
  return says;
}

/** A case in one line: the ray, the shape, what is expected and what came. */
export function failureWords({ case: one, output, verdict }: Failure): string {
  const { shape, ray, expected } = one;
  const numbers = shape as unknown as Readonly<Record<string, unknown>>;
  const own = definitionOf(shape).params.map(({ key, symbol }) => {
    const value = numbers[key];
    return `${symbol} = ${Array.isArray(value) ? triple(value) : written(value)}`;
  });
  const right = !expected
    ? 'an error or no t'
    : expected.t.length > 0
      ? expected.t.map((t) => `t = ${written(t)}`).join(', ')
      : 'no t';
  const came = output.type === 'value' ? `; it returned [${output.t.map(written).join(', ')}]` : '';
  return (
    `E = ${triple(ray.origin)}, d = ${triple(ray.direction)}, ${shape.kind} with ` +
    `${own.join(', ')}: expected ${right}${came}: ${verdict.says}`
  );
}

const written = (x: unknown): string =>
  typeof x === 'number' && Number.isFinite(x) ? shortest(x) : String(x);
const triple = (v: readonly unknown[]): string => `(${v.map(written).join(', ')})`;
