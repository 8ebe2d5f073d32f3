import { type ReadLesson, readLesson } from '../read.ts';
import digits from './digits.md?raw';
import discriminant from './discriminant.md?raw';
import effects from './effects.md?raw';
import noSquare from './no-square.md?raw';
import normal from './normal.md?raw';
import ray from './ray.md?raw';
import tornEdge from './torn-edge.md?raw';

/** Texts of the lessons that come with Graze, by id, in the order of the list. */
const TEXTS: Readonly<Record<string, string>> = {
  ray,
  discriminant,
  normal,
  'no-square': noSquare,
  digits,
  'torn-edge': tornEdge,
  effects,
};

const known = new Map<string, ReadLesson>();

export const LESSON_IDS: readonly string[] = Object.keys(TEXTS);

/** The text of the lesson with this id; null if there is none. */
const lessonText = (id: string): string | null =>
  Object.hasOwn(TEXTS, id) ? (TEXTS[id] ?? null) : null;

/** A lesson that comes with Graze. */
export function lessonOf(id: string): ReadLesson | null {
  const text = lessonText(id);
  if (text === null) return null;
  const found = known.get(id) ?? readLesson(text, id);
  known.set(id, found);
  return found;
}
