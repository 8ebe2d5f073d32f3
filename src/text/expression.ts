import { Parser } from 'expr-eval-fork';
import { binaryOps, unaryOps } from './checked-ops.ts';
import { decimal, UNSIGNED } from './literal.ts';
import { quoted, Refusal } from './refusal.ts';

const CONSTANTS = { pi: Math.PI, infinity: Number.POSITIVE_INFINITY };
const TOKEN = new RegExp(String.raw`\s*(?:(${UNSIGNED})|([a-z_]\w*)|([-+*/^()]))\s*`, 'y');

/**
 * The library knows strings, arrays, assignments, variables, random(). Nothing of it can be reached: it only ever
 * sees the tokens below, and its tables hold only what is listed here.
 */
const parser = restricted();

/** The value of an expression in normal spelling; null when it is none. Infinite and NaN values are passed on. */
export function evaluate(text: string): number | null {
  const tokens = tokenise(text);
  if (tokens === null) return null;
  try {
    // Joined with spaces, so that '/' and '*' never become the library's comment.
    const value: unknown = parser.parse(tokens.join(' ')).evaluate();
    return typeof value === 'number' ? value : null;
  } catch (error) {
    if (error instanceof Refusal) throw error;
    return null;
  }
}

function tokenise(text: string): string[] | null {
  const tokens: string[] = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const [, number, name, operator] = TOKEN.exec(text) ?? [];
    if (number) decimal(number, `${quoted(number)} `);
    const token = number ?? operator ?? (isKnown(name) ? name : undefined);
    if (token === undefined) return null;
    tokens.push(token);
  }
  return tokens;
}

function isKnown(name: string | undefined): name is string {
  return name !== undefined && (Object.hasOwn(unaryOps, name) || Object.hasOwn(CONSTANTS, name));
}

function restricted(): Parser {
  const off = ['assignment', 'array', 'comparison', 'concatenate', 'conditional', 'factorial'];
  off.push('fndef', 'in', 'length', 'logical', 'random', 'remainder');
  const made = new Parser({
    allowMemberAccess: false,
    operators: Object.fromEntries(off.map((name) => [name, false])),
  });
  const own = (table: object) => Object.assign(Object.create(null), table);
  const tables = { unaryOps, binaryOps, ternaryOps: {}, functions: {}, consts: CONSTANTS };
  for (const [name, table] of Object.entries(tables)) Object.assign(made, { [name]: own(table) });
  return made;
}
