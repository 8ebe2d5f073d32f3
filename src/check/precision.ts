import type { Vec3 } from '../math/index.ts';
import { parseNumber } from '../text/parse.ts';
import type { Answer } from './types.ts';

/**
 * A number as it is written down: digits, perhaps a point or comma and digits, perhaps a power of
 * ten.
 */
const LITERAL = /^[-+−–]?\s*\d*(?:[.,](\d*))?(?:e([-+−]?\d{1,3}))?$/i;

/** One unit in the last digit that was written; 0 for an expression, which is exact. */
function unitOf(text: string): number {
  const match = LITERAL.exec(text.trim());
  if (!match) return 0;
  const [, decimals = '', power = '0'] = match;
  return 10 ** (Number(power.replace('−', '-')) - decimals.length);
}

/** As parseTriple separates; which of these it was is told by the values. */
const SEPARATORS = [/;/, /,/, /,\s+/, /\s+/];
const AROUND = /^[\s\w]*[([{]+|[)\]}]+\s*$/g;

/** The last written digit's unit of each number in the text that gave this value. */
export function unitsOf(text: string, value: Answer): readonly number[] {
  if (typeof value === 'number') return [unitOf(text)];
  if (typeof value !== 'object') return [];
  const inner = text.trim().replace(AROUND, '');
  for (const separator of SEPARATORS) {
    const parts = inner.split(separator).filter((part) => part.trim() !== '');
    if (parts.length === 3 && parts.every((part, i) => read(part) === value[i])) {
      return parts.map(unitOf);
    }
  }
  return [0, 0, 0];
}

function read(text: string): number | null {
  const parsed = parseNumber(text);
  return parsed.ok ? parsed.value : null;
}

/** Room for the rounding of a decimal that was typed as a double. */
const SLACK = 1 + 1e-9;

/** x rounded to this unit, or cut off there. */
function isShort(x: number, truth: number, unit: number): boolean {
  const off = Math.abs(x - truth);
  if (off <= (unit / 2) * SLACK) return true;
  return off < unit && Math.abs(x) <= Math.abs(truth) && x * truth >= 0;
}

/** How many digits of a value of this size end at the unit. */
const digitsOf = (size: number, unit: number): number =>
  Math.floor(Math.log10(size) + 1e-12) - Math.round(Math.log10(unit)) + 1;

/**
 * How many digits of `truth` were written rightly, rounded or cut off: 0 where it is not right, or
 * is no decimal. Of three numbers the largest counts, and all end where the coarsest ends that is
 * not right by itself.
 */
export function rightDigits(
  given: Answer,
  units: readonly number[],
  truth: Answer | undefined,
): number {
  if (typeof given === 'number' && typeof truth === 'number') {
    return digitsOfAll([given], units, [truth]);
  }
  return typeof given === 'object' && typeof truth === 'object'
    ? digitsOfAll(given, units, truth)
    : 0;
}

function digitsOfAll(
  given: readonly number[],
  units: readonly number[],
  truth: readonly number[],
): number {
  const size = Math.max(...given.map(Math.abs));
  const all = [...given, ...truth];
  if (!(size > 0) || !all.every(Number.isFinite)) return 0;
  let coarsest = 0;
  for (const [i, x] of given.entries()) {
    const unit = units[i] ?? 0;
    const right = truth[i] ?? Number.NaN;
    if (Math.abs(x - right) <= EXACT * size) continue;
    if (!isShort(x, right, unit)) return 0;
    coarsest = Math.max(coarsest, unit);
  }
  return coarsest === 0 ? 0 : Math.max(0, digitsOf(size, coarsest));
}

/** Far below any digit that somebody types, far above the rounding of doubles. */
const EXACT = 1e-12;

/** `truth` at the length that was given: a direction may have any. */
export function atLengthOf(given: Vec3, truth: Vec3): Vec3 {
  const k = Math.hypot(...given) / Math.hypot(...truth);
  return [k * truth[0], k * truth[1], k * truth[2]];
}
