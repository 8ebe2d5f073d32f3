import { readdirSync, readFileSync, statSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import type { Case } from '../../src/check/program/cases.ts';
import { reportOf } from '../../src/check/program/report.ts';
import { readResults } from '../../src/check/program/results.ts';
import { isSet, setOf, setProblem } from '../../src/check/sets.ts';
import { SHAPES } from '../../src/math/index.ts';
import type { ShapeKind } from '../../src/math/shapes.ts';
import type { Graded } from './marks.ts';
import { LIMITS, type Limits, runProgram } from './program.ts';

const PROGRAMS = ['.js', '.mjs', '.cjs', '.ts', '.mts'];
const RESULTS = ['.json', '.jsonl', '.csv', '.tsv', '.txt'];
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

/** A file of a submission and whose it is: the file's name, or that of its folder. */
interface Submission {
  readonly who: string;
  readonly file: string | null;
  readonly problem: string;
}

/** What each path holds: a file, or a folder in which exactly one file can be graded. */
export function submissionsIn(paths: readonly string[]): Submission[] {
  const found = paths.map((path): Submission => {
    const stat = statSync(path, { throwIfNoEntry: false });
    const who = basename(path, stat?.isDirectory() ? '' : extname(path));
    if (!stat) return { who, file: null, problem: `there is no ${path}` };
    if (!stat.isDirectory()) return { who, file: path, problem: '' };
    const files = readdirSync(path).filter((name) =>
      [...PROGRAMS, ...RESULTS].includes(extname(name).toLowerCase()),
    );
    const named = files.filter((name) => /^(?:intersect|results)\./.test(name));
    const [only, ...others] = named.length > 0 ? named : files;
    if (!only) return { who, file: null, problem: 'nothing in this folder can be graded' };
    if (others.length === 0) return { who, file: join(path, only), problem: '' };
    const problem = `several files in this folder could be meant: ${files.join(', ')}`;
    return { who, file: null, problem };
  });
  // Two of the same name would be one line of a course system.
  return found.map((one, i) => {
    const before = found.slice(0, i).filter(({ who }) => who === one.who).length;
    return before === 0 ? one : { ...one, who: `${one.who} (${before + 1})` };
  });
}

/** Runs or reads one submission. Whatever is wrong with it is said in `problems`. */
export async function gradeOne(
  { who, file, problem }: Submission,
  cases: readonly Case[],
  limits: Limits = LIMITS,
): Promise<Graded> {
  if (file === null) return { who, report: null, problems: [problem] };
  const text = readText(file);
  if (text === null) return { who, report: null, problems: [`${file} is larger than 4 MB`] };
  const kind = extname(file).toLowerCase();
  if (PROGRAMS.includes(kind)) {
    const { outputs, problem: why } = await runProgram(text, cases, limits);
    const problems = why ? [why] : [];
    const report = outputs.length > 0 ? reportOf(cases, outputs) : null;
    return { who, report, problems };
  }
  if (!RESULTS.includes(kind)) {
    return { who, report: null, problems: [`${file}: neither a program nor a file of results`] };
  }
  const read = readResults(text, cases);
  return read.ok
    ? { who, report: reportOf(cases, read.outputs), problems: read.problems }
    : { who, report: null, problems: [`${file}: ${read.reason}`] };
}

const readText = (file: string): string | null =>
  statSync(file).size > LARGEST ? null : readFileSync(file, 'utf8');
