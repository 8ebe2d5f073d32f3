import { csv } from '../../text/csv.ts';
import { xmlText } from '../exports/xml.ts';
import { GROUPS, type GroupId } from './cases.ts';
import { failureWords, type GroupScore, type Report } from './report.ts';
import { BRANCHES } from './suspects.ts';

/** How much each group counts, against the others. */
export type Weights = Readonly<Record<GroupId, number>>;

export const WEIGHTS: Weights = { ordinary: 4, special: 3, hard: 2, invalid: 1 };

/**
 * Weights from a text such as 'ordinary=4,hard=1'; a group that is not named counts nothing.
 *
 * @throws RangeError for what is no group or no number from 0 on, and if nothing counts.
 */
export function readWeights(text: string): Weights {
  const known = GROUPS.map(({ id }) => id);
  const weights: Record<string, number> = Object.fromEntries(known.map((id) => [id, 0]));
  for (const part of text.split(',')) {
    const [, id = '', given = ''] = /^(\w*)=(.*)$/.exec(part.trim()) ?? [];
    const weight = Number(given);
    if (!known.some((one) => one === id) || given.trim() === '' || !(weight >= 0)) {
      throw new RangeError(`'${part}' is no weight: groups are ${known.join(', ')}`);
    }
    weights[id] = weight;
  }
  const problem = weightProblem(weights as Weights);
  if (problem) throw new RangeError(problem);
  return weights as Weights;
}

/** Why these are no weights; '' if they are. */
export function weightProblem(weights: Weights): string {
  const all = Object.values(weights);
  const wrong = all.find((x) => !(x >= 0 && x < Number.POSITIVE_INFINITY));
  if (wrong !== undefined) return `'${wrong}' is no weight: a number from 0 on is.`;
  return all.every((weight) => weight === 0) ? 'Some group has to count.' : '';
}

/** A submission that was run or read: its report, or why there is none. */
export interface Graded {
  readonly who: string;
  /** Null where nothing could be run or read; that scores 0. */
  readonly report: Report | null;
  /** Sentences on the run or the file. */
  readonly problems: readonly string[];
}

const share = ({ passed, total }: GroupScore): number => (total === 0 ? 0 : passed / total);

/** Points out of 100: the share of right cases of each group, weighted; missing ones are wrong. */
export function scoreOf({ report }: Graded, weights: Weights): number {
  const groups = report?.groups.filter(({ total }) => total > 0) ?? [];
  const all = groups.reduce((sum, { id }) => sum + weights[id], 0);
  if (all === 0) return 0;
  const sum = groups.reduce((points, group) => points + weights[group.id] * share(group), 0);
  return Math.round((1e4 * sum) / all) / 100;
}

const findingsOf = ({ report }: Graded): string[] =>
  (report?.findings ?? []).map(({ flaw, branch }) => `${flaw.says} (cases ${BRANCHES[branch]})`);

/** The branches with failing cases: how many are right, and the simplest known to fail. */
const branchesOf = ({ report }: Graded): { readonly title: string; readonly words: string }[] =>
  (report?.branches ?? []).flatMap(({ title, passed, total, says, first }) => {
    const simplest = first ? `. The simplest that was found: ${failureWords(first)}` : '';
    return passed === total ? [] : [{ title, words: `${passed} of ${total}: ${says}${simplest}` }];
  });

const remarksOf = (graded: Graded): string[] => [
  ...graded.problems,
  ...(graded.report?.remarks ?? []),
];

/** A submission as people read it: points, right cases of each group, and what was found. */
export function rowOf(graded: Graded, weights: Weights) {
  const groups = GROUPS.map(({ id }) => {
    const group = graded.report?.groups.find((score) => score.id === id);
    return group ? `${group.passed} of ${group.total}` : '–';
  });
  const found = [...remarksOf(graded), ...findingsOf(graded)].join('; ');
  return { who: graded.who, points: scoreOf(graded, weights), groups, found };
}

/** One line for each submission. */
export function gradesCsv(all: readonly Graded[], weights: Weights): string {
  return csv([
    ['who', 'score', ...GROUPS.flatMap(({ id }) => [id, `${id} of`]), 'findings', 'problems'],
    ...all.map((one) => [
      ...[one.who, scoreOf(one, weights)],
      ...GROUPS.flatMap(({ id }) => {
        const group = one.report?.groups.find((score) => score.id === id);
        return [group?.passed ?? 0, group?.total ?? 0];
      }),
      findingsOf(one).join('; '),
      remarksOf(one).join('; '),
    ]),
  ]);
}

/** The name of a submission's file for Gradescope. */
export const resultsName = (who: string): string =>
  `results.${who.replace(/[^\w.()-]+/g, '_').slice(0, 100)}.json`;

