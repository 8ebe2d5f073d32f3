import type { Posed } from '../check/compose.ts';
import type { Judged } from '../check/judge.ts';
import type { Progress } from '../check/progress.ts';

export interface QuestionView {
  readonly posed: Posed;
  /** From 0. */
  readonly index: number;
  readonly count: number;
  readonly progress: Progress;
  /** The answer that was committed last, if the boxes still hold it. */
  readonly judged: Judged | null;
}

export interface QuestionTools {
  type(field: string, text: string): void;
  check(): void;
  hint(): void;
  solution(): void;
  go(index: number): void;
  seed(seed: number): void;
}

/** The words, the formula in symbols, the formula with numbers. */
export const HINTS = 3;
