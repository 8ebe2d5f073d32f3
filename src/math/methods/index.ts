import { exact } from './exact.ts';
import { stable } from './stable.ts';
import { textbook } from './textbook.ts';

/** The ladder, from the course's own formula upwards. A new rung is one new file and one word here. */
export const METHODS = [textbook, stable, exact] as const;
