import { type Marks, numberPiece, type PrintedSign as Sign } from '../../math/formula.ts';

/** One line of the derivation: left, a relation, right, and what it means in words. */
export interface ExportLine<M> {
  /** Null if the line continues the one before, or has nothing to align. */
  readonly left: M | null;
  readonly relation: Sign | null;
  readonly right: M | null;
  readonly words: string;
}

/** Significant digits, as on the page. */
export const DIGITS = 6;

export const number = <M>(x: number, marks: Marks<M>): M => numberPiece(x, marks, DIGITS).m;

export function equation<M>(left: M | null, right: M, words = ''): ExportLine<M> {
  return { left, relation: '=', right, words };
}
