import { display } from '../../text/format.ts';
import type { Answers } from '../types.ts';
import { numberOf } from './draw.ts';

/** "−3 < 0", "0", "5 > 0" */
export const withSign = (x: number): string =>
  x === 0 ? '0' : `${display(x)} ${x < 0 ? '<' : '>'} 0`;

/** How many points there are, and by the sign of what: from A, B, C and D. */
export function caseWords(found: Answers): string {
  const [A, B, C, D] = ['A', 'B', 'C', 'D'].map((id) => numberOf(found, id)) as [
    number,
    number,
    number,
    number,
  ];
  if (A !== 0) {
    const roots = D < 0 ? 'no real root' : D === 0 ? 'one double root' : 'two roots';
    return `D = ${withSign(D)}: ${roots}, so ${POINTS[Math.sign(D) + 1]}.`;
  }
  if (B !== 0) return `A = 0 and B = ${display(B)}: B t + C = 0 has one root, so one point.`;
  return C === 0
    ? 'A = B = C = 0: every t is a root, so the whole line lies in the surface.'
    : `A = B = 0 and C = ${display(C)} is not 0: no t is a root, so no point.`;
}

const POINTS = ['no point', 'one point: the line touches', 'two points'];
