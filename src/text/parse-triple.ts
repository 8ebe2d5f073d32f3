import { unaryOps } from './checked-ops.ts';
import { type NumberOptions, parseNumber } from './parse-number.ts';
import type { Parsed } from './parsed.ts';
import { quoted } from './refusal.ts';

export type Triple = readonly [number, number, number];

/** Three expressions of 200 characters, and what is around them. */
const MAX_LENGTH = 700;
const EXAMPLE = 'type three numbers, such as (1, 2, 3)';
const OPENING = '([{';
const CLOSING = ')]}';

/**
 * From the surest separator to the weakest. A comma comes late because it may be a decimal comma:
 * in '1,5; 2; 3' and '1,5, 2, 3' the semicolon and the comma with a space separate.
 */
const SEPARATORS: readonly RegExp[] = [/;/, /,?[\t\n]/, /,/, /,\s+/];

/**
 * '1, 2, 3', '(1,2,3)', '1 2 3', '1,5; 2; 3', '[1, 2, 3]', 'vec3(1.0, 2.0, 3.0)'; each part may be
 * an expression.
 */
export function parseTriple(text: string, options: NumberOptions = {}): Parsed<Triple> {
  if (text.trim() === '') return refused(EXAMPLE);
  if (text.length > MAX_LENGTH) return refused(`${quoted(text)} is too long for three numbers`);
  const parts = tripleTexts(text);
  if (parts === null) return refused(`${quoted(text)} is not three numbers`);
  const values: number[] = [];
  for (const part of parts) {
    const parsed = parseNumber(part, options);
    if (!parsed.ok) return parsed;
    values.push(parsed.value);
  }
  const [x = 0, y = 0, z = 0] = values;
  return { ok: true, value: [x, y, z] };
}

/** The texts of the three numbers; null if there are not three. */
export function tripleTexts(text: string): readonly string[] | null {
  return separated(text) ?? spaced(text);
}

/**
 * Whether a pasted text is meant for three boxes: '1, 2, x' is (and has a fault), '1,5' and '1 - 3'
 * are not.
 */
export function looksLikeTriple(text: string): boolean {
  if (text.length > MAX_LENGTH) return false;
  return separated(text) !== null || (spaced(text) !== null && parseTriple(text).ok);
}

function separated(text: string): string[] | null {
  const inner = unwrapped(text);
  for (const separator of SEPARATORS) {
    const parts = inner.split(separator);
    if (isThree(parts)) return parts.map(withoutSuffix);
  }
  return null;
}

/** The parts between spaces, which separate only if nothing else does, as expressions have them. */
function spaced(text: string): string[] | null {
  const parts = unwrapped(text).trim().split(/\s+/);
  return isThree(parts) ? parts.map(withoutSuffix) : null;
}

function isThree(parts: string[]): boolean {
  return parts.length === 3 && parts.every((part) => part.trim() !== '');
}

/** 'vec3(1, 2, 3)', 'np.array([1, 2, 3])', 'E = (1, 2, 3);' → '1, 2, 3' */
function unwrapped(text: string): string {
  const trimmed = text.trim().replace(/[;,]$/, '').trim();
  const [, name = '', body] = /^([\w.:= ]*)([([{].*)$/s.exec(trimmed) ?? [];
  if (body === undefined || Object.hasOwn(unaryOps, name) || !isOnePair(body)) return trimmed;
  return unwrapped(body.slice(1, -1));
}

/** Whether the first bracket is closed by the last character; not so in '(1) (2) (3)'. */
function isOnePair(text: string): boolean {
  let depth = 0;
  for (const [i, c] of [...text].entries()) {
    if (OPENING.includes(c)) depth++;
    if (CLOSING.includes(c)) depth--;
    if (depth === 0) return i === text.length - 1;
  }
  return false;
}

/** The part without the suffix of '1.0f', as in C and GLSL. */
function withoutSuffix(part: string): string {
  return part.trim().replace(/([\d.])f$/i, '$1');
}

function refused(reason: string): Parsed<Triple> {
  return { ok: false, reason };
}
