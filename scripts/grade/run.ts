import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { gradedCases } from '../../src/check/program/cases.ts';
import { casesCsv, casesJson } from '../../src/check/program/exchange.ts';
import {
  type Graded,
  gradesCsv,
  gradescope,
  gradesMarkdown,
  junit,
  readWeights,
  resultsName,
  scoreOf,
  WEIGHTS,
} from '../../src/check/program/marks.ts';
import { gradeOne, kindsIn, submissionsIn } from './grade.ts';
import { LIMITS } from './program.ts';

/*
 * npm run grade -- submissions/* --set cone,sphere --cases-seed 2718 --out marks
 * npm run grade -- --set cone,sphere --cases-seed 2718 --cases cases.json
 *
 * The first grades programs in JavaScript and TypeScript, and results of programs in other
 * languages; the second writes the cases for those.
 */

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    set: { type: 'string', default: 'all' },
    'cases-seed': { type: 'string', default: '41' },
    weights: { type: 'string' },
    seconds: { type: 'string', default: String(LIMITS.total / 1000) },
    cases: { type: 'string' },
    out: { type: 'string', default: 'marks' },
  },
});

/** @throws RangeError for what is no whole number of up to nine digits. */
function whole(name: string, text: string): number {
  if (!/^\d{1,9}$/.test(text)) throw new RangeError(`--${name} is a whole number, not '${text}'`);
  return Number(text);
}

async function grade(): Promise<number> {
  const kinds = kindsIn(values.set);
  const seed = whole('cases-seed', values['cases-seed']);
  const weights = values.weights === undefined ? WEIGHTS : readWeights(values.weights);
  const limits = { ...LIMITS, total: 1000 * whole('seconds', values.seconds) };
  const cases = gradedCases(kinds, seed);
  if (values.cases !== undefined) {
    const isCsv = values.cases.endsWith('.csv');
    writeFileSync(values.cases, isCsv ? casesCsv(cases) : casesJson(cases, seed));
    console.log(`${cases.length} cases in ${values.cases}`);
  }
  if (positionals.length === 0) {
    if (values.cases !== undefined) return 0;
    throw new RangeError('say which files or folders to grade, or --cases FILE');
  }
  const all: Graded[] = [];
  for (const submission of submissionsIn(positionals)) {
    const graded = await gradeOne(submission, cases, limits);
    all.push(graded);
    const words = graded.problems.length > 0 ? `  (${graded.problems.join('; ')})` : '';
    console.log(`${scoreOf(graded, weights).toFixed(2).padStart(6)}  ${graded.who}${words}`);
  }
  mkdirSync(values.out, { recursive: true });
  const write = (name: string, text: string): void => {
    writeFileSync(join(values.out, name), text);
  };
  write('class.csv', gradesCsv(all, weights));
  write('junit.xml', junit(all));
  write('report.md', gradesMarkdown(all, weights, `Programs for ${kinds.join(', ')}`));
  const [only, ...others] = all;
  if (only && others.length === 0) write('results.json', gradescope(only, weights));
  else for (const one of all) write(resultsName(one.who), gradescope(one, weights));
  console.log(`written to ${values.out}`);
  return 0;
}

try {
  process.exitCode = await grade();
} catch (error) {
  if (!(error instanceof RangeError)) throw error;
  console.error(error.message);
  process.exitCode = 1;
}
