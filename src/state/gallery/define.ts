import type { View } from '../camera-view.ts';
import { viewText } from '../url.ts';

/**
 * Words, and the claims that they make: 'D > 0', 'E inside', 't2 leaves', 'textbook class none'.
 * Each kind of claim is checked in tests/unit/state/gallery-claims.ts.
 */
type Clause = readonly [words: string, ...claims: string[]];

interface ExampleParts {
  readonly title: Clause;
  /** A question, with claims for what it takes for granted. */
  readonly asks: Clause;
  /** One sentence, in clauses: what to look at. */
  readonly answer: readonly Clause[];
  /** The view from which the answer can be seen. */
  readonly view: View;
  /**
   * What lies too far out for the frame. E, the other points and the shape's own one are in it,
   * clear of the buttons, at every size of the window.
   */
  readonly outside: readonly ('E' | 'P1' | 'P2')[];
  /** Keys of the link for ray, shape and method. */
  readonly link: string;
}

/** A state with a title, a question and its answer. Its link is an ordinary link. */
export interface Example extends Pick<ExampleParts, 'view' | 'outside' | 'link'> {
  readonly id: string;
  readonly title: string;
  readonly asks: string;
  readonly answer: string;
  /** Title, question and answer in clauses, with their claims. */
  readonly told: readonly Clause[];
}

export function example(
  id: string,
  { title, asks, answer, view, outside, link }: ExampleParts,
): Example {
  return {
    ...{ id, view, outside },
    title: title[0],
    asks: asks[0],
    answer: answer.map(([words]) => words).join(' '),
    link: `#/explore?${link}${view === 'iso' ? '' : `&view=${viewText(view)}`}`,
    told: [title, asks, ...answer],
  };
}
