import * as op from './ops.ts';

/** Code that leaves one v128 on the stack. */
export type Code = readonly number[];

/** The code that gives the value of a name. Throws ReferenceError for one that is not known. */
export type Value = (name: string) => Code;

const TOKEN = /\s*(Math\.\w+|[A-Za-z_]\w*|\d+(?:\.\d+)?(?:e[-+]?\d+)?|<=|>=|&&|[-+*/()<>,])/y;

/** Levels of operators, the loosest first; all of them from left to right, as in TypeScript. */
const LEVELS: readonly Readonly<Record<string, (a: Code, b: Code) => Code>>[] = [
  { '&&': op.and },
  { '<': op.lt, '>': op.gt, '<=': op.le, '>=': op.ge },
  { '+': op.add, '-': op.sub },
  { '*': op.mul, '/': op.div },
];
const OF_TWO: Readonly<Record<string, (a: Code, b: Code) => Code>> = {
  'Math.min': op.min,
  'Math.max': op.max,
};

/** A formula of TypeScript for two rays at a time: the same operations in the same order, and so the same bits. `abs` is how a size is taken. Throws SyntaxError for what is not one. */
export function codeOf(formula: string, value: Value, abs: (a: Code) => Code = op.abs): Code {
  const ofOneValue: Readonly<Record<string, (a: Code) => Code>> = {
    'Math.abs': abs,
    'Math.sqrt': op.sqrt,
  };
  const tokens = tokensOf(formula);
  let at = 0;
  const code = level(0);
  if (at < tokens.length) fail(tokens[at]);
  return code;

  function fail(token: string | undefined): never {
    throw new SyntaxError(`unexpected ${token || 'end'} in ${formula}`);
  }

  function expect(token: string): void {
    if (tokens[at] !== token) fail(tokens[at]);
    at += 1;
  }

  function level(n: number): Code {
    const operators = LEVELS[n];
    if (!operators) return factor();
    let left = level(n + 1);
    for (let make = operators[tokens[at] ?? '']; make; make = operators[tokens[at] ?? '']) {
      at += 1;
      left = make(left, level(n + 1));
    }
    return left;
  }

  function factor(): Code {
    const token = tokens[at] ?? '';
    at += 1;
    if (token === '-') return op.neg(factor());
    if (token === '(') {
      const inner = level(0);
      expect(')');
      return inner;
    }
    const ofOne = ofOneValue[token];
    const ofTwo = OF_TWO[token];
    if (ofOne || ofTwo) {
      expect('(');
      const first = level(0);
      if (ofTwo) expect(',');
      const made = ofTwo ? ofTwo(first, level(0)) : ofOne?.(first);
      expect(')');
      return made ?? fail(token);
    }
    if (/^\d/.test(token)) return op.constant(Number(token));
    return /^[A-Za-z_]\w*$/.test(token) ? value(token) : fail(token);
  }
}

function tokensOf(formula: string): string[] {
  const tokens: string[] = [];
  for (let at = 0; formula.slice(at).trim() !== ''; at = TOKEN.lastIndex) {
    TOKEN.lastIndex = at;
    const found = TOKEN.exec(formula);
    if (!found) {
      throw new SyntaxError(`unexpected ${formula.slice(at).trim().slice(0, 9)} in ${formula}`);
    }
    tokens.push(found[1] as string);
  }
  return tokens;
}
