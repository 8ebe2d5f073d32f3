import type { Answered, Connection, CourseReport, Environment } from './course.ts';
import { scaled } from './course.ts';

/*
 * SCORM's run-time: a page finds an object in a window around it, and sets elements of a data model
 * by name. 1.2 and 2004 differ in names, formats and lengths.
 */

type Pairs = readonly (readonly [element: string, value: string])[];

export interface ScormVersion {
  /** Name of the object in a window. */
  readonly api: string;
  /** Before the names of 1.2. */
  readonly names: Readonly<
    Record<'start' | 'finish' | 'get' | 'set' | 'commit' | 'error' | 'words', string>
  >;
  readonly learner: string;
  readonly mode: string;
  readonly place: string;
  readonly status: string;
  /** Values of the status after which nothing is left to do. */
  readonly complete: readonly string[];
  /** Most characters of cmi.suspend_data. */
  readonly most: number;
  report(report: CourseReport, ms: number): Pairs;
  /** The elements of interaction n. */
  answer(answered: Answered, env: Environment): Pairs;
}

const percent = (report: CourseReport): string => (100 * scaled(report)).toFixed(2);

/** Texts are cut to what an element holds. */
const cut = (text: string, most: number): string =>
  text.length <= most ? text : `${text.slice(0, most - 1)}…`;

const two = (x: number): string => String(x).padStart(2, '0');

/** Hours, minutes, and seconds with two decimals. */
function partsOf(ms: number): readonly [number, number, string] {
  const seconds = Math.max(0, ms) / 1000;
  const whole = Math.floor(seconds / 60);
  return [Math.floor(whole / 60), whole % 60, (seconds - 60 * whole).toFixed(2)];
}

/** SCORM 1.2 (ADL, 2001). */
export const SCORM_12: ScormVersion = {
  api: 'API',
  names: {
    ...{ start: 'LMSInitialize', finish: 'LMSFinish', get: 'LMSGetValue', set: 'LMSSetValue' },
    ...{ commit: 'LMSCommit', error: 'LMSGetLastError', words: 'LMSGetErrorString' },
  },
  learner: 'cmi.core.student_id',
  mode: 'cmi.core.lesson_mode',
  place: 'cmi.core.lesson_location',
  status: 'cmi.core.lesson_status',
  complete: ['completed', 'passed', 'failed'],
  most: 4096,
  report(report, ms) {
    const { complete, passed, state, place } = report;
    const [hours, minutes, seconds] = partsOf(ms);
    return [
      ['cmi.core.score.min', '0'],
      ['cmi.core.score.max', '100'],
      ['cmi.core.score.raw', percent(report)],
      ['cmi.core.lesson_status', complete ? (passed ? 'passed' : 'failed') : 'incomplete'],
      ['cmi.core.lesson_location', String(place)],
      ['cmi.suspend_data', state],
      ['cmi.core.exit', 'suspend'],
      ['cmi.core.session_time', `${two(hours)}:${two(minutes)}:${seconds.padStart(5, '0')}`],
    ];
  },
  answer: ({ id, response, expected, right }, { clock }) => [
    ['id', id],
    ['type', 'fill-in'],
    ['time', clock()],
    ['correct_responses.0.pattern', cut(expected, 255)],
    ['student_response', cut(response, 255)],
    ['result', right ? 'correct' : 'wrong'],
  ],
};

