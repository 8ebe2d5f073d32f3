import * as op from '../wasm/ops.ts';

/** Code that leaves one v128 on the stack. */
export type Code = op.Code;

/** The code that gives the value of a name. Throws ReferenceError for one that is not known. */
export type Value = (name: string) => Code;

const OF_TWO = {
  '&&': op.and,
  '<': op.lt,
  '>': op.gt,
  '<=': op.le,
  '>=': op.ge,
  '+': op.add,
  '-': op.sub,
  '*': op.mul,
  '/': op.div,
  min: op.min,
  max: op.max,
} as const;

/** A formula of one ray: operations in double precision, and conditions. */
export type Expr =
  | { readonly op: 'value'; readonly name: string }
  | { readonly op: 'number'; readonly value: number }
  | { readonly op: 'neg' | 'abs' | 'sqrt'; readonly of: Expr }
  | { readonly op: keyof typeof OF_TWO; readonly a: Expr; readonly b: Expr };

/**
 * A formula for two rays at a time: the same operations in the same order, and so the same bits.
 * `abs` is how a size is taken.
 */
export function codeOf(formula: Expr, value: Value, abs: (a: Code) => Code = op.abs): Code {
  switch (formula.op) {
    case 'value':
      return value(formula.name);
    case 'number':
      return op.constant(formula.value);
    case 'neg':
      return op.neg(codeOf(formula.of, value, abs));
    case 'sqrt':
      return op.sqrt(codeOf(formula.of, value, abs));
    case 'abs':
      return abs(codeOf(formula.of, value, abs));
    default:
      return OF_TWO[formula.op](codeOf(formula.a, value, abs), codeOf(formula.b, value, abs));
  }
}

/** The names in a formula, from left to right. */
export function namesIn(formula: Expr): string[] {
  if (formula.op === 'value') return [formula.name];
  if (formula.op === 'number') return [];
  if ('of' in formula) return namesIn(formula.of);
  return [...namesIn(formula.a), ...namesIn(formula.b)];
}

/** The same formula of other names. */
export function renamed(formula: Expr, name: (old: string) => string): Expr {
  if (formula.op === 'value') return { op: 'value', name: name(formula.name) };
  if (formula.op === 'number') return formula;
  if ('of' in formula) return { op: formula.op, of: renamed(formula.of, name) };
  return { op: formula.op, a: renamed(formula.a, name), b: renamed(formula.b, name) };
}
