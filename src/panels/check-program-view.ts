import type { ConsoleLine, Timing } from '../check/program/protocol.ts';
import type { Failure, Report } from '../check/program/report.ts';

export interface ProgramView {
  readonly source: string;
  /** Why a text was not taken into the box; '' if none was refused. */
  readonly refusal: string;
  /** A remembered program that is too long for the box: it can still be saved. */
  readonly unshown: boolean;
  /** A shape's kind, or 'all'. */
  readonly kind: string;
  /** How 'all' is called. */
  readonly all: string;
  /** While it runs: how many of the cases came back. */
  readonly running: { readonly done: number; readonly total: number } | null;
  /** Why it did not run, or not to the end; '' if it did. */
  readonly trouble: string;
  readonly notes: readonly string[];
  readonly lines: readonly ConsoleLine[];
  readonly report: Report | null;
  /** Its time in textbook times; null if it was not measured. */
  readonly timing: Timing | null;
  /** Why it was not. */
  readonly untimed: string;
  readonly selected: Failure | null;
  /** How many runs have come to their end. */
  readonly finished: number;
  /** The selected case in Explore. */
  readonly link: string | null;
}

export interface ProgramTools {
  edit(source: string): void;
  /** Whether the box may hold this; if not, it is said why. */
  takes(source: string): boolean;
  pick(kind: string): void;
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
