import { courseOf } from './course.ts';
import { INSIDE } from './exercises/flat.ts';
import { type Mark, matches, readAnswer, type Texts } from './grade.ts';
import { judge, type Suspect } from './judge.ts';
import type { Misconception } from './misconceptions/define.ts';
import { MISCONCEPTIONS } from './misconceptions/index.ts';
import {
  type Answers,
  choiceField,
  directionField,
  type Field,
  type Input,
  numberField,
  tripleField,
} from './types.ts';
import { work } from './work.ts';

export interface OwnLine {
  readonly field: Field;
  /** 'absent': rightly said not to exist. 'follows': wrong, and right for the student's own earlier values. */
  readonly verdict: 'correct' | 'wrong' | 'follows' | 'absent' | 'invalid';
  /** Why it is wrong or unread, in a few words; '' if there is nothing to add. */
  readonly note: string;
}

export interface OwnReport {
  readonly lines: readonly OwnLine[];
  /** The first line that is wrong by itself. */
  readonly firstWrong: Field | null;
  readonly cause: Misconception | null;
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
];

const FLAT: readonly Field[] = [
  numberField('N.(E-P)', 'N·(E − P)'),
  numberField('N.d', 'N·d'),
  numberField('t1', 't'),
  tripleField('P1', 'P'),
];

const FIGURE: readonly Field[] = [...FLAT, choiceField('inside', 'the point is', INSIDE)];

/** What can be typed for this shape, in the order of the derivation. */
export function ownFields({ shape }: Input): readonly Field[] {
  const course = courseOf(shape);
  if (course.family === 'curved') return CURVED;
  return course.conditions.length > 0 ? FIGURE : FLAT;
}

/** A line may also say that its quantity does not exist. */
const SAYS_NONE = /^\s*(none|no|no root|does not exist|[-–—∅])\s*$/i;

/** Marks each line that was typed, as far as the student got, and finds the first wrong step. */
export function checkOwn(input: Input, texts: Texts): OwnReport {
  const fields = ownFields(input);
  const course = courseOf(input.shape);
  const truth = work(course, input);
  const typed = fields.filter(({ id }) => (texts[id] ?? '').trim() !== '');
  const valued = typed.filter(({ id }) => !SAYS_NONE.test(texts[id] ?? ''));
  const judged = judge(valued, texts, truth, suspectsOf(input), (own) => work(course, input, own));
  const lines = typed.map((field): OwnLine => {
    const mark = judged.marks[field.id];
    if (!mark) return saidNone(field, truth);
    return lineOf(field, mark, judged.follow.includes(field.id), truth);
  });
  const firstWrong = lines.find(({ verdict }) => verdict === 'wrong')?.field ?? null;
  const cause = judged.cause ?? (firstWrong && causeOfOne(firstWrong, texts, input));
  return { lines, firstWrong, cause, says: sentence(lines, firstWrong, typed.length) };
}

function suspectsOf(input: Input): Suspect[] {
  const course = courseOf(input.shape);
  return MISCONCEPTIONS.flatMap((misconception) => {
    const edited = misconception.edit(course);
    return edited ? [{ misconception, answers: work(edited, input) }] : [];
  });
}

function saidNone(field: Field, truth: Answers): OwnLine {
  const right = truth[field.id] === undefined;
  const note = right ? 'rightly said not to exist' : 'it exists';
  return { field, verdict: right ? 'absent' : 'wrong', note };
}

function lineOf(field: Field, mark: Mark, follows: boolean, truth: Answers): OwnLine {
  if (mark.verdict === 'invalid') return { field, verdict: 'invalid', note: mark.reason };
  if (mark.verdict === 'correct') return { field, verdict: 'correct', note: '' };
  if (follows) return { field, verdict: 'follows', note: 'right for your earlier values' };
  return {
    field,
    verdict: 'wrong',
    note: truth[field.id] === undefined ? 'it does not exist' : '',
  };
}

/** A mistake that gives this one value, on this line, from right values before it. */
function causeOfOne(field: Field, texts: Texts, input: Input): Misconception | null {
  const read = readAnswer(field, texts[field.id] ?? '');
  if (!read.ok) return null;
  const [only, ...others] = suspectsOf(input).filter(
    ({ misconception, answers }) =>
      misconception.line === lineName(field) && matches(field, read.value, answers[field.id]),
  );
  return only && others.length === 0 ? only.misconception : null;
}

/** t1 and t2 are both the line t of the derivation. */
const lineName = ({ id }: Field): string => id.replace(/[12]$/, '');

function sentence(lines: readonly OwnLine[], firstWrong: Field | null, typed: number): string {
  if (typed === 0) return 'Nothing typed yet: fill in as much as you have.';
  const names = (verdict: OwnLine['verdict']): string =>
    listed(lines.filter((line) => line.verdict === verdict).map(({ field }) => field.label));
  const unread = names('invalid');
  const aside = unread ? ` ${unread} could not be read.` : '';
  if (!firstWrong) {
    return unread ? `All that could be read is right.${aside}` : 'All that you typed is right.';
  }
  const follows = lines.filter(({ verdict }) => verdict === 'follows');
  const wrong = lines.filter(({ verdict }) => verdict === 'wrong').map(({ field }) => field.label);
  const be = follows.length > 1 ? 'are' : 'is';
  const because =
    follows.length > 0 ? ` Your ${names('follows')} ${be} right for your ${listed(wrong)}.` : '';
  const verb = wrong.length > 1 ? 'are' : 'is';
  return `${listed(wrong)} ${verb} wrong; the first wrong step is ${firstWrong.label}.${because}${aside}`;
}

function listed(names: readonly string[]): string {
  return names.length < 2
    ? (names[0] ?? '')
    : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`;
}
