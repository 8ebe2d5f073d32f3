import { type Lesson, OWN, type Step, stepAt } from '../../lesson/lesson.ts';
import { LESSON_IDS, lessonOf } from '../../lesson/lessons/index.ts';
import { type ReadLesson, readLesson } from '../../lesson/read.ts';
import { innerState, LESSON_KEYS } from '../../lesson/step-state.ts';
import { InvalidInput } from '../../math/index.ts';
import { quote } from '../../math/shapes.ts';
import type { Settings } from '../../state/state.ts';
import type { Readable } from '../page.ts';
import { ownText } from './own-lesson.ts';

let last: { text: string; read: ReadLesson } | null = null;

/** The own lesson; cached while its text is the same. */
function ownLesson(settings: Settings): ReadLesson | null {
  const text = ownText(settings);
  if (text === null) return null;
  if (last?.text !== text) last = { text, read: readLesson(text, OWN) };
  return last.read;
}

export interface LessonStep {
  readonly lesson: Lesson;
  readonly number: number;
  readonly step: Step;
}

/** The lesson and the step that settings name; null for the list of lessons. */
export function lessonStepOf(settings: Settings): LessonStep | null {
  const lesson = safely(settings)?.lesson;
  if (!lesson) return null;
  const number = stepAt(lesson, settings.step);
  const step = lesson.steps[number - 1];
  return step ? { lesson, number, step } : null;
}

function safely(settings: Settings): ReadLesson | null {
  const { id } = settings;
  if (id === undefined) return null;
  try {
    return id === OWN ? ownLesson(settings) : lessonOf(id);
  } catch (error) {
    if (error instanceof InvalidInput) return null;
    throw error;
  }
}

/** The valid settings of a link, and what is wrong with the others. */
export function readSettings(given: Settings): Readable {
  const problems = problemsOf(given);
  const place = lessonStepOf(given);
  if (!place) return { settings: {}, problems };
  const settings = { ...given };
  if (given.step !== undefined && given.step !== String(place.number)) {
    problems.push(`there is no step ${quote(given.step)}: ${place.number} is shown`);
    settings.step = String(place.number);
  }
  for (const key of Object.keys(given)) {
    if (LESSON_KEYS.some((own) => own === key)) continue;
    const { problems: found, page } = innerState(place.step, { [key]: given[key] ?? '' });
    // Another page judges its own keys when it is shown.
    if (page !== 'explore' || found.length === 0) continue;
    problems.push(...found);
    delete settings[key];
  }
  return { settings, problems };
}

function problemsOf(given: Settings): string[] {
  const { id } = given;
  if (id === undefined) return [];
  if (id !== OWN) {
    return LESSON_IDS.includes(id) ? [] : [`there is no lesson ${quote(id.slice(0, 40))}`];
  }
  try {
    const own = ownLesson(given);
    return own ? [...own.problems] : ['there is no lesson of your own on this device yet'];
  } catch (error) {
    if (error instanceof InvalidInput) return [error.message];
    throw error;
  }
}
