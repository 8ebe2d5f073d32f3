import type { Posed } from '../check/compose.ts';
import type { Judged } from '../check/judge.ts';
import type { Progress } from '../check/progress.ts';

export interface QuestionView {
  readonly posed: Posed;
  /** From 0. */
  readonly index: number;
  readonly count: number;
  readonly progress: Progress;
  /** The judgement of the last answer, if the boxes have not changed since. */
  readonly judged: Judged | null;
  /** Whether hints and solutions are offered. */
  readonly withHints: boolean;
}

export interface QuestionTools {
  type(field: string, text: string): void;
  check(): void;
  hint(): void;
  solution(): void;
  go(index: number): void;
  seed(seed: number): void;
}

/** Number of hints: words, formula in symbols, formula in numbers. */
export const HINTS = 3;
