import type { Vec3 } from '../math/index.ts';
import { parseNumber } from '../text/parse.ts';
import type { Answer } from './types.ts';

/** A decimal number: digits, optionally a point or comma with digits, optionally an exponent. */
const LITERAL = /^[-+−–]?\s*\d*(?:[.,](\d*))?(?:e([-+−]?\d{1,3}))?$/i;

/** One unit of the last written digit; 0 for an expression such as 1/3, which is exact. */
function unitOf(text: string): number {
  const match = LITERAL.exec(text.trim());
  if (!match) return 0;
  const [, decimals = '', power = '0'] = match;
  return 10 ** (Number(power.replace('−', '-')) - decimals.length);
}

/** Separators of parseTriple. The right one is the one whose parts give the values. */
const SEPARATORS = [/;/, /,/, /,\s+/, /\s+/];
const AROUND = /^[\s\w]*[([{]+|[)\]}]+\s*$/g;

/** For each number in a text with this value: one unit of its last written digit. */
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

/** Factor of tolerance for the rounding of a typed decimal to a double. */
const SLACK = 1 + 1e-9;

/** Whether x is `truth` rounded or truncated to this unit. */
function isShort(x: number, truth: number, unit: number): boolean {
  const off = Math.abs(x - truth);
  if (off <= (unit / 2) * SLACK) return true;
  return off < unit && Math.abs(x) <= Math.abs(truth) && x * truth >= 0;
}

/** Number of significant digits down to the unit in a value of this size. */
const digitsOf = (size: number, unit: number): number =>
  Math.floor(Math.log10(size) + 1e-12) - Math.round(Math.log10(unit)) + 1;

/**
 * Number of significant digits of `truth` that were rightly written, rounded or truncated; 0 if the
 * value is wrong or no decimal. For a triple the digits of the largest component down to the
 * coarsest unit of a component that is not exact.
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

/** Relative tolerance: far below any digit that is typed, far above the rounding of doubles. */
const EXACT = 1e-12;

/** `truth` scaled to the length that was given, since a direction may have any length. */
export function atLengthOf(given: Vec3, truth: Vec3): Vec3 {
  const k = Math.hypot(...given) / Math.hypot(...truth);
  return [k * truth[0], k * truth[1], k * truth[2]];
}