/** SCORM 2004 (ADL, 3rd edition; the 4th has the same elements, and longer ones). */
export const SCORM_2004: ScormVersion = {
  api: 'API_1484_11',
  names: {
    ...{ start: 'Initialize', finish: 'Terminate', get: 'GetValue', set: 'SetValue' },
    ...{ commit: 'Commit', error: 'GetLastError', words: 'GetErrorString' },
  },
  learner: 'cmi.learner_id',
  mode: 'cmi.mode',
  place: 'cmi.location',
  status: 'cmi.completion_status',
  complete: ['completed'],
  most: 4000,
  report(report, ms) {
    const { complete, passed, state, place, done, total } = report;
    const [hours, minutes, seconds] = partsOf(ms);
    return [
      ['cmi.score.min', '0'],
      ['cmi.score.max', '100'],
      ['cmi.score.raw', percent(report)],
      ['cmi.score.scaled', scaled(report).toFixed(4)],
      ['cmi.progress_measure', (total === 0 ? 0 : done / total).toFixed(4)],
      ['cmi.completion_status', complete ? 'completed' : 'incomplete'],
      ['cmi.success_status', complete ? (passed ? 'passed' : 'failed') : 'unknown'],
      ['cmi.location', String(place)],
      ['cmi.suspend_data', state],
      ['cmi.exit', 'suspend'],
      ['cmi.session_time', `PT${hours}H${minutes}M${seconds}S`],
    ];
  },
  answer: ({ id, about, attempt, response, expected, right, causes }, { stamp }) => [
    ['id', id],
    ['type', 'long-fill-in'],
    ['timestamp', stamp()],
    // Some systems take a comma for the end of a pattern.
    ['correct_responses.0.pattern', cut(expected, 4000).replaceAll(',', ';')],
    ['learner_response', cut(response, 4000)],
    ['result', right ? 'correct' : 'incorrect'],
    [
      'description',
      cut([`${about}, try ${attempt}`, ...causes].join('; ').replaceAll(/[{}]/g, ' '), 250),
    ],
  ],
};

/** Most answers that wait: a course system may take none at all. */
const MOST_WAITING = 30;

/** The object of a course system: strings in, strings out, of which some make booleans. */
export type ScormApi = Readonly<Record<string, unknown>>;

/** Begins a session; words on why there is none. */
export function connectScorm(
  version: ScormVersion,
  api: ScormApi,
  env: Environment,
): Connection | string {
  const { names } = version;
  const call = (name: keyof typeof names, ...given: string[]): string => {
    const method = api[names[name]];
    if (typeof method !== 'function') throw new TypeError(`it has no ${names[name]}`);
    return String(method.apply(api, given));
  };
  const isTrue = (said: string): boolean => said === 'true' || said === '1';
  const whyNot = (): string => {
    const code = call('error');
    return `error ${code}${code === '0' ? '' : `, ${call('words', code)}`}`;
  };
  /** Runs a call on the system's side, which may throw anything. */
  const guarded = (run: () => string): string => {
    try {
      return run();
    } catch (error) {
      return error instanceof Error ? error.message : String(error);
    }
  };
  const get = (element: string): string => {
    const found = call('get', element);
    return found === 'null' || found === 'undefined' ? '' : found;
  };
  const begun = env.now();
  let ended = false;
  let state = { learner: '', state: '', place: 0, complete: false, readOnly: false };
  const problem = guarded(() => {
    if (!isTrue(call('start', ''))) return whyNot();
    const status = get(version.status);
    const mode = get(version.mode);
    state = {
      learner: get(version.learner).trim(),
      state: get('cmi.suspend_data'),
      place: Math.max(0, Math.trunc(Number(get(version.place))) || 0),
      complete: version.complete.includes(status),
      readOnly: mode === 'review' || mode === 'browse',
    };
    return '';
  });
  if (problem) return problem;
  let answers = 0;
  /** Answers that were not taken yet, the oldest first. */
  let waiting: readonly Answered[] = [];
  const put = (report: CourseReport): string => {
    let refused = '';
    const set = (element: string, value: string): boolean => {
      const isTaken = isTrue(call('set', element, value));
      if (!isTaken) refused ||= `${element}: ${whyNot()}`;
      return isTaken;
    };
    for (const [element, value] of version.report(report, env.now() - begun)) {
      set(element, value);
    }
    for (const answered of waiting) {
      const count = Number(get('cmi.interactions._count'));
      const n = Number.isSafeInteger(count) && count >= answers ? count : answers;
      const taken = version
        .answer(answered, env)
        .map(([name, value]) => set(`cmi.interactions.${n}.${name}`, value));
      // Without its first element, the id, there is no interaction.
      if (!taken[0]) break;
      waiting = waiting.filter((one) => one !== answered);
      answers = n + 1;
    }
    return isTrue(call('commit', '')) ? refused : refused || whyNot();
  };
  return {
    ...state,
    most: version.most,
    async send(report, answered) {
      if (ended || state.readOnly) return '';
      if (answered) waiting = [...waiting, answered].slice(-MOST_WAITING);
      return guarded(() => put(report));
    },
    end(report) {
      if (ended) return;
      if (!state.readOnly) guarded(() => put(report));
      ended = true;
      guarded(() => call('finish', ''));
    },
  };
}
