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
import type { CourseSession, PartContext } from './part.ts';
import { findApi } from './scorm-window.ts';
import { LONGEST_NAME } from './settings.ts';
import { SURROUNDINGS } from './surroundings.ts';

/** What could not be handed over, until it is taken. */
const UNTAKEN = 'graze.check.course';

interface Untold {
  /** The student's id. */
  readonly learner: string;
  /** '' where it was taken. */
  readonly state: string;
  readonly statements: readonly unknown[];
}

/** Most students of whom something is kept on a device, the latest. */
const MOST_STUDENTS = 20;

/** ms after which a record store that says nothing does not answer. */
const PATIENCE = 30_000;

/** Takes up the session of a package's set where the course system has it. */
export async function joinCourse(
  course: Course,
  { memory, set, changed }: PartContext,
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
  let untold = false;
  let ended = false;
  let problem = '';
  const open = (): void =>
    set({ part: 'questions', set: course.set, seed: course.seed, who, question: place });
  if (connection) {
    const kept = untoldOf(learner);
    connection.unsent?.restore(kept.statements);
    latest =
      sessionIn(kept.state, course, who) ?? sessionIn(connection.state, course, who) ?? latest;
    const { total } = reportNow(connection);
    place = Math.min(connection.place, Math.max(0, total - 1));
    memory.keep(latest);
    open();
  }
  function reportNow({ most }: Connection): CourseReport {
    return courseReport(course, latest, { who, place, handedIn, most });
  }
  const tell = async (answered: Answered | null): Promise<void> => {
    if (!connection || ended || connection.readOnly) return;
    untold = false;
    const report = reportNow(connection);
    problem = await connection.send(report, answered);
    keep(problem ? report.state : '');
    changed();
  };
  const waiting = (): readonly unknown[] => connection?.unsent?.now() ?? [];
  const untakenNow = () => {
    const { length: count } = waiting();
    return { count, isKept: untoldOf(learner).statements.length === count };
  };
  const keep = (state: string): void => keepUntold({ learner, state, statements: waiting() });
  if (connection) {
    if (connection.unsent?.isOpen(reportNow(connection))) void tell(null);
    document.addEventListener('visibilitychange', () => {
      if (document.visibilityState === 'hidden' && untold) void tell(null);
    });
    window.addEventListener('pagehide', () => {
      if (ended) return;
      connection.end(reportNow(connection));
      ended = true;
      // Whether it takes them will not be heard.
      if (waiting().length > 0) keep(untoldOf(learner).state);
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
      else untold = true;
    },
    changed(progress, index, now) {
      if (!isOf(progress)) return;
      [latest, place] = [progress, index];
      if (now) void tell(null);
      else untold = true;
    },
    box: (progress) =>
      courseBox(
        {
          name: system?.name ?? course.system,
          why: typeof found === 'string' ? found : '',
          isShown: isOf(progress),
          readOnly: connection?.readOnly === true,
          report: connection && reportNow(connection),
          ...{ pass: course.pass, problem, untaken: untakenNow() },
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
    // A course system may have kept half of it, or that of another page.
    return null;
  }
}

function allUntold(): readonly Untold[] {
  try {
    const all: unknown = JSON.parse(recall(UNTAKEN) || '[]');
    return Array.isArray(all) ? all.flatMap(readUntold) : [];
  } catch {
    return [];
  }
}

function readUntold(value: unknown): Untold[] {
  const { learner, state, statements } = (value ?? {}) as Partial<Untold>;
  if (typeof learner !== 'string' || typeof state !== 'string') return [];
  return [{ learner, state, statements: Array.isArray(statements) ? statements : [] }];
}

const untoldOf = (learner: string): Untold =>
  allUntold().find((one) => one.learner === learner) ?? { learner, state: '', statements: [] };

/** Keeps it for the student's next visit on this device. */
function keepUntold(own: Untold): void {
  const before = allUntold();
  const isEmpty = own.state === '' && own.statements.length === 0;
  const others = before.filter(({ learner }) => learner !== own.learner);
  if (isEmpty && others.length === before.length) return;
  const all = isEmpty ? others : [...others, own].slice(-MOST_STUDENTS);
  remember(UNTAKEN, JSON.stringify(all));
}

async function connect(
  course: Course,
  system: CourseSystem | undefined,
): Promise<Connection | string> {
  if (!system) return `this page does not know how to speak with ${course.system}`;
  if (!system.scorm) {
    const launch = readLaunch(location.search, course);
    return typeof launch === 'string' ? launch : connectXapi(launch, request, SURROUNDINGS);
  }
  const { api, blocked } = findApi(system.scorm.api, window);
  if (api) return connectScorm(system.scorm, api, SURROUNDINGS);
  return blocked
    ? 'the windows around this page are out of its reach (a sandbox, or another address)'
    : 'there is none in the windows around this page';
}

const request: Request = async (url, { method, headers, body, last }) => {
  const response = await fetch(url, {
    ...{ method, headers, keepalive: last, credentials: 'omit', cache: 'no-store' },
    signal: AbortSignal.timeout(PATIENCE),
    ...(body === null ? {} : { body }),
  });
  return { status: response.status, text: await response.text() };
};
