import { superscript } from './scripts.ts';

/** U+2212, as wide as a plus sign; code and links have a hyphen. */
export const MINUS = '\u2212';

/** Decimal digits that a double always preserves; differences beyond them are rounding noise. */
export const CERTAIN_DIGITS = 15;
/** Digits that tell any two doubles apart. */
export const ALL_DIGITS = 17;
/** Exponent from which a number is written with a power of ten, to spare counting zeros. */
const FIXED_BELOW = 6;
const FIXED_FROM = -4;

/** Text for NaN: ∞ − ∞, 0 · ∞. */
const NO_VALUE = 'no value';

export interface DisplayParts {
  /** With its sign, a true minus; '∞' for an infinity. */
  readonly mantissa: string;
  /** Exponent of the power of ten behind the mantissa; null without one. */
  readonly exponent: number | null;
}

/** The shortest text that gives the same bits back; for links, `data-value` and code. */
export function shortest(x: number): string {
  return Object.is(x, -0) ? '-0' : String(x);
}

/** All digits that the bits need, for people: the text of `shortest` with a true minus. */
export function displayAll(x: number): string {
  return shortest(x).replace('Infinity', '∞').replaceAll('-', MINUS);
}

/**
 * x rounded to `digits` significant digits: 0.72, 5.50860 (more digits follow), −1.2 · 10⁷. Never 0
 * for what is not 0.
 */
export function display(x: number, digits = 6): string {
  return inOne(displayParts(x, digits));
}

/** The two parts as one text; a mantissa of 1 is left out. */
export function inOne({ mantissa, exponent }: DisplayParts): string {
  if (exponent === null) return mantissa;
  const power = `10${superscript(exponent)}`;
  if (mantissa === '1') return power;
  return mantissa === `${MINUS}1` ? MINUS + power : `${mantissa} · ${power}`;
}

/** '(3, 1, −0.5)' */
export function displayTriple(v: readonly [number, number, number], digits = 6): string {
  return `(${v.map((x) => display(x, digits)).join(', ')})`;
}

/** Cache: the same number is written in many places and at every frame. */
let written: Map<number, Map<number, DisplayParts>> | undefined;
const MOST_KEPT = 2000;
let kept = 0;

/**
 * What `display` writes, in two parts, for a view that typesets the power itself. Both zeros are
 * '0'.
 */
export function displayParts(x: number, digits = 6): DisplayParts {
  written ??= new Map();
  const before = written.get(x)?.get(digits);
  if (before !== undefined) return before;
  if (++kept > MOST_KEPT) {
    written.clear();
    kept = 1;
  }
  const parts = partsOf(x, digits);
  const all = written.get(x);
  if (all) all.set(digits, parts);
  else written.set(x, new Map([[digits, parts]]));
  return parts;
}

function partsOf(x: number, digits: number): DisplayParts {
  if (x === 0) return { mantissa: '0', exponent: null };
  if (Number.isNaN(x)) return { mantissa: NO_VALUE, exponent: null };
  const sign = x < 0 ? MINUS : '';
  if (!Number.isFinite(x)) return { mantissa: `${sign}∞`, exponent: null };
  const { figures, exponent } = significant(Math.abs(x), digits);
  return isWrittenOut(exponent, figures.length, digits)
    ? { mantissa: sign + fixed(figures, exponent), exponent: null }
    : { mantissa: sign + fixed(figures, 0), exponent };
}

/**
 * The digits to show. Zeros at the end stay when they were rounded, so that 5.50860 says "five and
 * a half, and more follows" and 0.72 says 0.72 even if its last bit is off.
 */
function significant(x: number, digits: number): { figures: string; exponent: number } {
  const [short, exponent] = scientific(x, digits);
  const [long] = scientific(x, Math.max(digits, CERTAIN_DIGITS));
  const noiseOnly = long === short.padEnd(long.length, '0');
  return { figures: noiseOnly ? short.replace(/0+$/, '') : short, exponent };
}

/** toExponential rounds the exact value of the double, so no power of ten is rounded on the way. */
function scientific(x: number, digits: number): [figures: string, exponent: number] {
  // Seventeen digits are more than most doubles need: 0.3, not 0.29999999999999999.
  const text = digits < ALL_DIGITS ? x.toExponential(digits - 1) : x.toExponential();
  const [mantissa = '', exponent = ''] = text.split('e');
  return [mantissa.replace('.', '').padEnd(digits, '0'), Number(exponent)];
}

/**
 * Whether a number is written without a power of ten. Not so if zeros would stand for digits that
 * were rounded away: 123456 in three digits is 1.23 · 10⁵, not 123000.
 */
function isWrittenOut(exponent: number, figures: number, digits: number): boolean {
  const hidesDigits = figures === digits && exponent >= digits;
  return exponent >= FIXED_FROM && exponent < Math.max(FIXED_BELOW, digits) && !hidesDigits;
}

/**
 * The figures with the decimal point where `exponent` puts it: ('72', −1) → '0.72', ('1', 5) →
 * '100000'.
 */
function fixed(figures: string, exponent: number): string {
  if (exponent < 0) return `0.${'0'.repeat(-exponent - 1)}${figures}`;
  const whole = figures.slice(0, exponent + 1).padEnd(exponent + 1, '0');
  const fraction = figures.slice(exponent + 1);
  return fraction ? `${whole}.${fraction}` : whole;
}
