import { type Progress, started } from '../../check/progress.ts';
import { studentSeed } from '../../check/session.ts';
import { courseBox } from '../../panels/check-course.ts';
import {
  type Answered,
  answeredOf,
  type Connection,
  type Course,
  type CourseReport,
  courseReport,
} from '../../state/course/course.ts';
import { connectScorm } from '../../state/course/scorm.ts';
import { COURSE_SYSTEMS, type CourseSystem } from '../../state/course/systems.ts';
import { connectXapi, type Request, readLaunch } from '../../state/course/xapi.ts';
import { readHandIn } from '../../state/hand-in.ts';
import { download } from '../../ui/files.ts';
import { recall, remember } from '../../ui/storage.ts';
import { BROWSER_ENVIRONMENT } from './browser-environment.ts';
import type { CourseSession, PartContext } from './page-parts.ts';
import { findApi } from './scorm-window.ts';
import { LONGEST_NAME } from './settings.ts';

/** Key in the browser's storage of reports that the course system has not accepted. */
const UNSENT_KEY = 'graze.check.course';

interface UnsentReport {
  /** The student's id. */
  readonly learner: string;
  /** The hand-in code; '' if it was accepted. */
  readonly state: string;
  readonly statements: readonly unknown[];
}

/** Most students whose unsent reports are kept on a device: the latest ones. */
const MOST_STUDENTS = 20;

/** ms after which a request to a record store fails. */
const ANSWER_TIMEOUT_MS = 30_000;

/** Takes up the session of a package's set where the course system has it. */
export async function joinCourse(
  course: Course,
  { storage, set, changed }: PartContext,
): Promise<CourseSession> {
  const system = COURSE_SYSTEMS.find(({ id }) => id === course.system);
  const found = await connect(course, system);
  const connection = typeof found === 'string' ? null : found;
  const who = course.own ? (connection?.learner ?? '').slice(0, LONGEST_NAME).trim() : '';
  const seed = studentSeed(course.seed, who);
  const learner = connection?.learner ?? '';
  let latest = started(seed, course.set);
  let place = 0;
  let handedIn = connection?.complete === true;
  let isUnsent = false;
  let ended = false;
  let problem = '';
  const open = (): void =>
    set({ part: 'questions', set: course.set, seed: course.seed, who, question: place });
  if (connection) {
    const kept = unsentReportOf(learner);
    connection.unsent?.restore(kept.statements);
    latest =
      sessionIn(kept.state, course, who) ?? sessionIn(connection.state, course, who) ?? latest;
    const { total } = reportNow(connection);
    place = Math.min(connection.place, Math.max(0, total - 1));
    storage.keep(latest);
    open();
  }
  function reportNow({ most }: Connection): CourseReport {
    return courseReport(course, latest, { who, place, handedIn, most });
  }
  const tell = async (answered: Answered | null): Promise<void> => {
    if (!connection || ended || connection.readOnly) return;
    isUnsent = false;
    const report = reportNow(connection);
    problem = await connection.send(report, answered);
    keep(problem ? report.state : '');
    changed();
  };
  const waiting = (): readonly unknown[] => connection?.unsent?.now() ?? [];
  const unsentNow = () => {
    const { length: count } = waiting();
    return { count, isKept: unsentReportOf(learner).statements.length === count };
  };
  const keep = (state: string): void => storeUnsent({ learner, state, statements: waiting() });
  if (connection) {
    if (connection.unsent?.isOpen(reportNow(connection))) void tell(null);
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden' && isUnsent) void tell(null);
    });
    window.addEventListener('pagehide', () => {
      if (ended) return;
      connection.end(reportNow(connection));
      ended = true;
      // The page is gone before an answer arrives, so the statements stay stored.
      if (waiting().length > 0) keep(unsentReportOf(learner).state);
    });
    // A session that has ended cannot go on: a page that comes back begins another.
    window.addEventListener('pageshow', ({ persisted }) => {
      if (persisted && ended) location.reload();
    });
  }
  const isOf = (progress: Progress): boolean =>
    connection !== null && progress.set === course.set && progress.seed === seed;
  const tools = {
    handIn() {
      handedIn = true;
      void tell(null);
    },
    again: () => void tell(null),
    save() {
      const text = `${JSON.stringify(waiting(), null, 2)}\n`;
      download(`graze-statements-${latest.seed}.json`, text, 'application/json');
    },
    back: open,
  };
  return {
    isOf,
    answered(posed, index, progress, judged) {
      if (!isOf(progress)) return;
      [latest, place] = [progress, index];
      const answered = answeredOf(posed, index, progress, judged);
      if (answered) void tell(answered);
      else isUnsent = true;
    },
    changed(progress, index, now) {
      if (!isOf(progress)) return;
      [latest, place] = [progress, index];
      if (now) void tell(null);
      else isUnsent = true;
    },
    box: (progress) =>
      courseBox(
        {
          name: system?.name ?? course.system,
          why: typeof found === 'string' ? found : '',
          isShown: isOf(progress),
          readOnly: connection?.readOnly === true,
          report: connection && reportNow(connection),
          ...{ pass: course.pass, problem, unsent: unsentNow() },
        },
        tools,
      ),
  };
}