/** What Gradescope's autograder reads as results.json, for one submission. */
export function gradescope(graded: Graded, weights: Weights): string {
  const { report } = graded;
  const groups = report?.groups.filter(({ total }) => total > 0) ?? [];
  const all = groups.reduce((sum, { id }) => sum + weights[id], 0) || 1;
  const tests = groups.map((group) => ({
    name: `${group.title} cases`,
    score: Math.round((1e4 * weights[group.id] * share(group)) / all) / 100,
    max_score: Math.round((1e4 * weights[group.id]) / all) / 100,
    status: group.passed === group.total ? 'passed' : 'failed',
    output: [
      `${group.passed} of ${group.total} right`,
      ...(report?.families ?? [])
        .filter(({ group: id, passed, total }) => id === group.id && passed < total)
        .map(({ family, passed, total, says }) => `${family}: ${passed} of ${total}, ${says}`),
    ].join('\n'),
  }));
  const output = [
    ...remarksOf(graded),
    ...findingsOf(graded),
    ...branchesOf(graded).map(({ title, words }) => `${title}: ${words}`),
  ].join('\n');
  const result = { score: scoreOf(graded, weights), output, output_format: 'text', tests };
  return `${JSON.stringify(result, null, 2)}\n`;
}

/** A suite for each submission, a test for each branch and each family of cases. */
export function junit(all: readonly Graded[]): string {
  const suites = all.map((graded) => {
    const { who, report, problems } = graded;
    const failing = branchesOf(graded);
    const branches = (report?.branches ?? []).map(({ title }) => {
      const name = `<testcase classname="branch" name="${xmlText(title)}"`;
      const words = failing.find((one) => one.title === title)?.words;
      return words === undefined
        ? `    ${name}/>`
        : `    ${name}><failure message="${xmlText(words)}"/></testcase>`;
    });
    const families = report?.families ?? [];
    const failed = families.filter(({ passed, total }) => passed < total).length;
    const tests = families.map(({ group, family, passed, total, says }) => {
      const name = `<testcase classname="${group}" name="${xmlText(family)}"`;
      return passed === total
        ? `    ${name}/>`
        : `    ${name}><failure message="${xmlText(`${passed} of ${total}: ${says}`)}"/>` +
            '</testcase>';
    });
    const error = report
      ? []
      : [
          `    <testcase classname="submission" name="it can be run"><error message="${xmlText(
            problems.join('; '),
          )}"/></testcase>`,
        ];
    return [
      `  <testsuite name="${xmlText(who)}" ` +
        `tests="${branches.length + families.length + error.length}" ` +
        `failures="${failed + failing.length}" errors="${error.length}">`,
      ...branches,
      ...tests,
      ...error,
      '  </testsuite>',
    ].join('\n');
  });
  return ['<?xml version="1.0" encoding="UTF-8"?>', '<testsuites>', ...suites, '</testsuites>', '']
    .join('\n')
    .replace(/\n\n/g, '\n');
}

const cellMd = (text: string): string => text.replace(/[\r\n]+/g, ' ').replaceAll('|', '\\|');

/** The class and what was found, for people. */
export function gradesMarkdown(all: readonly Graded[], weights: Weights, about: string): string {
  const counts = new Map<string, number>();
  for (const one of all) {
    for (const words of new Set((one.report?.findings ?? []).map(({ flaw }) => flaw.says))) {
      counts.set(words, (counts.get(words) ?? 0) + 1);
    }
  }
  const tally = [...counts].sort((a, b) => b[1] - a[1]);
  return [
    `# ${about}`,
    '',
    `Weights: ${GROUPS.map(({ id }) => `${id} ${weights[id]}`).join(', ')}. A case without a ` +
      'result counts as not right.',
    '',
    `| who | points | ${GROUPS.map(({ title }) => title).join(' | ')} | found |`,
    `| --- | ---: | ${GROUPS.map(() => '---:').join(' | ')} | --- |`,
    ...all.map((one) => {
      const { who, points, groups, found } = rowOf(one, weights);
      return `| ${cellMd(who)} | ${points} | ${groups.join(' | ')} | ${cellMd(found)} |`;
    }),
    '',
    ...(tally.length === 0 ? [] : ['| mistake | programs |', '| --- | ---: |']),
    ...tally.map(([words, count]) => `| ${cellMd(words)} | ${count} |`),
    '',
    ...all.flatMap((one) => {
      const failing = branchesOf(one);
      if (failing.length === 0) return [];
      const rows = failing.map(({ title, words }) => `* ${title}: ${cellMd(words)}`);
      return [`## ${cellMd(one.who)}`, '', ...rows, ''];
    }),
  ].join('\n');
}
