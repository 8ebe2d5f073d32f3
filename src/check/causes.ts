import type { Course } from './course.ts';
import { type AnswerKey, fits, mistakesIn, type WrittenLine } from './derivation.ts';
import type { Misconception } from './misconceptions/define.ts';

/** Most mistakes in one explanation: three together could explain nearly any answer. */
const MOST = 2;

type Mistakes = readonly Misconception[];

/**
 * The smallest set of mistakes that together give every line, wrong and right ones, each computed
 * from the start or from the student's own earlier lines. Empty if there is none, or if several
 * sets explain the lines equally well.
 */
export function causesOf(
  derivation: AnswerKey,
  course: Course,
  lines: readonly WrittenLine[],
): Mistakes {
  for (let count = 1; count <= MOST; count++) {
    const found = search(derivation, course, lines, count, []);
    if (found.length > 0) return only(found, derivation, lines);
  }
  return [];
}

function search(
  derivation: AnswerKey,
  course: Course,
  lines: readonly WrittenLine[],
  left: number,
  made: Mistakes,
): Mistakes[] {
  const open = lines.findIndex((_, i) => !fits(derivation, course, lines, i));
  if (open < 0) return made.length > 0 ? [made] : [];
  if (left === 0) return [];
  const found = [...mistakesIn(course)].flatMap(([mistake, edited]) =>
    !made.includes(mistake) && fitsUpTo(derivation, edited, lines, open)
      ? search(derivation, edited, lines, left - 1, [...made, mistake])
      : [],
  );
  return found;
}

/** Whether these formulas give all lines up to `last`. */
function fitsUpTo(
  derivation: AnswerKey,
  course: Course,
  lines: readonly WrittenLine[],
  last: number,
): boolean {
  for (let i = 0; i <= last; i++) if (!fits(derivation, course, lines, i)) return false;
  return true;
}

/**
 * The only set; of several the only one that the question watches for, else the only one whose
 * mistakes are in lines that the student filled in; else none.
 */
function only(
  found: readonly Mistakes[],
  { watch }: AnswerKey,
  lines: readonly WrittenLine[],
): Mistakes {
  const shown = new Set(lines.map(({ field }) => lineOf(field.id)));
  const wishes: readonly ((mistake: Misconception) => boolean)[] = [
    () => true,
    ({ id }) => watch.includes(id),
    ({ line }) => shown.has(line),
  ];
  for (const wish of wishes) {
    const [one, ...others] = found.filter((mistakes) => mistakes.every(wish));
    if (one && others.every((other) => sameSet(one, other))) return one;
  }
  return [];
}

const sameSet = (a: Mistakes, b: Mistakes): boolean =>
  a.length === b.length && a.every((mistake) => b.includes(mistake));

/** The line of the derivation that a field belongs to: t for t1 and t2. */
const lineOf = (id: string): string => id.replace(/[12]$/, '');
