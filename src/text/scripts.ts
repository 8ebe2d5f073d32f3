const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';
const SUBSCRIPTS = '₀₁₂₃₄₅₆₇₈₉';

/** −7 → '⁻⁷'. For whole numbers. */
export function superscript(n: number): string {
  return scripted(n, SUPERSCRIPTS, '⁻');
}

/** 1 → '₁', for t₁ in a line of text. For whole numbers. */
export function subscript(n: number): string {
  return scripted(n, SUBSCRIPTS, '₋');
}

/** '10⁻⁷' → '10^-7', so that what the page shows can be typed back. */
export function plainPowers(text: string): string {
  return text.replace(
    /([⁺⁻]?)([⁰¹²³⁴⁵⁶⁷⁸⁹]+)/g,
    (_, sign: string, digits: string) =>
      `^${sign === '⁻' ? '-' : ''}${[...digits].map((d) => SUPERSCRIPTS.indexOf(d)).join('')}`,
  );
}

function scripted(n: number, digits: string, minus: string): string {
  return [...String(n)].map((c) => (c === '-' ? minus : digits.charAt(Number(c)))).join('');
}
