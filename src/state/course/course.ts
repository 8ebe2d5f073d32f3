import type { Posed } from '../../check/compose.ts';
import type { Judged } from '../../check/judge.ts';
import { askedAt, type Progress } from '../../check/progress.ts';
import { plan } from '../../check/session.ts';
import { isSet } from '../../check/sets.ts';
import { ABSENT, type Answer, type Field } from '../../check/types.ts';
import { definitionOf } from '../../math/shapes.ts';
import { shortest } from '../../text/format.ts';
import { handInCode, handInOf } from '../hand-in.ts';

/* A question set in a course system: the data in its package, and the reports to the system. */

/** The data of a package, which its page holds as JSON. */
export interface Course {
  /** Id of an entry of COURSE_SYSTEMS. */
  readonly system: string;
  readonly set: string;
  readonly seed: number;
  /** Whether each student has own numbers, by the id that the course system has for them. */
  readonly own: boolean;
  /** Percent of right questions from which the set is passed. */
  readonly pass: number;
  /** An IRI of the set, for statements. */
  readonly activity: string;
}

/** The element of a package's page that holds its course as JSON. */
export const COURSE_ELEMENT = 'graze-course';

/** The course of a package's page; null for any other text. */
export function readCourse(text: string | null | undefined): Course | null {
  let value: unknown;
  try {
    value = JSON.parse(text ?? '');
  } catch {
    return null;
  }
  if (typeof value !== 'object' || value === null) return null;
  const { system, set, seed, own, pass, activity } = value as Partial<Course>;
  if (typeof system !== 'string' || typeof set !== 'string' || !isSet(set)) return null;
  if (!Number.isSafeInteger(seed) || typeof pass !== 'number' || typeof activity !== 'string') {
    return null;
  }
  return { system, set, seed: seed as number, own: own === true, pass, activity };
}

/** The state of a session, as it is reported to a course system. */
export interface CourseReport {
  readonly right: number;
  readonly total: number;
  /** Questions that were solved, or whose solution was read. */
  readonly done: number;
  /** Nothing is left to do, or it was handed in. */
  readonly complete: boolean;
  readonly passed: boolean;
  /** The session as text, from which it is restored. */
  readonly state: string;
  /** Index of the question that is shown. */
  readonly place: number;
}

/** Share of right questions, from 0 to 1. */
export const scaled = ({ right, total }: CourseReport): number => (total === 0 ? 0 : right / total);

/**
 * The report of a session.
 *
 * @param most characters of its state
 */
export function courseReport(
  { seed, pass }: Course,
  progress: Progress,
  at: {
    readonly who: string;
    readonly place: number;
    readonly handedIn: boolean;
    readonly most: number;
  },
): CourseReport {
  const asked = plan(progress.seed, progress.set).map((_, i) => askedAt(progress, i));
  const right = asked.filter(({ solvedAt }) => solvedAt !== null).length;
  const done = asked.filter(({ solvedAt, solutionShown: read }) => read || solvedAt !== null);
  return {
    ...{ right, total: asked.length, done: done.length, place: at.place },
    complete: at.handedIn || done.length === asked.length,
    passed: 100 * right >= pass * asked.length,
    state: stateOf(progress, seed, at.who, at.most),
  };
}

/** The hand-in code of at most `most` characters: without typed texts if it is too long. */
function stateOf(progress: Progress, seed: number, who: string, most: number): string {
  const handIn = handInOf(progress, seed, who);
  const keeping = (keeps: (solvedAt: number | null) => boolean): string =>
    handInCode({
      ...handIn,
      asked: handIn.asked.map((one) => (keeps(one.solvedAt) ? one : { ...one, texts: {} })),
    });
  const codes = [() => true, (solvedAt: number | null) => solvedAt === null, () => false];
  return codes.map(keeping).find(({ length }) => length <= most) ?? '';
}

/** One answer, as it was judged. */
export interface Answered {
  /** q3-roots */
  readonly id: string;
  readonly about: string;
  /** Of this question, from 1. */
  readonly attempt: number;
  /** t₁ = 2; t₂ = 7/2 */
  readonly response: string;
  readonly expected: string;
  readonly right: boolean;
  /** Ids of the misconceptions that were named. */
  readonly causes: readonly string[];
}

const line = ({ label, kind }: Field, text: string): string =>
  `${label}${kind === 'choice' ? ': ' : ' = '}${text}`;

/** A judged answer; null for one that is no try. */
export function answeredOf(
  posed: Posed,
  index: number,
  progress: Progress,
  { verdict, causes }: Judged,
): Answered | null {
  if (verdict !== 'correct' && verdict !== 'wrong') return null;
  const { exercise, fields, truth, draft } = posed;
  const { texts, tries } = askedAt(progress, index);
  const typed = fields.map((field) => {
    const text = (texts[field.id] ?? '').trim();
    return line(field, optionOf(field, text) || '-');
  });
  return {
    id: `q${index + 1}-${exercise.id}`,
    about: `${exercise.topic}, ${definitionOf(draft.shape).title}`,
    attempt: tries,
    response: typed.join('; '),
    expected: fields.map((field) => line(field, written(field, truth[field.id]))).join('; '),
    right: verdict === 'correct',
    causes: causes.map(({ id }) => id),
  };
}

const optionOf = ({ options }: Field, id: string): string =>
  options.find((one) => one.id === id)?.title ?? id;

function written(field: Field, answer: Answer | undefined): string {
  if (answer === undefined) return ABSENT;
  if (typeof answer === 'number') return shortest(answer);
  return typeof answer === 'object' ? answer.map(shortest).join(', ') : optionOf(field, answer);
}

/** What the code for course systems needs of the browser: clocks, and random ids. */
export interface Environment {
  /** ms since any moment. */
  readonly now: () => number;
  /** 12:03:59, local */
  readonly clock: () => string;
  /** 2026-11-30T12:03:59.12Z */
  readonly stamp: () => string;
  readonly uuid: () => string;
}

/** Statements that have not reached the course system. */
interface Unsent {
  now(): readonly unknown[];
  /** Adds those statements of an earlier visit that are of this student and set. */
  restore(kept: readonly unknown[]): void;
  /** Whether statements wait, or the final outcome has not been accepted. */
  isOpen(report: CourseReport): boolean;
}

/** A session with a course system. */
export interface Connection {
  /** The system's id of the student; '' if unknown. */
  readonly learner: string;
  /** The stored state; '' for none. */
  readonly state: string;
  readonly place: number;
  /** The session was complete before. */
  readonly complete: boolean;
  /** The session is a review: the system accepts no reports. */
  readonly readOnly: boolean;
  /** Most characters of a state. */
  readonly most: number;
  /** Absent where each report is complete in itself. */
  readonly unsent?: Unsent;
  /** Resolves to why the report was refused; '' if it was accepted. */
  send(report: CourseReport, answered: Answered | null): Promise<string>;
  /** The page is left. */
  end(report: CourseReport): void;
}
