import { display } from '../../text/format.ts';
import { courseOf } from '../course.ts';
import type { Answers } from '../types.ts';
import { work } from '../work.ts';
import type { Draft } from './define.ts';
import { numberOf } from './draw.ts';
import { withParam } from './params.ts';

/** start + linear·p + square·p² */
interface Quadratic {
  readonly start: number;
  readonly linear: number;
  readonly square: number;
}

/** A and D as functions of the draft's parameter p: of degree 2 at most, for every shape. */
interface ByParam {
  readonly A: Quadratic;
  readonly D: Quadratic;
}

export function byParam({ shape, ray, param }: Draft): ByParam | null {
  if (!param) return null;
  const course = courseOf(shape);
  const at = (value: number): Answers =>
    work(course, { shape: withParam(shape, param, value), ray });
  const found = [at(0), at(1), at(2)];
  const of = (id: string): Quadratic => {
    const [zero = 0, one = 0, two = 0] = found.map((answers) => numberOf(answers, id));
    const square = (two - 2 * one + zero) / 2;
    return { start: zero, linear: one - zero - square, square };
  };
  return { A: of('A'), D: of('D') };
}

/** "36 − 4 r²" */
export function quadraticWords({ start, linear, square }: Quadratic, p: string): string {
  const terms = (
    [
      [start, ''],
      [linear, p],
      [square, `${p}²`],
    ] as const
  ).filter(([factor]) => factor !== 0);
  const words = terms.map(([factor, symbol], i) => {
    const size = Math.abs(factor);
    const one = symbol === '' ? display(size) : size === 1 ? symbol : `${display(size)} ${symbol}`;
    const minus = i === 0 ? '−' : '− ';
    return `${factor < 0 ? minus : i === 0 ? '' : '+ '}${one}`;
  });
  return words.length === 0 ? '0' : words.join(' ');
}
