/** Sizes from the style sheet in CSS px: graph, caption em, and the scale of marks. */
export interface Metrics {
  readonly width: number;
  readonly height: number;
  readonly em: number;
  readonly mark: number;
}

/** The plot within the graph. Margins depend on the type size only, not on the numbers shown. */
export interface Frame extends Metrics {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
  /** y in px of the lowest value of f, above the words "outside", "inside", "behind". */
  readonly floor: number;
  /** Whether it is too narrow for the readout in one line. */
  readonly narrow: boolean;
}

/** Width of a letter or digit, in em. */
export const LETTER = 0.56;

const NARROW_EMS = 44;

/** Sum of the margins of a plot, in em, and a little for rounding. */
export const MARGINS = { width: 4.8 + 0.2, height: 5.3 + 0.2 } as const;

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
