import { BELOW, BEYOND, Refusal } from './refusal.ts';

type Unary = (a: number) => number;
type Binary = (a: number, b: number) => number;

/** The result; throws a Refusal if it over- or underflowed. Only at a pole (1/0) it is infinite. */
function inRange(result: number, isExactZero: boolean, isPole: boolean): number {
  if (result === 0 && !isExactZero) throw new Refusal(BELOW);
  if (Math.abs(result) === Number.POSITIVE_INFINITY && !isPole) throw new Refusal(BEYOND);
  return result;
}

const infinite = (x: number) => Math.abs(x) === Number.POSITIVE_INFINITY;

function checked(f: Binary, pole: (a: number, b: number) => boolean): Binary {
  return (a, b) => {
    const open = infinite(a) || infinite(b);
    return inRange(f(a, b), open || a === 0 || b === 0, open || pole(a, b));
  };
}

const add: Binary = (a, b) => inRange(a + b, true, infinite(a) || infinite(b));

export const binaryOps: Readonly<Record<string, Binary>> = {
  '+': add,
  '-': (a, b) => add(a, -b),
  '*': checked(
    (a, b) => a * b,
    () => false,
  ),
  '/': checked(
    (a, b) => a / b,
    (_, b) => b === 0,
  ),
  '^': checked(
    (a, b) => a ** b,
    (a) => a === 0,
  ),
};

export const unaryOps: Readonly<Record<string, Unary>> = {
  '+': (a) => a,
  '-': (a) => -a,
  sqrt: Math.sqrt,
  abs: Math.abs,
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  exp: (a) => inRange(Math.exp(a), infinite(a), infinite(a)),
  ln: Math.log,
};
