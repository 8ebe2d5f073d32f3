import { angleHint } from './angles.ts';
import { evaluate } from './expression.ts';
import { literal } from './literal.ts';
import { normalise } from './normalise.ts';
import type { Parsed } from './parsed.ts';
import { readExpression } from './read-expression.ts';
import { quoted, Refusal } from './refusal.ts';
import type { Typed } from './typed.ts';

/** Most characters of an expression; a longer text is refused unread. */
const MAX_LENGTH = 200;

export interface NumberOptions {
  /** Whether an infinite value is accepted, as in links with an infinite coefficient. */
  readonly allowInfinity?: boolean;
}

/**
 * A number or an expression without variables: '1/3', 'sqrt(2)', '1e7', '-2^-40', '0,5', '2·10⁻³',
 * 'pi'.
 */
export function parseNumber(text: string, options: NumberOptions = {}): Parsed<number> {
  if (text.trim() === '') return refused('type a number, such as 1/3 or sqrt(2)');
  if (text.length > MAX_LENGTH)
    return refused(`${quoted(text)} is longer than ${MAX_LENGTH} characters`);
  try {
    return judged(text, evaluated(text), options.allowInfinity ?? false);
  } catch (error) {
    if (error instanceof Refusal) return refused(withQuote(error.message, text));
    throw error;
  }
}

function evaluated(text: string): number | null {
  const normal = normalise(text);
  const plain = literal(normal);
  if (plain !== null) return plain;
  const tree = readExpression(normal);
  // −0 is kept if it was typed as such; a computed one becomes 0.
  return tree && evaluate(tree) + 0;
}

/** The tree of a text that `parseNumber` reads, for exact values. */
export function parseTyped(text: string): Typed | null {
  return parseNumber(text).ok ? readExpression(normalise(text)) : null;
}

/** A hint on a text that was read but may mean something else: an angle without a unit. */
export function hintOn(text: string): string | null {
  const tree = parseTyped(text);
  return tree && angleHint(tree);
}

function judged(text: string, value: number | null, allowInfinity: boolean): Parsed<number> {
  if (value === null) return refused(`${quoted(text)} is not a number`);
  if (Number.isNaN(value)) return refused(`${quoted(text)} has no real value`);
  const ok = Number.isFinite(value) || allowInfinity;
  return ok ? { ok, value } : refused(`${quoted(text)} is infinite`);
}

/**
 * A literal inside an expression is quoted alone ("'1e400' is beyond …"), an operation with the
 * whole text.
 */
function withQuote(reason: string, text: string): string {
  return reason.startsWith("'") ? reason : `${quoted(text)} ${reason}`;
}

function refused(reason: string): Parsed<number> {
  return { ok: false, reason };
}
