import { codeOf, type Expr } from '../../../scripts/kernels/certified/expression.ts';
import {
  elementOf,
  expressionOf,
  loopOf,
  type Source,
} from '../../../scripts/kernels/certified/source.ts';
import * as op from '../../../scripts/kernels/wasm/ops.ts';
import { productError, sumError } from '../../../src/math/float/eft.ts';
import { known, negative, type Off, running } from './running-error.ts';

/*
 * Running error analysis (running-error.ts) of a loop's own text, operation by operation, for one
 * ray. An operation that happens to be exact adds nothing. What is cut to a grid, and a size that
 * others are measured by, is what it is: a definition, not an approximation.
 */

type Numbers = Readonly<Record<string, number>>;
type Operation = (stack: Off[]) => Off;

const U = 2 ** -53;
/** |d|₁, rough roots, and the parts of sums and products that are split without an error. */
const DEFINED = /^(speed|Sd|t[ab]|p[xyz]|v[xyz]|lost[XYZ]|(big|top)[DP])$/;
/** `x + grid - grid`: x cut to a grid. */
function isCut(formula: Expr): boolean {
  if (formula.op !== '-' || formula.b.op !== 'value' || formula.a.op !== '+') return false;
  const { name } = formula.b;
  const { b } = formula.a;
  return name.startsWith('grid') && b.op === 'value' && b.name === name;
}
const LOCAL = 0x20;
const CONSTANT = 12;
const unrounded = running({ sum: 0, product: 0 });

/** `x` is rounded unless `rest` is 0. */
const rounded = (x: number, rest: number, off: number): Off => ({
  x,
  off: off + (rest === 0 ? 0 : U * Math.abs(x)),
});

const take = (stack: Off[]): Off => stack.pop() as Off;
const binary =
  (f: (a: Off, b: Off) => Off): Operation =>
  (stack) => {
    const b = take(stack);
    return f(take(stack), b);
  };
const unary =
  (f: (a: Off) => Off): Operation =>
  (stack) =>
    f(take(stack));
const sum = (a: Off, b: Off): Off =>
  rounded(a.x + b.x, sumError(a.x, b.x, a.x + b.x), a.off + b.off);
const condition = binary(() => known(0));

function product(a: Off, b: Off): Off {
  const { x, off } = unrounded.exactly(a, b);
  return rounded(x, productError(a.x, b.x, x), off);
}

function quotient(a: Off, b: Off): Off {
  const x = a.x / b.x;
  return rounded(x, 1, (a.off + Math.abs(x) * b.off) / (Math.abs(b.x) - b.off));
}

function root({ x, off }: Off): Off {
  const found = Math.sqrt(x);
  return rounded(found, 1, off / (Math.sqrt(Math.max(x - off, 0)) + found));
}

/** By the opcodes of ops.ts. */
const OPERATIONS: Readonly<Record<number, Operation>> = {
  73: condition,
  74: condition,
  75: condition,
  76: condition,
  78: condition,
  236: unary(({ x, off }) => ({ x: Math.abs(x), off })),
  237: unary(negative),
  239: unary(root),
  240: binary(sum),
  241: binary((a, b) => sum(a, negative(b))),
  242: binary(product),
  243: binary(quotient),
};

function lebAt(code: readonly number[], at: number): readonly [value: number, next: number] {
  let value = 0;
  let k = at;
  for (let shift = 0; ; shift += 7, k++) {
    value += ((code[k] as number) & 127) * 2 ** shift;
    if ((code[k] as number) < 128) return [value, k + 1];
  }
}

const doubleAt = (code: readonly number[], at: number): number =>
  new Float64Array(Uint8Array.from(code.slice(at, at + 8)).buffer)[0] as number;

/** Runs the instructions that codeOf makes. */
function run(code: readonly number[], names: readonly string[], values: Map<string, Off>): Off {
  const stack: Off[] = [];
  for (let at = 0; at < code.length; ) {
    const [operand, next] = lebAt(code, at + 1);
    if (code[at] === LOCAL) stack.push(values.get(names[operand] as string) as Off);
    else if (operand === CONSTANT) stack.push(known(doubleAt(code, next)));
    else stack.push((OPERATIONS[operand] as Operation)(stack));
    at = next + (code[at] !== LOCAL && operand === CONSTANT ? 16 : 0);
  }
  return take(stack);
}

/**
 * The analysis of a loop: `constant` and `elements` as for namedValues; `more` are formulas beside
 * the loop's own, by name; what is `exact` is taken to be so.
 */
export function runningError(
  source: Source,
  name: string,
  hasY: boolean,
  more: Readonly<Record<string, string>> = {},
  exact: readonly string[] = [],
): (constant: (array: string, key: string) => number, elements: Numbers) => Map<string, Off> {
  const { constants, statements } = loopOf(source, name, hasY);
  const names: string[] = [];
  const local = (named: string): readonly number[] => {
    if (!names.includes(named)) names.push(named);
    return op.get(names.indexOf(named));
  };
  const added = Object.entries(more).map(([target, formula]) => ({
    target,
    formula: expressionOf(formula),
    writes: false,
  }));
  const steps = [...statements, ...added]
    .filter(({ writes }) => !writes)
    .map(({ target, formula }) => ({ target, formula, code: codeOf(formula, local) }));
  return (constant, elements) => {
    const values = new Map<string, Off>();
    for (const { name, array, key } of constants) values.set(name, known(constant(array, key)));
    for (const [array, x] of Object.entries(elements)) values.set(elementOf(array), known(x));
    for (const { target, formula, code } of steps) {
      const found = run(code, names, values);
      const defined = isCut(formula) || DEFINED.test(target) || exact.includes(target);
      values.set(target, defined ? known(found.x) : found);
    }
    return values;
  };
}
