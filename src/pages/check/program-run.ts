import type { Case } from '../../check/program/cases.ts';
import { casesFor } from '../../check/program/cases.ts';
import { casesCsv, casesJson } from '../../check/program/exchange.ts';
import type { Output } from '../../check/program/judge.ts';
import { type Failure, type Report, reportOf } from '../../check/program/report.ts';
import { readResults } from '../../check/program/results.ts';
import { adviceFor, asScript, tooLong } from '../../check/program/script.ts';
import { textbookFor } from '../../check/program/template.ts';
import { setOf } from '../../check/sets.ts';
import { SHAPES } from '../../math/index.ts';
import type { ShapeKind } from '../../math/shapes.ts';
import type { ProgramView } from '../../panels/check-program-view.ts';
import { runInSandbox } from './sandbox.ts';

/** Seed of the cases; always the same, so that reports can be compared. */
const CASES_SEED = 41;
/**
 * Number of ordinary cases that are timed: enough to have every kind, few enough for short rounds.
 */
const TIMED = 24;

/** The shapes to try; 'all' means those of the link's set, as when the link was written. */
export const kindsFor = (cases: string, set: string): readonly ShapeKind[] =>
  cases === 'all'
    ? setOf(set).shapes
    : SHAPES.map(({ kind }) => kind).filter((kind) => cases === kind);

/** Number of notes shown: messages of the program outside of its results. */
const MOST_NOTES = 3;
const MOST_LINES = 101;

/** The state of a run with its results so far. */
type RunState = Pick<
  ProgramView,
  | 'running'
  | 'trouble'
  | 'notes'
  | 'lines'
  | 'report'
  | 'timing'
  | 'untimed'
  | 'selected'
  | 'finished'
>;

const NOTHING: RunState = {
  running: null,
  trouble: '',
  notes: [],
  lines: [],
  report: null,
  timing: null,
  untimed: '',
  selected: null,
  finished: 0,
};

interface Runs {
  get(): RunState;
  run(source: string, kinds: readonly ShapeKind[]): void;
  cancel(): void;
  select(failure: Failure): void;
  /** Reads results of a program in another language; false if the text has none. */
  grade(text: string, kinds: readonly ShapeKind[]): boolean;
  file(format: 'json' | 'csv', kinds: readonly ShapeKind[]): string;
}

/** Runs programs, one at a time; a new run ends the one before. */
export function createRuns(host: Element, changed: () => void): Runs {
  let state = NOTHING;
  let close: (() => void) | null = null;
  let stop = (): void => {};
  const fresh = (): RunState => ({ ...NOTHING, finished: state.finished });
  const put = (next: Partial<RunState>): void => {
    state = { ...state, ...next };
    changed();
  };
  const finish = (
    cases: readonly Case[],
    outputs: readonly (Output | undefined)[],
    trouble: string,
  ) => {
    close = null;
    stop = () => {};
    const report = outputs.length > 0 ? reportOf(cases, outputs) : null;
    const selected = report && firstFailure(report);
    put({ running: null, trouble, report, selected, finished: state.finished + 1 });
  };
  return {
    get: () => state,
    run(source, kinds) {
      close?.();
      const refusal = tooLong(source);
      if (refusal) {
        finish([], [], `This program is not run: ${refusal}.`);
        return;
      }
      const cases = casesFor(kinds, CASES_SEED);
      const outputs: Output[] = [];
      state = { ...fresh(), running: { done: 0, total: cases.length } };
      changed();
      stop = () => {
        close?.();
        finish(cases, outputs, 'Cancelled.');
      };
      const job = {
        source: asScript(source),
        textbook: textbookFor(kinds, 'textbook'),
        cases: cases.map(({ shape, ray }) => ({ shape, ray })),
        timed: timedOf(cases),
      };
      close = runInSandbox(host, job, {
        output(index, output) {
          if (index !== outputs.length || index >= cases.length) return;
          outputs.push(output);
          put({ running: { done: outputs.length, total: cases.length } });
        },
        note: (message) => put({ notes: [...state.notes, message].slice(-MOST_NOTES) }),
        console: (line) => put({ lines: [...state.lines, line].slice(0, MOST_LINES) }),
        unsteady(index) {
          const words =
            `${cases[index]?.id}, run twice, gave two results: nothing here may ` +
            `depend on chance or on earlier calls`;
          put({ notes: [...state.notes, words] });
        },
        timing: (timing) => put({ timing }),
        untimed: (untimed) => put({ untimed }),
        end(ending) {
          if (ending.how === 'unopened') {
            const why = `The sandbox could not be opened: ${ending.message}.`;
            const words = `${why} Your program was not run.`;
            finish(cases, [], words);
          } else if (ending.how === 'refused') {
            const { line, message } = ending;
            const last = source.split('\n').length;
            const where = line === null ? '' : `Line ${Math.min(line, last)}: `;
            const advice = adviceFor(source, message);
            finish(cases, outputs, `${where}${message}${advice && `. ${advice}`}`);
          } else if (ending.how === 'stopped' && outputs.length < cases.length) {
            const at =
              `Stopped at case ${outputs.length + 1} of ${cases.length}: ` + `${ending.message}.`;
            finish(cases, [...outputs, { type: 'stopped' }], at);
          } else finish(cases, outputs, '');
        },
      });
    },
    cancel: () => stop(),
    select: (selected) => put({ selected }),
    grade(text, kinds) {
      const cases = casesFor(kinds, CASES_SEED);
      const read = readResults(text, cases);
      close?.();
      close = null;
      if (!read.ok) {
        state = { ...fresh(), trouble: `These results could not be read: ${read.reason}.` };
        changed();
        return false;
      }
      state = { ...fresh(), notes: read.problems };
      finish(cases, read.outputs, '');
      return true;
    },
    file: (format, kinds) => {
      const cases = casesFor(kinds, CASES_SEED);
      return format === 'json' ? casesJson(cases, CASES_SEED) : casesCsv(cases);
    },
  };
}

function timedOf(cases: readonly Case[]): number[] {
  const ordinary = cases.flatMap(({ group, expected }, i) =>
    group === 'ordinary' && expected ? [i] : [],
  );
  const step = Math.max(1, Math.floor(ordinary.length / TIMED));
  return ordinary.filter((_, i) => i % step === 0).slice(0, TIMED);
}

const firstFailure = ({ families }: Report): Failure | null =>
  families.find(({ first }) => first !== null)?.first ?? null;
