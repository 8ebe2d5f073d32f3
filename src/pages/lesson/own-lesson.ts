import { OWN } from '../../lesson/lesson.ts';
import { isLesson, LONGEST_LESSON, readLesson } from '../../lesson/read.ts';
import { firstText, newStep } from '../../lesson/write.ts';
import { quote } from '../../math/shapes.ts';
import { packed, unpacked } from '../../state/packed-text.ts';
import type { AppState, Settings } from '../../state/state.ts';
import { recall, remember } from '../../ui/storage.ts';

/*
 * The own lesson. Its packed text is in the link, so that a link can be sent; the browser's storage
 * keeps the latest text.
 */

const KEPT = 'graze.lesson';

/** UTF-8 needs up to four bytes a character. */
const MOST_BYTES = 4 * LONGEST_LESSON;

/** The text in the link, else the stored one. Throws InvalidInput if it cannot be unpacked. */
export function ownText(settings: Settings): string | null {
  const { file } = settings;
  return file === undefined ? recall(KEPT) : unpacked(file, 'lesson', MOST_BYTES);
}

/** The settings of a lesson of one's own with this text. */
export function ownSettings(text: string, step: number): Settings {
  remember(KEPT, text);
  const rest = step === 1 ? {} : { step: String(step) };
  return { id: OWN, ...rest, file: packed(text) };
}

/** The text with another step at its end. */
export function collected(text: string | null, link: string): { text: string; step: number } {
  if (text === null) return { text: firstText(link), step: 1 };
  const step = readLesson(text, OWN).lesson.steps.length + 1;
  return { text: `${text.trimEnd()}\n\n${newStep(`Step ${step}`, link)}\n`, step };
}

/** The state with a link added as the next step of the own lesson. */
export function withCollected(state: AppState, link: string): { state: AppState; step: number } {
  const { lesson } = state.settings;
  let before: string | null;
  try {
    before = lesson.id === OWN ? ownText(lesson) : recall(KEPT);
  } catch {
    before = recall(KEPT);
  }
  const { text, step } = collected(before, link);
  const settings = { ...state.settings, lesson: ownSettings(text, step) };
  return { state: { ...state, settings }, step };
}

/** The state that shows the lesson of a file. Throws with what is wrong with another file. */
export function openedLesson(state: AppState, text: string): AppState {
  if (!isLesson(text)) {
    const begins = quote(text.trim().split('\n', 1)[0]);
    const wanted = 'a lesson begins with its title between two lines of three dashes';
    return { ...state, problems: [`a file that begins with ${begins} is no lesson: ${wanted}`] };
  }
  const settings = { ...state.settings, lesson: ownSettings(text, 1) };
  return { ...state, page: 'lesson', settings, problems: [] };
}
