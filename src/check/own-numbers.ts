import { courseOf } from './course.ts';
import { derivationOf } from './derivation.ts';
import { INSIDE } from './exercises/flat.ts';
import { type Mark, roundedWords, type Texts } from './grade.ts';
import { type Judged, judge } from './judge.ts';
import type { Misconception } from './misconceptions/define.ts';
import {
  ABSENT,
  type Answers,
  choiceField,
  directionField,
  type Field,
  type Input,
  mayBeAbsent,
  numberField,
  tripleField,
} from './types.ts';
import type { Way } from './ways.ts';
import { work } from './work.ts';

export interface OwnLine {
  readonly field: Field;
  /**
   * 'absent': rightly said not to exist. 'follows': wrong, but right for the student's own earlier
   * values.
   */
  readonly verdict: 'correct' | 'rounded' | 'wrong' | 'follows' | 'absent' | 'invalid';
  /** Words on why it is wrong or cannot be read; '' for none. */
  readonly note: string;
}

export interface OwnReport {
  readonly lines: readonly OwnLine[];
  /** The first line that is wrong by itself. */
  readonly firstWrong: Field | null;
  /** The misconceptions that together give all lines. */
  readonly causes: readonly Misconception[];
  /** Another way than the course's, by which the lines are marked; null for the course's. */
  readonly way: Way | null;
  /** "B is wrong; your t₁ and t₂ are right for your B." */
  readonly says: string;
}

const CURVED: readonly Field[] = [
  ...['A', 'B', 'C', 'D'].map((id) => numberField(id)),
  numberField('t1', 't₁'),
  numberField('t2', 't₂'),
  tripleField('P1', 'P₁'),
  tripleField('P2', 'P₂'),
  directionField('N1', 'N₁'),
  directionField('N2', 'N₂'),
].map(mayBeAbsent);

const FLAT: readonly Field[] = [
  numberField('N.(E-P)', 'N·(E − P)'),
  numberField('N.d', 'N·d'),
  numberField('t1', 't'),
  tripleField('P1', 'P'),
].map(mayBeAbsent);

const FIGURE: readonly Field[] = [...FLAT, choiceField('inside', 'the point is', INSIDE)];

/** The fields for this shape, in the order of the derivation. */
export function ownFields({ shape }: Input): readonly Field[] {
  const course = courseOf(shape);
  if (course.family === 'curved') return CURVED;
  return course.conditions.length > 0 ? FIGURE : FLAT;
}

/**
 * Marks each line that was typed and finds the first wrong one. A line is right if it is right for
 * the numbers as typed or for the doubles that store them.
 */
export function checkOwn(input: Input, texts: Texts): OwnReport {
  const { shape, ray } = input;
  const stored = markedBy({ shape, ray }, texts);
  return input.typed ? better(stored, markedBy(input, texts)) : reportOf(stored);
}

interface Marked {
  readonly lines: readonly OwnLine[];
  readonly judged: Judged;
}

function markedBy(input: Input, texts: Texts): Marked {
  const course = courseOf(input.shape);
  const typed = ownFields(input).filter(({ id }) => (texts[id] ?? '').trim() !== '');
  const derivation = derivationOf(typed, course, [], (edited, own) => work(edited, input, own));
  const judged = judge(derivation, texts);
  const truth = derivation.truth(course);
  const lines = typed.flatMap((field): OwnLine[] => {
    const mark = judged.marks[field.id];
    return mark ? [lineOf(field, mark, judged, truth)] : [];
  });
  return { lines, judged };
}

function reportOf({ lines, judged }: Marked, aside = ''): OwnReport {
  const firstWrong = lines.find(({ verdict }) => verdict === 'wrong')?.field ?? null;
  const { causes, way } = judged;
  const says = [sentence(lines, judged, firstWrong), aside].filter(Boolean).join(' ');
  return { lines, firstWrong, causes, way, says };
}

/**
 * The report of stored or typed numbers that has fewer wrong lines, in which lines that are right
 * by the other count as right.
 */
