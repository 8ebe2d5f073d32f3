import type { Case } from '../../check/program/cases.ts';
import { gradedCases } from '../../check/program/cases.ts';
import { casesCsv, casesJson } from '../../check/program/exchange.ts';
import type { Output } from '../../check/program/judge.ts';
import { type Failure, type Report, reportOf } from '../../check/program/report.ts';
import { readResults } from '../../check/program/results.ts';
import { adviceFor, asScript, looksTyped, tooLong } from '../../check/program/script.ts';
import type { RunAgain } from '../../check/program/shrink.ts';
import { textbookFor } from '../../check/program/template.ts';
import { setName, setOf } from '../../check/sets.ts';
import { SHAPES } from '../../math/index.ts';
import type { ShapeKind } from '../../math/shapes.ts';
import type { ProgramView } from '../../panels/check-program-view.ts';
import { lazy } from '../../ui/lazy.ts';
import { IGNORE_MESSAGES, runInSandbox } from './sandbox.ts';

/**
 * Number of ordinary cases that are timed: enough to have every kind, few enough for short rounds.
 */
const TIMED = 24;

/** The shapes to try; 'all' means those of the link's set, as when the link was written. */
export const kindsFor = (cases: string, set: string): readonly ShapeKind[] =>
  cases === 'all'
    ? setOf(set).shapes
    : SHAPES.map(({ kind }) => kind).filter((kind) => cases === kind);

/** Label of "all shapes": those of the set, which may be fewer than SHAPES. */
export const allWords = (set: string): string => {
  const { length } = setOf(set).shapes;
  return length === SHAPES.length ? 'all shapes' : `the ${length} shapes of ${setName(set)}`;
};

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
  | 'shrinking'
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
  shrinking: false,
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
export function createRuns(
  host: () => Element,
  changed: () => void,
  seed: () => number,
  isTimed = true,
): Runs {
  let state = NOTHING;
  let close: (() => void) | null = null;
  let stop = (): void => {};
  /** Grows with every run, so that one that waits for code knows that it is not the last. */
  let calls = 0;
  const fresh = (): RunState => ({ ...NOTHING, finished: state.finished });
  const put = (next: Partial<RunState>): void => {
    state = { ...state, ...next };
    changed();
  };
  /**
   * Looks for the smallest failing case of each branch, by running the program again. A branch
   * that is selected meanwhile stays selected.
   */
  const shrink = async (report: Report, job: Pick<Job, 'source' | 'textbook'>): Promise<void> => {
    const call = calls;
    let leave = (): void => {};
    const again: RunAgain = (cases) =>
      new Promise((resolve) => {
        const outputs: Output[] = [];
        const heard = {
          ...IGNORE_MESSAGES,
          output: (_: number, output: Output) => void outputs.push(output),
          end: () => resolve(outputs),
        };
        const packed = cases.map(({ shape, ray }) => ({ shape, ray }));
        const end = runInSandbox(host(), { ...job, cases: packed, timed: [] }, heard);
        leave = () => {
          end();
          resolve([]);
        };
      });
    const ended = (): void => {
      stop = () => {};
      put({ shrinking: false });
    };
    stop = close = () => {
      calls++;
      close = null;
      leave();
      ended();
    };
    const { shrunk } = await lazy(() => import('../../check/program/shrink.ts'));
    if (call !== calls) return;
    const branches = await shrunk(report.branches, again);
    if (call !== calls) return;
    close = null;
    const at = report.branches.findIndex(({ first }) => first && first === state.selected);
    const selected = branches[at]?.first ?? state.selected;
    put({ report: { ...report, branches }, selected });
    ended();
  };
  const finish = (
    cases: readonly Case[],
    outputs: readonly (Output | undefined)[],
    trouble: string,
    job: Pick<Job, 'source' | 'textbook'> | null = null,
  ) => {
    close = null;
    stop = () => {};
    const report = outputs.length > 0 ? reportOf(cases, outputs) : null;
    const selected = report && firstOf(report);
    const shrinking = selected !== null && job !== null && report?.silent === false;
    put({ running: null, trouble, report, selected, finished: state.finished + 1, shrinking });
    if (shrinking) shrink(report, job).catch(() => put({ shrinking: false }));
  };
  /** Runs a program; one in TypeScript without its types. `text` is what runs of `source`. */
  const start = (source: string, kinds: readonly ShapeKind[], text: string | null = null): void => {
    close?.();
    close = null;
    calls++;
    const refusal = tooLong(source);
    if (refusal) {
      finish([], [], `This program is not run: ${refusal}.`);
      return;
    }
    const cases = gradedCases(kinds, seed());
    const outputs: Output[] = [];
    state = { ...fresh(), running: { done: 0, total: cases.length } };
    changed();
    if (text === null && looksTyped(source)) {
      void withoutTypes(source, kinds);
      return;
    }
    stop = () => {
      close?.();
      finish(cases, outputs, 'Cancelled.');
    };
    const job = {
      source: asScript(text ?? source),
      textbook: textbookFor(kinds, 'textbook'),
      cases: cases.map(({ shape, ray }) => ({ shape, ray })),
      timed: isTimed ? timedOf(cases) : [],
    };
    close = runInSandbox(host(), job, {
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
          // What a quick look does not take for TypeScript may be some.
          if (text === null && message.startsWith('syntax error')) {
            void withoutTypes(source, kinds, ending);
            return;
          }
          const last = source.split('\n').length;
          const where = line === null ? '' : `Line ${Math.min(line, last)}: `;
          const advice = adviceFor(source, message);
          finish(cases, outputs, `${where}${message}${advice && `. ${advice}`}`);
        } else if (ending.how === 'stopped' && outputs.length < cases.length) {
          const at =
            `Stopped at case ${outputs.length + 1} of ${cases.length}: ` + `${ending.message}.`;
          finish(cases, [...outputs, { type: 'stopped' }], at);
        } else finish(cases, outputs, '', job);
      },
    });
  };
  const withoutTypes = async (
    source: string,
    kinds: readonly ShapeKind[],
    before: { readonly message: string; readonly line: number | null } | null = null,
  ): Promise<void> => {
    const call = calls;
    stop = () => {
      calls++;
      finish([], [], 'Cancelled.');
    };
    const loaded = await lazy(() => import('../../check/program/strip.ts')).catch(() => null);
    if (call !== calls) return;
    if (!loaded) {
      const words = 'The code that takes types away could not be loaded: try again.';
      finish([], [], words);
      return;
    }
    const { stripTypes } = loaded;
    const stripped = stripTypes(source);
    if (stripped.ok && (!before || stripped.text !== source)) {
      start(source, kinds, stripped.text);
      return;
    }
    const { message, line } = before ?? (stripped.ok ? { message: '', line: null } : stripped);
    const where = line === null ? '' : `Line ${Math.min(line, source.split('\n').length)}: `;
    const advice = adviceFor(source, message);
    finish([], [], `${where}${message}${advice && `. ${advice}`}`);
  };
  return {
    get: () => state,
    run: (source, kinds) => start(source, kinds),
    cancel: () => stop(),
    select: (selected) => put({ selected }),
    grade(text, kinds) {
      const cases = gradedCases(kinds, seed());
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
      const cases = gradedCases(kinds, seed());
      return format === 'json' ? casesJson(cases, seed()) : casesCsv(cases);
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

/** The failing case to show first: of the most ordinary branch. */
const firstOf = ({ branches }: Report): Failure | null =>
  branches.find(({ first }) => first !== null)?.first ?? null;

type Job = Parameters<typeof runInSandbox>[1];
