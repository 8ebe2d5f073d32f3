/** Something that costs and is worth something. */
export interface Priced {
  readonly cost: number;
  readonly worth: number;
}

/**
 * The Pareto frontier, by rising cost: entries that no other beats. One beats another if it costs
 * no more, is worth no less, and is better in one of the two. Entries whose cost or worth is NaN
 * are left out.
 */
export function frontier<P extends Priced>(all: readonly P[]): P[] {
  const known = all.filter(({ cost, worth }) => !Number.isNaN(cost) && !Number.isNaN(worth));
  return known
    .filter((one) => !known.some((other) => beats(other, one)))
    .sort((a, b) => a.cost - b.cost || a.worth - b.worth);
}

const beats = (a: Priced, b: Priced): boolean =>
  a.cost <= b.cost && a.worth >= b.worth && (a.cost < b.cost || a.worth > b.worth);

/** Corners of the step line through a frontier: the largest worth for a cost of at most x. */
export function steps(
  front: readonly Priced[],
): readonly (readonly [cost: number, worth: number])[] {
  return front.flatMap(({ cost, worth }, i) => {
    const before = front[i - 1];
    return before
      ? [[cost, before.worth] as const, [cost, worth] as const]
      : [[cost, worth] as const];
  });
}
