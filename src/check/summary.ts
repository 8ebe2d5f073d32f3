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
  /** What was named on the way. */
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

/** Per topic: what was right at which try. */
export function summary(progress: Progress): Summary {
  const lines = plan(progress.seed, progress.set).map(({ exercise, kind }, i): SummaryLine => {
    const asked = askedAt(progress, i);
    const { tries, solvedAt, hints, solutionShown } = asked;
    return {
      question: i + 1,
      topic: findExercise(exercise)?.topic ?? exercise,
      shape: kind,
      ...{ tries, solvedAt, hints, solutionShown },
      misconceptions: asked.causes.flatMap((id) => findMisconception(id)?.says ?? []),
      says: inWords(asked),
    };
  });
  const right = lines.filter(({ solvedAt }) => solvedAt !== null).length;
  const { seed, set } = progress;
  return { seed, set, right, total: lines.length, lines };
}

function inWords({ tries, solvedAt, solutionShown }: Asked): string {
  if (solvedAt !== null) return `right at try ${solvedAt}`;
  if (solutionShown) return tries === 0 ? 'solution read' : `solution read after try ${tries}`;
  return tries === 0 ? 'not tried' : `not right yet, ${tries === 1 ? '1 try' : `${tries} tries`}`;
}

/** For a lecturer's own evaluation; nobody but the student sends it. */
export const summaryJson = (progress: Progress): string =>
  `${JSON.stringify({ graze: 'check-summary', version: 1, ...summary(progress) }, null, 2)}\n`;
