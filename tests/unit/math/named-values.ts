import { readFileSync } from 'node:fs';
import type { Expr } from '../../../scripts/kernels/certified/expression.ts';
import { elementOf, loopOf, type Source } from '../../../scripts/kernels/certified/source.ts';

type Numbers = Readonly<Record<string, number>>;

/** A stage's file, by its name without ending. */
export function stageSource(stage: string): Source {
  const file = `src/math/methods/certified/${stage}.ts`;
  return { file, text: readFileSync(file, 'utf8') };
}

const TWO: Readonly<Record<string, (a: number, b: number) => number>> = {
  '+': (a, b) => a + b,
  '-': (a, b) => a - b,
  '*': (a, b) => a * b,
  '/': (a, b) => a / b,
  '<': (a, b) => Number(a < b),
  '>': (a, b) => Number(a > b),
  '<=': (a, b) => Number(a <= b),
  '>=': (a, b) => Number(a >= b),
  '&&': (a, b) => a && b,
  min: Math.min,
  max: Math.max,
};

/** What a formula stands for; conditions are 1 and 0. */
export function numberFor(formula: Expr, value: (name: string) => number): number {
  if (formula.op === 'value') return value(formula.name);
  if (formula.op === 'number') return formula.value;
  if ('of' in formula) {
    const of = numberFor(formula.of, value);
    return formula.op === 'neg' ? -of : Math[formula.op](of);
  }
  const make = TWO[formula.op] as (a: number, b: number) => number;
  return make(numberFor(formula.a, value), numberFor(formula.b, value));
}

/**
 * What every name in a loop stands for, for one ray: as the loop itself computes it, both sides of
 * its branches. `constant` gives what the loop takes from arrays before it begins; `elements` are
 * the ray's own, by array.
 */
export function namedValues(
  source: Source,
  name: string,
  hasY: boolean,
): (constant: (array: string, key: string) => number, elements: Numbers) => Numbers {
  const { constants, statements } = loopOf(source, name, hasY);
  const named = statements.filter(({ writes }) => !writes);
  return (constant, elements) => {
    const known: Record<string, number> = {};
    for (const [array, x] of Object.entries(elements)) known[elementOf(array)] = x;
    const found: Record<string, number> = {};
    for (const { name, array, key } of constants) found[name] = constant(array, key);
    const value = (name: string): number => {
      const x = found[name] ?? known[name];
      if (x === undefined) throw new ReferenceError(`${name} is not known`);
      return x;
    };
    for (const { target, formula } of named) found[target] = numberFor(formula, value);
    return found;
  };
}