/** The session of a state, if it is one of this course and student. */
function sessionIn(code: string, course: Course, who: string): Progress | null {
  if (code === '') return null;
  try {
    const { set, seed, who: own, asked } = readHandIn(code);
    if (set !== course.set || seed !== course.seed || own !== who) return null;
    const each = asked.map((one, i) => [String(i), one] as const);
    return { seed: studentSeed(seed, who), set, asked: Object.fromEntries(each) };
  } catch {
    // The stored text may be cut, or of another page.
    return null;
  }
}

function allUnsent(): readonly UnsentReport[] {
  try {
    const all: unknown = JSON.parse(recall(UNSENT_KEY) || '[]');
    return Array.isArray(all) ? all.flatMap(readUnsent) : [];
  } catch {
    return [];
  }
}

function readUnsent(value: unknown): UnsentReport[] {
  const { learner, state, statements } = (value ?? {}) as Partial<UnsentReport>;
  if (typeof learner !== 'string' || typeof state !== 'string') return [];
  return [{ learner, state, statements: Array.isArray(statements) ? statements : [] }];
}

const unsentReportOf = (learner: string): UnsentReport =>
  allUnsent().find((one) => one.learner === learner) ?? { learner, state: '', statements: [] };

/** Keeps it for the student's next visit on this device. */
function storeUnsent(own: UnsentReport): void {
  const before = allUnsent();
  const isEmpty = own.state === '' && own.statements.length === 0;
  const others = before.filter(({ learner }) => learner !== own.learner);
  if (isEmpty && others.length === before.length) return;
  const all = isEmpty ? others : [...others, own].slice(-MOST_STUDENTS);
  remember(UNSENT_KEY, JSON.stringify(all));
}

async function connect(
  course: Course,
  system: CourseSystem | undefined,
): Promise<Connection | string> {
  if (!system) return `this page does not know how to speak with ${course.system}`;
  if (!system.scorm) {
    const launch = readLaunch(location.search, course);
    return typeof launch === 'string' ? launch : connectXapi(launch, request, BROWSER_ENVIRONMENT);
  }
  const { api, blocked } = findApi(system.scorm.api, window);
  if (api) return connectScorm(system.scorm, api, BROWSER_ENVIRONMENT);
  return blocked
    ? 'the windows around this page are out of its reach (a sandbox, or another address)'
    : 'there is none in the windows around this page';
}

const request: Request = async (url, { method, headers, body, last }) => {
  const response = await fetch(url, {
    ...{ method, headers, keepalive: last, credentials: 'omit', cache: 'no-store' },
    signal: AbortSignal.timeout(ANSWER_TIMEOUT_MS),
    ...(body === null ? {} : { body }),
  });
  return { status: response.status, text: await response.text() };
};
