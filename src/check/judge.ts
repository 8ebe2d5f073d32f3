import { grade, type Mark, matches, type Texts } from './grade.ts';
import type { Misconception } from './misconceptions/define.ts';
import type { Answers, Field } from './types.ts';

/** A known mistake with what it gives on this very input. */
export interface Suspect {
  readonly misconception: Misconception;
  readonly answers: Answers;
}

export interface Judged {
  readonly marks: Readonly<Record<string, Mark>>;
  /** The one mistake that gives every wrong answer, if a known one does. */
  readonly cause: Misconception | null;
  /** Fields that are wrong, and yet right for the student's own earlier value. */
  readonly follow: readonly string[];
  readonly verdict: 'correct' | 'wrong' | 'invalid';
}

/**
 * Marks every field. Wrong answers are compared with what the suspects give: first for a mistake that explains all of
 * the answers, right ones included, then for the only one that explains the wrong ones.
 */
export function judge(
  fields: readonly Field[],
  texts: Texts,
  truth: Answers,
  suspects: readonly Suspect[],
  again: (own: Answers) => Answers = () => truth,
): Judged {
  const marks = Object.fromEntries(
    fields.map(
      (field) => [field.id, grade(field, texts[field.id] ?? '', truth[field.id])] as const,
    ),
  );
  const verdicts = Object.values(marks).map(({ verdict }) => verdict);
  const verdict = verdicts.includes('wrong')
    ? 'wrong'
    : verdicts.includes('invalid')
      ? 'invalid'
      : 'correct';
  const cause = verdict === 'wrong' ? causeOf(fields, marks, suspects) : null;
  return { marks, cause, follow: followers(fields, marks, again), verdict };
}

type Marks = Judged['marks'];

function causeOf(
  fields: readonly Field[],
  marks: Marks,
  suspects: readonly Suspect[],
): Misconception | null {
  const explains = (which: (mark: Mark) => boolean) => (suspect: Suspect) =>
    fields.every((field) => {
      const mark = marks[field.id];
      if (!mark || mark.verdict === 'invalid' || !which(mark)) return true;
      return matches(field, mark.value, suspect.answers[field.id]);
    });
  const all = suspects.find(explains(() => true));
  if (all) return all.misconception;
  const [only, ...others] = suspects.filter(explains(({ verdict }) => verdict === 'wrong'));
  return only && others.length === 0 ? only.misconception : null;
}

/** A later answer that is right for the values before it: only the first wrong one is a mistake of its own. */
function followers(
  fields: readonly Field[],
  marks: Marks,
  again: (own: Answers) => Answers,
): string[] {
  const own: Record<string, Answers[string]> = {};
  const found: string[] = [];
  for (const field of fields) {
    const mark = marks[field.id];
    if (!mark || mark.verdict === 'invalid') continue;
    if (mark.verdict === 'wrong') {
      const before = Object.keys(own).length > 0;
      if (before && matches(field, mark.value, again(own)[field.id])) found.push(field.id);
      own[field.id] = mark.value;
    }
  }
  return found;
}
