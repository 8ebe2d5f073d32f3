import { BELOW, BEYOND, Refusal } from './refusal.ts';

const DECIMAL = String.raw`(?:\d+\.?\d*|\.\d+)`;
export const UNSIGNED = String.raw`${DECIMAL}(?:e[+-]?\d+)?`;

const LITERAL = new RegExp(`^[+-]?${UNSIGNED}$`);
/** A power of ten as `display` writes it: '1.2 * 10^7', '-10^7'. */
const POWER_OF_TEN = new RegExp(
  String.raw`^([+-]?)(?:(${DECIMAL})\s*\*\s*)?10\s*\^\s*\(?([+-]?\d+)\)?$`,
);

/** The value of a plain number, correctly rounded (Number does that), or null for anything else. */
export function literal(text: string): number | null {
  if (LITERAL.test(text)) return decimal(text);
  const [, sign = '', mantissa = '1', exponent] = POWER_OF_TEN.exec(text) ?? [];
  return exponent === undefined ? null : decimal(`${sign}${mantissa}e${exponent}`);
}

/** The double; refuses a decimal that would become 0 or infinite. `subject` begins the reason. */
export function decimal(text: string, subject = ''): number {
  const value = Number(text);
  if (!Number.isFinite(value)) throw new Refusal(subject + BEYOND);
  const isZero = !/[1-9]/.test(text.replace(/e.*/, ''));
  if (value === 0 && !isZero) throw new Refusal(subject + BELOW);
  return value;
}
