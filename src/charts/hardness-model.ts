interface HardnessPoint {
  readonly difficulty: number;
  /** Right digits, 0 … 15.95. */
  readonly digits: number;
  readonly words: string;
}

export interface HardnessLine {
  readonly id: string;
  readonly name: string;
  readonly points: readonly HardnessPoint[];
  /** Where the line ends, with the reason in a few words. */
  readonly end?: { readonly difficulty: number; readonly reason: string; readonly words: string };
  /** Where the first verdict is wrong or undecided. */
  readonly first?: { readonly difficulty: number };
}

export interface HardnessModel {
  readonly lines: readonly HardnessLine[];
  readonly range: readonly [number, number];
  readonly dialTitle: string;
  readonly tick: (difficulty: number) => string;
  readonly digitsTitle: string;
  readonly chosen: string;
  readonly picked: Picked | null;
}

export interface Picked {
  readonly id: string;
  readonly difficulty: number;
}

export interface HardnessActions {
  /** The picked point, perhaps not yet drawn, since keys may come faster than frames. */
  picked(): Picked | null;
  pick(picked: Picked): void;
  open(picked: Picked): void;
}

export interface HardnessScales {
  readonly x: (difficulty: number) => number;
  readonly y: (digits: number) => number;
}
