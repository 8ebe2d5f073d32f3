import type { Failure, Report } from '../check/program/report.ts';

export interface ProgramView {
  readonly source: string;
  /** A shape's kind, or 'all'. */
  readonly kind: string;
  /** While it runs: how many of the cases came back. */
  readonly running: { readonly done: number; readonly total: number } | null;
  /** Why it did not run, or not to the end; '' if it did. */
  readonly trouble: string;
  readonly notes: readonly string[];
  readonly report: Report | null;
  /** Its time in textbook times; null if it was not measured. */
  readonly multiple: number | null;
  readonly selected: Failure | null;
  /** How many runs have come to their end. */
  readonly finished: number;
  /** The selected case in Explore. */
  readonly link: string | null;
}

export interface ProgramTools {
  edit(source: string): void;
  pick(kind: string): void;
  run(): void;
  cancel(): void;
  openFile(): void;
  template(): void;
  example(): void;
  select(failure: Failure): void;
  saveCases(format: 'json' | 'csv'): void;
  openResults(): void;
}
