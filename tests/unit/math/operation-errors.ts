import { productError, sumError } from '../../../src/math/float/eft.ts';
import { codeOf } from '../../../src/math/wasm/expression.ts';
import * as op from '../../../src/math/wasm/ops.ts';
import { elementOf, loopOf } from '../../../src/math/wasm/source.ts';

/*
 * Running error analysis (Wilkinson) of a loop, operation by operation, for one ray: each value with how far it may be from what it would be without any rounding.
 * An operation that happens to be exact adds nothing. What is cut to a grid, and a size that others are measured by, is what it is: a definition, not an approximation.
 */

export interface Known {
  readonly value: number;
  readonly off: number;
}

type Numbers = Readonly<Record<string, number>>;
type Operation = (stack: Known[]) => Known;

const U = 2 ** -53;
const CUT = /\+ (grid\w*) - \1$/;
/** |d|₁, rough roots, and the parts of sums and products that are split without an error. */
const DEFINED = /^(speed|Sd|t[ab]|p[xyz]|v[xyz]|lost[XYZ]|(big|top)[DP])$/;
const LOCAL = 0x20;
const CONSTANT = 12;

const exactly = (value: number): Known => ({ value, off: 0 });
/** `value` is rounded unless `rest` is 0. */
const rounded = (value: number, rest: number, off: number): Known => ({
  value,
  off: off + (rest === 0 ? 0 : U * Math.abs(value)),
});

const take = (stack: Known[]): Known => stack.pop() as Known;
const binary =
  (f: (a: Known, b: Known) => Known): Operation =>
  (stack) => {
    const b = take(stack);
    return f(take(stack), b);
  };
const unary =
  (f: (a: Known) => Known): Operation =>
  (stack) =>
    f(take(stack));
const sum = (a: Known, b: Known): Known =>
  rounded(a.value + b.value, sumError(a.value, b.value, a.value + b.value), a.off + b.off);
const negative = ({ value, off }: Known): Known => ({ value: -value, off });
const condition = binary(() => exactly(0));

function product(a: Known, b: Known): Known {
  const value = a.value * b.value;
  const off = Math.abs(a.value) * b.off + Math.abs(b.value) * a.off + a.off * b.off;
  return rounded(value, productError(a.value, b.value, value), off);
}

function quotient(a: Known, b: Known): Known {
  const value = a.value / b.value;
  return rounded(value, 1, (a.off + Math.abs(value) * b.off) / (Math.abs(b.value) - b.off));
}

function root({ value, off }: Known): Known {
  const found = Math.sqrt(value);
  return rounded(found, 1, off / (Math.sqrt(Math.max(value - off, 0)) + found));
}

/** By the opcodes of ops.ts. */
const OPERATIONS: Readonly<Record<number, Operation>> = {
  73: condition,
  74: condition,
  75: condition,
  76: condition,
  78: condition,
  236: unary(({ value, off }) => ({ value: Math.abs(value), off })),
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
function run(code: readonly number[], names: readonly string[], known: Map<string, Known>): Known {
  const stack: Known[] = [];
  for (let at = 0; at < code.length; ) {
    const [operand, next] = lebAt(code, at + 1);
    if (code[at] === LOCAL) stack.push(known.get(names[operand] as string) as Known);
    else if (operand === CONSTANT) stack.push(exactly(doubleAt(code, next)));
    else stack.push((OPERATIONS[operand] as Operation)(stack));
    at = next + (code[at] !== LOCAL && operand === CONSTANT ? 16 : 0);
  }
  return take(stack);
}

/**
 * The analysis of a loop: `constant` and `elements` as for namedValues; `more` are formulas beside the loop's own, by name; what is
 * `exact` is taken to be so.
 */
export function runningError(
  source: string,
  name: string,
  hasY: boolean,
  more: Readonly<Record<string, string>> = {},
  exact: readonly string[] = [],
): (constant: (array: string, key: string) => number, elements: Numbers) => Map<string, Known> {
  const { constants, statements } = loopOf(source, name, hasY);
  const names: string[] = [];
  const local = (named: string): readonly number[] => {
    if (!names.includes(named)) names.push(named);
    return op.get(names.indexOf(named));
  };
  const added = Object.entries(more).map(([target, formula]) => ({
    target,
    formula,
    writes: false,
  }));
  const steps = [...statements, ...added]
    .filter(({ writes }) => !writes)
    .map(({ target, formula }) => ({ target, formula, code: codeOf(formula, local) }));
  return (constant, elements) => {
    const known = new Map<string, Known>();
    for (const { name, array, key } of constants) known.set(name, exactly(constant(array, key)));
    for (const [array, x] of Object.entries(elements)) known.set(elementOf(array), exactly(x));
    for (const { target, formula, code } of steps) {
      const found = run(code, names, known);
      const defined = CUT.test(formula) || DEFINED.test(target) || exact.includes(target);
      known.set(target, defined ? exactly(found.value) : found);
    }
    return known;
  };
}
