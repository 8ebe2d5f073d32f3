/** A line style that does not need colour: dashes, the shape of points, hollow or filled. */
export interface LineStyle {
  readonly dash: string;
  readonly shape: string;
  readonly full: boolean;
}

const CIRCLE = 'M3,0A3,3 0 1 1 -3,0A3,3 0 1 1 3,0Z';
const SQUARE = 'M-2.7,-2.7H2.7V2.7H-2.7Z';
const TRIANGLE = 'M0,-3.6L3.4,2.6H-3.4Z';
const DIAMOND = 'M0,-3.8L3.8,0L0,3.8L-3.8,0Z';

const STYLES: readonly LineStyle[] = [
  { dash: '1.5 3', shape: TRIANGLE, full: false },
  { dash: 'none', shape: CIRCLE, full: false },
  { dash: '7 3', shape: SQUARE, full: false },
  { dash: '12 3 2 3', shape: DIAMOND, full: false },
  { dash: '4 2', shape: TRIANGLE, full: true },
  { dash: '2 2', shape: SQUARE, full: true },
  { dash: 'none', shape: CIRCLE, full: true },
  { dash: '9 2', shape: DIAMOND, full: true },
];

/** The style of the i-th line. */
export const styleOf = (i: number): LineStyle =>
  STYLES[i % STYLES.length] ?? { dash: 'none', shape: CIRCLE, full: false };
