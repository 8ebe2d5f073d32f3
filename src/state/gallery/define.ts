/**
 * Some words, and the claims that make them true: 'D > 0', 'E inside', 't2 leaves', 'textbook class
 * none'. Each kind of claim has a check in tests/unit/state/gallery-claims.ts, and words that claim
 * something must name a claim for it.
 */
type Clause = readonly [words: string, ...claims: string[]];

/**
 * A state worth looking at. It is a link like any other, so whatever a example can show, a person
 * can send.
 */
export interface Example {
  readonly id: string;
  readonly title: string;
  /** One sentence: what to look at. */
  readonly look: string;
  readonly link: string;
  /** Title and sentence in clauses, with their claims. */
  readonly told: readonly Clause[];
}

export function example(id: string, title: Clause, look: readonly Clause[], link: string): Example {
  return {
    id,
    title: title[0],
    look: look.map(([words]) => words).join(' '),
    link: `#/explore?${link}`,
    told: [title, ...look],
  };
}
