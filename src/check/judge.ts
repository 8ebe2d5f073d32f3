import { causesOf } from './causes.ts';
import { type AnswerKey, before, fits, type WrittenLine, wayBy } from './derivation.ts';
import { compared, grade, type Mark, readAnswer, roughly, type Texts } from './grade.ts';
import type { Misconception } from './misconceptions/define.ts';
import { ABSENT, type Answers, type Field } from './types.ts';
import { WAYS, type Way } from './ways.ts';

export interface Judged {
  readonly marks: Readonly<Record<string, Mark>>;
  /** The misconceptions that together give exactly these answers; empty if none do. */
  readonly causes: readonly Misconception[];
  /**
   * Wrong fields that are right for the student's own earlier values; each with the wrong fields
   * that it follows from.
   */
  readonly follow: Readonly<Record<string, readonly Field[]>>;
  /** Another way than the course's, by which the fields are marked; null for the course's. */
  readonly way: Way | null;
  readonly verdict: 'correct' | 'rounded' | 'wrong' | 'invalid';
}

/** Marks every field by itself and by those before it, and finds misconceptions behind all. */
export function judge(derivation: AnswerKey, texts: Texts): Judged {
  const { fields } = derivation;
  const textOf = ({ id }: Field): string => texts[id] ?? '';
  // An empty box means "does not exist" only if all other fields are answered.
  const complete = fields.every((field) => readAnswer(field, textOf(field)).ok);
  const isOpen = (field: Field): boolean => !complete && textOf(field).trim() === '';
  const lines = fields.flatMap((field): WrittenLine[] => {
    const read = readAnswer(field, textOf(field));
    return read.ok && !isOpen(field) ? [{ field, given: read.given }] : [];
  });
  const found = bestOf(derivation, lines);
  const truth = derivation.truth(found.course);
  const marks: Record<string, Mark> = {};
  const follow: Record<string, readonly Field[]> = {};
  for (const field of fields) {
    const mark: Mark = isOpen(field)
      ? { verdict: 'invalid', reason: 'not answered' }
      : grade(field, textOf(field), truth[field.id]);
    marks[field.id] = mark;
    const at = lines.findIndex((line) => line.field === field);
    if (mark.verdict === 'wrong' && found.standing[at] === 'follows') {
      follow[field.id] = sources(derivation, found, lines, at, marks);
    }
  }
  const wrong = found.standing.includes('wrong');
  return {
    marks,
    causes: wrong ? causesOf(derivation, found.course, lines) : [],
    follow,
    way: found.way,
    verdict: verdictOf(wrong, Object.values(marks)),
  };
}

/**
 * The verdict on all marks. If no field is wrong by itself, one that follows from another follows
 * from a value with too few digits: 'rounded'.
 */
function verdictOf(wrong: boolean, marks: readonly Mark[]): Judged['verdict'] {
  const some = (verdict: Mark['verdict']): boolean =>
    marks.some((mark) => mark.verdict === verdict);
  if (wrong) return 'wrong';
  if (some('invalid')) return 'invalid';
  return some('rounded') || some('wrong') ? 'rounded' : 'correct';
}

type Standing = 'right' | 'follows' | 'wrong';

interface Comparison {
  readonly course: AnswerKey['course'];
  readonly way: Way | null;
  readonly standing: readonly Standing[];
}

const wrongIn = ({ standing }: Comparison): number => standing.filter((s) => s === 'wrong').length;

/** The course, or the way by which the fewest lines are wrong, if those are fewer. */
function bestOf(derivation: AnswerKey, lines: readonly WrittenLine[]): Comparison {
  const plain = foundBy(derivation, lines, derivation.course, null);
  if (wrongIn(plain) === 0) return plain;
  const typed: Answers = Object.fromEntries(
    lines.map(({ field, given }) => [field.id, given.value]),
  );
  const first = plain.standing.indexOf('wrong');
  let best = plain;
  for (const way of WAYS) {
    const course = wayBy(derivation, way, typed);
    if (!course || !fits(derivation, course, lines, first)) continue;
    const found = foundBy(derivation, lines, course, way);
    const evidence = lines.filter(
      (_, i) => fits(derivation, course, lines, i) && !isByCourse(derivation, lines, i),
    ).length;
    if (evidence >= way.evidence && wrongIn(found) < wrongIn(best)) best = found;
  }
  return best;
}

/** Whether the course's own formula gives this line from the lines before it. */
function isByCourse(derivation: AnswerKey, lines: readonly WrittenLine[], i: number): boolean {
  const line = lines[i];
  if (!line) return false;
  const expected = derivation.next(derivation.course, before(lines, i))[line.field.id];
  return compared(line.field, line.given, expected) === 'correct';
}

function foundBy(
  derivation: AnswerKey,
  lines: readonly WrittenLine[],
  course: AnswerKey['course'],
  way: Way | null,
): Comparison {
  const truth = derivation.truth(course);
  const standing = lines.map(({ field, given }, i): Standing => {
    if (roughly(field, given, truth[field.id])) return 'right';
    if (i === 0) return 'wrong';
    const expected = derivation.next(course, before(lines, i))[field.id];
    return roughly(field, given, expected) ? 'follows' : 'wrong';
  });
  return { course, way, standing };
}

/** The wrong fields that a line follows from: with their right values it would be another one. */
function sources(
  derivation: AnswerKey,
  { course, standing }: Comparison,
  lines: readonly WrittenLine[],
  at: number,
  marks: Judged['marks'],
): Field[] {
  const own = before(lines, at);
  const truth = derivation.truth(course);
  const id = lines[at]?.field.id ?? '';
  const value = JSON.stringify(derivation.next(course, own)[id]);
  const found = lines.slice(0, at).flatMap(({ field }, i): Field[] => {
    const mark = marks[field.id];
    if (!mark || mark.verdict === 'correct') return [];
    const right = { ...own, [field.id]: truth[field.id] ?? ABSENT };
    if (JSON.stringify(derivation.next(course, right)[id]) === value) return [];
    return standing[i] === 'follows'
      ? sources(derivation, { course, standing, way: null }, lines, i, marks)
      : [field];
  });
  return [...new Set(found)];
}
