import { display } from '../../text/format.ts';
import { courseOf } from '../course.ts';
import type { Answers } from '../types.ts';
import { work } from '../work.ts';
import type { Draft } from './define.ts';
import { numberOf } from './draw.ts';
import { withParam } from './params.ts';

/** start + slope·u, where u is the parameter or its square. */
interface Linear {
  readonly start: number;
  readonly slope: number;
}

/** A and D as functions of the draft's parameter p: both are linear in p or in p², for every shape of the course. */
export interface ByParam {
  readonly A: Linear;
  readonly D: Linear;
  readonly isSquared: boolean;
  /** "r" or "r²" */
  readonly u: string;
}

export function byParam({ shape, ray, param }: Draft): ByParam | null {
  if (!param) return null;
  const course = courseOf(shape);
  const at = (value: number): Answers =>
    work(course, { shape: withParam(shape, param, value), ray });
  const [zero, one, two] = [at(0), at(1), at(2)];
  const of = (id: string): Linear => ({
    start: numberOf(zero, id),
    slope: numberOf(one, id) - numberOf(zero, id),
  });
  const grows = (id: string): number => {
    const { start, slope } = of(id);
    return slope === 0 ? 0 : (numberOf(two, id) - start) / slope;
  };
  const isSquared = [grows('A'), grows('D')].includes(4);
  return { A: of('A'), D: of('D'), isSquared, u: isSquared ? `${param.symbol}²` : param.symbol };
}

/** "36 − 4 r²" */
export function linearWords({ start, slope }: Linear, u: string): string {
  if (slope === 0) return display(start);
  const size = Math.abs(slope) === 1 ? u : `${display(Math.abs(slope))} ${u}`;
  if (start === 0) return slope < 0 ? `−${size}` : size;
  return `${display(start)} ${slope < 0 ? '−' : '+'} ${size}`;
}
