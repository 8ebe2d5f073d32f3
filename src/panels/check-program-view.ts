import type { ConsoleLine, Timing } from '../check/program/protocol.ts';
import type { Failure, Report } from '../check/program/report.ts';

export interface ProgramView {
  readonly source: string;
  /** Why a text was not put into the box; '' if none was refused. */
  readonly refusal: string;
  /** Whether a stored program is too long for the box; it can still be saved. */
  readonly unshown: boolean;
  /** A shape's kind, or 'all'. */
  readonly kind: string;
  /** Label of 'all'. */
  readonly all: string;
  /** Number of cases that are done while it runs; null while it does not. */
  readonly running: { readonly done: number; readonly total: number } | null;
  /** Why it did not run to the end; '' if it did. */
  readonly trouble: string;
  readonly notes: readonly string[];
  readonly lines: readonly ConsoleLine[];
  readonly report: Report | null;
  /** Its time divided by the textbook's; null if it was not measured. */
  readonly timing: Timing | null;
  /** Why the time was not measured; '' if it was, or if that needs no reason. */
  readonly untimed: string;
  readonly selected: Failure | null;
  /** Whether smaller failing cases are looked for. */
  readonly shrinking: boolean;
  /** Number of runs that have ended. */
  readonly finished: number;
  /** Link to the selected case on Explore. */
  readonly link: string | null;
}

export interface ProgramTools {
  edit(source: string): void;
  /** Whether the text may be put into the box; if not, the page says why. */
  takes(source: string): boolean;
  pick(kind: string): void;
  /** Chooses the seed of the cases. */
  seed(text: string): void;
  run(): void;
  cancel(): void;
  openFile(): void;
  saveUnshown(): void;
  template(): void;
  example(): void;
  select(failure: Failure): void;
  saveCases(format: 'json' | 'csv'): void;
  openResults(): void;
}
