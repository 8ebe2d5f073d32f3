import { findExercise } from './exercises/index.ts';
import { findMisconception } from './misconceptions/index.ts';
import { type Asked, askedAt, type Progress } from './progress.ts';
import { plan } from './session.ts';

interface SummaryLine {
  /** From 1. */
  readonly question: number;
  readonly topic: string;
  readonly shape: string;
  readonly tries: number;
  /** The try at which it was right, or null. */
  readonly solvedAt: number | null;
  readonly hints: number;
  readonly solutionShown: boolean;
  /** Ids of the misconceptions that were named. */
  readonly misconceptions: readonly string[];
  /** "right at try 2", "not tried" */
  readonly says: string;
}

export interface Summary {
  readonly seed: number;
  readonly set: string;
  readonly right: number;
  readonly total: number;
  readonly lines: readonly SummaryLine[];
}

/** For each question: at which try it was right. */
export function summary(progress: Progress): Summary {
  const lines = plan(progress.seed, progress.set).map(({ exercise, kind }, i): SummaryLine => {
    const asked = askedAt(progress, i);
    const { tries, solvedAt, hints, solutionShown } = asked;
    return {
      question: i + 1,
      topic: findExercise(exercise)?.topic ?? exercise,
      shape: findExercise(exercise)?.subject ?? kind,
      ...{ tries, solvedAt, hints, solutionShown },
      misconceptions: asked.causes.flatMap((id) => findMisconception(id)?.says ?? []),
      says: inWords(asked),
    };
  });
  const right = lines.filter(({ solvedAt }) => solvedAt !== null).length;
  const { seed, set } = progress;
  return { seed, set, right, total: lines.length, lines };
}

/** 3 of 8 right */
export const scoreWords = (right: number, total: number): string => `${right} of ${total} right`;

function inWords({ tries, solvedAt, solutionShown }: Asked): string {
  if (solvedAt !== null) return `right at try ${solvedAt}`;
  if (solutionShown) return tries === 0 ? 'solution read' : `solution read after try ${tries}`;
  return tries === 0 ? 'not tried' : `not right yet, ${tries === 1 ? '1 try' : `${tries} tries`}`;
}

/** The summary as JSON, which a student can save and hand in. */
export const summaryJson = (progress: Progress): string =>
  `${JSON.stringify({ graze: 'check-summary', version: 1, ...summary(progress) }, null, 2)}\n`;
