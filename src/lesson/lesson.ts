import type { Ask } from '../state/prediction-ask.ts';
import type { Prose } from './prose.ts';

/** What a student guesses before the answer is shown. */
export type Guess =
  /** A value of the free number; the right one is `truth`. */
  | { readonly type: 'free'; readonly truth: number }
  /** A number that the page shows. */
  | { readonly type: 'quantity'; readonly quantity: string }
  /** "class", or that of a row: "textbook.class". */
  | { readonly type: 'class'; readonly quantity: string }
  /** One of the options of what Explore asks while results are hidden. */
  | { readonly type: 'prediction'; readonly ask: ChosenAsk }
  /** Nothing is handed in: the answer is shown on request. */
  | { readonly type: 'open' };

/** What Explore asks that is answered by a choice, not by a mark on the ray. */
export const CHOSEN_ASKS = ['points', 'first', 'sign'] as const satisfies readonly Ask[];
type ChosenAsk = (typeof CHOSEN_ASKS)[number];

export interface Step {
  readonly title: string;
  /** A link of any page of Graze. */
  readonly link: string;
  /** The part of the page that is shown alone; null for the whole page. */
  readonly part: string | null;
  /** The only number that can be moved, 'r' or 'E.x', or a whole vector; null for none. */
  readonly free: string | null;
  readonly guess: Guess | null;
  /** Whether results are hidden at first. */
  readonly hide: boolean;
  readonly text: Prose;
  readonly question: Prose;
  readonly answer: Prose;
  readonly notes: Prose;
  /** The step as it is written, with its heading. */
  readonly source: string;
}

/** A text with steps, each of which shows a state of Graze. */
export interface Lesson {
  readonly id: string;
  readonly title: string;
  /** One sentence for the list of lessons. */
  readonly about: string;
  readonly steps: readonly Step[];
}

/** The id of an own lesson. */
export const OWN = 'own';

/** The step of a link's text, from 1, within the lesson. */
export function stepAt({ steps }: Lesson, text: string | undefined): number {
  const number = Math.trunc(Number(text ?? '1'));
  return Number.isFinite(number) ? Math.min(Math.max(number, 1), Math.max(steps.length, 1)) : 1;
}
