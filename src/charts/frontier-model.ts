import type { Price } from '../lab/price.ts';

export interface FrontierMark {
  readonly id: string;
  /** What stands beside the mark. */
  readonly name: string;
  /** The whole truth in words, for the screen reader. */
  readonly words: string;
  readonly cost: Price;
  /** Larger is better. */
  readonly worth: number;
}

export interface FrontierModel {
  readonly marks: readonly FrontierMark[];
  readonly chosen: string;
  readonly costTitle: string;
  readonly worthTitle: string;
  /** The worths that the axis shows, from the worst to the best, and their labels. */
  readonly worthTicks: readonly { readonly value: number; readonly label: string }[];
}