function better(stored: Marked, typed: Marked): OwnReport {
  const faults = ({ lines }: Marked): number =>
    lines.filter((line) => line.verdict === 'wrong' || line.verdict === 'follows').length;
  const [best, other] = faults(typed) < faults(stored) ? [typed, stored] : [stored, typed];
  const lines = best.lines.map((line, i) => {
    const second = other.lines[i];
    return line.verdict === 'wrong' && second && isRight(second) ? second : line;
  });
  const rescued = lines.some((line, i) => line !== best.lines[i]);
  // A misconception that explains a line that is right after all is dropped.
  const judged = rescued ? { ...best.judged, causes: [] } : best.judged;
  const only = (by: Marked, others: Marked): Field[] =>
    lines.flatMap(({ field }, i) => {
      const [one, two] = [by.lines[i], others.lines[i]];
      return one && two && isRight(one) && !isRight(two) ? [field] : [];
    });
  const [asTyped, asStored] = [only(typed, stored), only(stored, typed)];
  const aside = [
    ...said(asTyped, 'the numbers as typed, not for the doubles that store them'),
    ...said(asStored, 'the doubles that store the numbers, not for the numbers as typed'),
  ];
  return reportOf({ lines, judged }, aside.join(' '));
}

const isRight = ({ verdict }: OwnLine): boolean => verdict === 'correct' || verdict === 'absent';

const said = (fields: readonly Field[], forWhat: string): string[] =>
  fields.length > 0 ? [`${capital(listed(fields))} ${be(fields)} right for ${forWhat}.`] : [];

const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

function lineOf(field: Field, mark: Mark, { follow }: Judged, truth: Answers): OwnLine {
  if (mark.verdict === 'invalid') return { field, verdict: 'invalid', note: mark.reason };
  const isAbsent = mark.value === ABSENT;
  if (mark.verdict === 'correct') {
    return { field, verdict: isAbsent ? 'absent' : 'correct', note: '' };
  }
  if (mark.verdict === 'rounded') {
    return { field, verdict: 'rounded', note: roundedWords(mark.digits) };
  }
  if (follow[field.id]) return { field, verdict: 'follows', note: '' };
  const exists = truth[field.id] !== undefined;
  return {
    field,
    verdict: 'wrong',
    note: isAbsent ? 'it exists' : exists ? '' : 'it does not exist',
  };
}

function sentence(lines: readonly OwnLine[], { follow }: Judged, firstWrong: Field | null): string {
  if (lines.length === 0) return 'Nothing typed yet: fill in as much as you have.';
  const which = (verdict: OwnLine['verdict']): Field[] =>
    lines.filter((line) => line.verdict === verdict).map(({ field }) => field);
  const unread = which('invalid');
  const rounded = which('rounded');
  const aside = [
    ...(rounded.length > 0
      ? [
          `${listed(rounded)} ${be(rounded)} right as far as ` +
            `${rounded.length > 1 ? 'they go' : 'it goes'}: give more digits.`,
        ]
      : []),
    ...(unread.length > 0 ? [`${listed(unread)} could not be read.`] : []),
  ];
  return [
    verdict(lines, which('wrong'), firstWrong, aside.length),
    ...followed(which('follows'), follow),
    ...aside,
  ]
    .filter(Boolean)
    .join(' ');
}

function verdict(
  lines: readonly OwnLine[],
  wrong: readonly Field[],
  firstWrong: Field | null,
  asides: number,
): string {
  if (firstWrong) {
    return `${listed(wrong)} ${be(wrong)} wrong; the first wrong step is ${firstWrong.name}.`;
  }
  const some = (...verdicts: OwnLine['verdict'][]) =>
    lines.some(({ verdict }) => verdicts.includes(verdict));
  if (asides === 0 && !some('follows')) return 'All that you typed is right.';
  if (!some('correct', 'absent')) return '';
  return some('invalid') ? 'Nothing that could be read is wrong.' : 'Nothing of it is wrong.';
}

/** "Your t₁ and t₂ are right for your B.", once for each set of earlier lines. */
function followed(fields: readonly Field[], follow: Judged['follow']): string[] {
  const groups = new Map<string, Field[]>();
  for (const field of fields) {
    const from = listed(follow[field.id] ?? []);
    groups.set(from, [...(groups.get(from) ?? []), field]);
  }
  return [...groups].map(
    ([from, some]) =>
      `Your ${listed(some)} ${be(some)} right for your ${from || 'earlier values'}.`,
  );
}

const be = (fields: readonly Field[]): string => (fields.length > 1 ? 'are' : 'is');

function listed(fields: readonly Field[]): string {
  const names = fields.map(({ name }) => name);
  return names.length < 2
    ? (names[0] ?? '')
    : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`;
}
