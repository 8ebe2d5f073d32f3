import { certified } from './certified.ts';
import { compensated } from './compensated.ts';
import { exact } from './exact.ts';
import { interval } from './interval.ts';
import { moment } from './moment.ts';
import { stable } from './stable.ts';
import { textbook } from './textbook.ts';
import { textbook32 } from './textbook32.ts';

/**
 * The ladder, from the course's own formula upwards. A new method is one new file and one word
 * here.
 *
 * @example
 * METHODS.map(({ id }) => id).includes('certified'); // → true
 */
export const METHODS = [
  textbook32,
  textbook,
  stable,
  moment,
  compensated,
  interval,
  certified,
  exact,
] as const;
