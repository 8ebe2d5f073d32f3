import type { Sign } from '../math/shapes.ts';

export interface Comparison {
  /** The name of a quantity, as in the derivation. */
  readonly left: string;
  readonly relation: '=' | '<' | '>' | '≠' | '≤';
  readonly right: string;
}

/** A part of a sentence: words, or a computed number. */
export type Piece = string | { readonly quantity: string; readonly value: number };

export const zero = (left: string): Comparison => ({ left, relation: '=', right: '0' });

/** Why a method has no class: a number overflowed, or its bounds contain both signs. */
export function cannotDecide<Key extends string>(
  numbers: Readonly<Record<Key, number>>,
  signs: Readonly<Record<Key, Sign | null>>,
  letters: Readonly<Record<Key, string>>,
): string {
  const keys = Object.keys(letters) as Key[];
  if (keys.some((key) => !Number.isFinite(numbers[key]))) {
    return 'cannot decide: a number overflowed';
  }
  const open = keys.filter((key) => signs[key] === null).map((key) => letters[key]);
  if (open.length === 0) return 'cannot decide';
  return `cannot decide: the sign of ${open.join(' and of ')} is not certain`;
}
