import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import type { Case } from '../../src/check/program/cases.ts';
import type { Graded } from '../../src/check/program/marks.ts';
import { reportOf } from '../../src/check/program/report.ts';
import { readResults } from '../../src/check/program/results.ts';
import { type RunAgain, shrunk } from '../../src/check/program/shrink.ts';
import {
  chosenOf,
  isProgram,
  isResults,
  type Submission,
  toldApart,
} from '../../src/check/program/submissions.ts';
import { isSet, setOf, setProblem } from '../../src/check/sets.ts';
import { SHAPES } from '../../src/math/index.ts';
import type { ShapeKind } from '../../src/math/shapes.ts';
import { LIMITS, type Limits, runProgram } from './program.ts';

const LARGEST = 4_000_000;

/**
 * The shapes that submissions are tried on: kinds with commas between them, 'all', or a set's id.
 *
 * @throws RangeError with what is wrong with the text.
 */
export function kindsIn(text: string): readonly ShapeKind[] {
  const all = SHAPES.map(({ kind }) => kind);
  if (text === 'all') return all;
  const names = text.split(',');
  const kinds = names.flatMap((name) => all.filter((kind) => kind === name));
  if (kinds.length === names.length) return kinds;
  if (isSet(text)) return setOf(text).shapes;
  throw new RangeError(`'${text}' is neither shapes nor a set: ${setProblem(text)}`);
}

/** What each path holds: a file, or a folder in which exactly one file can be graded. */
export function submissionsIn(paths: readonly string[]): Submission<string>[] {
  const found = paths.map((path): Submission<string> => {
    const stat = statSync(path, { throwIfNoEntry: false });
    const who = basename(path, stat?.isDirectory() ? '' : extname(path));
    if (!stat) return { who, file: null, problem: `there is no ${path}` };
    if (!stat.isDirectory()) return { who, file: path, problem: '' };
    const chosen = chosenOf(readdirSync(path));
    return 'problem' in chosen
      ? { who, file: null, problem: chosen.problem }
      : { who, file: join(path, chosen.name), problem: '' };
  });
  return toldApart(found);
}

/** Runs or reads one submission. Whatever is wrong with it is said in `problems`. */
export async function gradeOne(
  { who, file, problem }: Submission<string>,
  cases: readonly Case[],
  limits: Limits = LIMITS,
): Promise<Graded> {
  if (file === null) return { who, report: null, problems: [problem] };
  const text = readText(file);
  if (text === null) return { who, report: null, problems: [`${file} is larger than 4 MB`] };
  if (isProgram(file)) {
    const { outputs, problem: why } = await runProgram(text, cases, limits);
    const problems = why ? [why] : [];
    if (outputs.length === 0) return { who, report: null, problems };
    const report = reportOf(cases, outputs);
    if (why || report.silent) return { who, report, problems };
    const again: RunAgain = async (simpler) => (await runProgram(text, simpler, limits)).outputs;
    return { who, report: { ...report, branches: await shrunk(report.branches, again) }, problems };
  }
  if (!isResults(file)) {
    return { who, report: null, problems: [`${file}: neither a program nor a file of results`] };
  }
  const read = readResults(text, cases);
  return read.ok
    ? { who, report: reportOf(cases, read.outputs), problems: read.problems }
    : { who, report: null, problems: [`${file}: ${read.reason}`] };
}

const readText = (file: string): string | null =>
  statSync(file).size > LARGEST ? null : readFileSync(file, 'utf8');
