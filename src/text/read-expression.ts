import { unaryOps } from './checked-ops.ts';
import { CONSTANTS, UNITS } from './expression.ts';
import { decimal, UNSIGNED } from './literal.ts';
import { quoted } from './refusal.ts';
import type { ConstantName, Typed, UnitName } from './typed.ts';

const TOKEN = new RegExp(String.raw`\s*(?:(${UNSIGNED})|([a-z_]\w*)|([-+*/^()]))\s*`, 'y');

/** Reads one rule of the grammar at the reader's position; null if the tokens do not match. */
type Rule = () => Typed | null;

/**
 * The tree of an expression in normal spelling; null when it is none.
 *
 *     sum:     product ((+|-) product)*
 *     product: factor ((*|/) factor)*
 *     factor:  (+|-|function) factor, or power
 *     power:   operand (^ factor)*
 *     operand: function (sum), or (number, constant or (sum)) with deg or rad behind it or not
 *
 * A function with a bracket is an operand, sqrt(2)^2 = 2; without one it takes the power behind it,
 * sqrt 2^2 = 2 too, but as sqrt(4).
 */
export function readExpression(text: string): Typed | null {
  const tokens = tokenise(text);
  return tokens && read(tokens);
}

function read(tokens: readonly string[]): Typed | null {
  let at = 0;
  const peek = (): string => tokens[at] ?? '';
  const next = (): string => tokens[at++] ?? '';
  const isFunction = (token: string): boolean => /^\w/.test(token) && has(unaryOps, token);

  /** Operands with operators of one rank between them, from the left. */
  function chain(operators: string, first: Rule, others = first): Typed | null {
    let left = first();
    while (left && peek() !== '' && operators.includes(peek())) {
      const name = next();
      const right = others();
      left = right && { op: 'binary', name, left, right };
    }
    return left;
  }

  const sum: Rule = () => chain('+-', product);
  const product: Rule = () => chain('*/', factor);
  const power: Rule = () => chain('^', operand, factor);

  function factor(): Typed | null {
    const token = peek();
    const prefix = token === '+' || token === '-' || (isFunction(token) && tokens[at + 1] !== '(');
    return prefix ? unary(factor) : power();
  }

  function unary(rule: Rule): Typed | null {
    const name = next();
    const from = at;
    const of = rule();
    return of && { op: 'unary', name, argument: bare(tokens.slice(from, at)), of };
  }

  function operand(): Typed | null {
    if (isFunction(peek())) return unary(bracket);
    const of = peek() === '(' ? bracket() : plain(next());
    if (!of || !has(UNITS, peek())) return of;
    return { op: 'unit', name: next() as UnitName, of };
  }

  function bracket(): Typed | null {
    next();
    const inner = sum();
    return next() === ')' ? inner : null;
  }

  const tree = sum();
  return at === tokens.length ? tree : null;
}

/** The tokens as text, without a bracket around a single one. */
const bare = (tokens: readonly string[]): string =>
  (tokens[0] === '(' && tokens.length === 3 ? tokens.slice(1, 2) : tokens).join('');

function plain(token: string): Typed | null {
  if (/^[\d.]/.test(token)) return { op: 'number', text: token };
  return has(CONSTANTS, token) ? { op: 'constant', name: token as ConstantName } : null;
}

function tokenise(text: string): string[] | null {
  const tokens: string[] = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const [, number, name, operator] = TOKEN.exec(text) ?? [];
    if (number) decimal(number, `${quoted(number)} `);
    const known = name !== undefined && [unaryOps, CONSTANTS, UNITS].some((t) => has(t, name));
    const token = number ?? operator ?? (known ? name : undefined);
    if (token === undefined) return null;
    tokens.push(token);
  }
  return tokens;
}

const has = (table: object, name: string): boolean => Object.hasOwn(table, name);
