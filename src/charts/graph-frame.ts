/**
 * What the page's style says: the size of the graph, one caption em, and the factor on marks. All
 * in CSS px.
 */
export interface Metrics {
  readonly width: number;
  readonly height: number;
  readonly em: number;
  readonly mark: number;
}

/**
 * The plot within the graph. The margins depend on the type size only, so that nothing moves while
 * numbers change.
 */
export interface Frame extends Metrics {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  /** Where the lowest value shown lies: over the words outside, inside, behind. */
  readonly floor: number;
  /** Too narrow for all digits beside each other. */
  readonly narrow: boolean;
}

/** Width of a letter or digit, in em. */
export const LETTER = 0.56;

const NARROW_EMS = 44;

export function frameOf(metrics: Metrics): Frame {
  const { width, height, em } = metrics;
  const bottom = Math.round(height - 2.2 * em);
  return {
    ...metrics,
    left: Math.round(3.7 * em),
    right: Math.round(width - 1.1 * em),
    top: Math.round(1.7 * em),
    bottom,
    floor: bottom - 1.4 * em,
    narrow: width < NARROW_EMS * em,
  };
}
