import { type Case, GROUPS, type GroupId } from './cases.ts';
import { judgeCase, type Output, type Verdict } from './judge.ts';
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
  /** Digits right of the worst root; null where nothing was compared. */
  readonly digits: number | null;
  /** "all right", or the reasons of the failures, the commonest first. */
  readonly says: string;
  readonly first: Failure | null;
}

export interface Report {
  readonly passed: number;
  readonly total: number;
  /** Cases that were not run, because the run was stopped. */
  readonly left: number;
  /** It never returned a root. */
  readonly silent: boolean;
  readonly families: readonly FamilyReport[];
  readonly findings: readonly Finding[];
}

/** Family by family. `outputs` may be shorter than `cases`: the run was stopped there. */
export function reportOf(cases: readonly Case[], outputs: readonly (Output | undefined)[]): Report {
  const run = cases.flatMap((one, i) => {
    const output = outputs[i];
    return output ? [{ case: one, output, verdict: judgeCase(one, output) }] : [];
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
    passed: run.filter(({ verdict }) => verdict.passed).length,
    total: run.length,
    left: cases.length - run.length,
    silent: run.every(({ output }) => output.type === 'value' && output.t.length === 0),
    families,
    findings: findings(
      run.map((one) => one.case),
      run.map((one) => one.output),
    ),
  };
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
    first: failures[0] ?? null,
  };
}

/** What each failure says without its numbers, counted. */
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
  return says;
}
