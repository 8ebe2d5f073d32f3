import { plainPowers } from '../../../text/scripts.ts';
import type { Marks, Sign } from './math-notation.ts';

const OPERATORS: Readonly<Record<Sign, string>> = {
  '+': ' + ',
  '−': ' - ',
  '±': ' \\pm ',
  '·': ' \\cdot ',
  ',': ', ',
  '=': ' = ',
  '≈': ' \\approx ',
  '≠': ' \\ne ',
  '<': ' < ',
  '>': ' > ',
  '≤': ' \\le ',
};

const NAMED: Readonly<Record<string, string>> = {
  α: '\\alpha',
  λ: '\\lambda',
  μ: '\\mu',
  tan: '\\tan',
  '°': '^\\circ',
};

const symbol = (id: string): string => NAMED[id] ?? (id.length === 1 ? id : `\\mathrm{${id}}`);

/** Mathematics in LaTeX; amsmath is enough for all of it. */
export const LATEX: Marks<string> = {
  join: sideBySide,
  symbol,
  component: (vector, axis) => `${symbol(vector)}_${axis}`,
  componentSquared: (vector, axis) => `${symbol(vector)}_${axis}^2`,
  indexed: (id, index) => `${symbol(id)}_{${index}}`,
  numeral: (figures) => {
    if (figures === '∞') return '\\infty';
    return /^[\d.]+$/.test(figures) ? figures : `\\text{${figures}}`;
  },
  operator: (sign) => OPERATORS[sign],
  minus: '-',
  // Only a fraction is taller than plain parentheses.
  parens: (m) => (m.includes('\\frac') ? `\\left(${m}\\right)` : `(${m})`),
  bars: (m) => `\\lvert ${m} \\rvert`,
  fraction: (over, under) => `\\frac{${over}}{${under}}`,
  root: (m) => `\\sqrt{${m}}`,
  power: (base, exponent) => `${base}^{${exponent}}`,
  put: (m) => m,
};

/** With a space between a command and a letter, which would become part of its name. */
function sideBySide(parts: readonly string[]): string {
  return parts.reduce((text, part) => {
    const glued = /\\[a-z]+$/i.test(text) && /^[a-z]/i.test(part);
    return glued ? `${text} ${part}` : text + part;
  }, '');
}

const ESCAPED: Readonly<Record<string, string>> = {
  '\\': '\\textbackslash{}',
  '^': '\\textasciicircum{}',
  '~': '\\textasciitilde{}',
  '−': '$-$',
  '·': '$\\cdot$',
  '∞': '$\\infty$',
  '√': '$\\surd$',
  '≤': '$\\le$',
  '≥': '$\\ge$',
  '≠': '$\\ne$',
  '≈': '$\\approx$',
  '±': '$\\pm$',
  '’': "'",
};

/**
 * Words of the page inside of \text{}: nothing but ASCII, so that it does not matter which engine
 * sets it.
 *
 * @param words any text of the page.
 * @example
 * latexText('5 % of t²'); // → '\\text{5 \\% of t$^{2}$}'
 */
export function latexText(words: string): string {
  const escaped = words
    .replace(/[\\^~−·∞√≤≥≠≈±’&%#_{}$]/g, (c) => ESCAPED[c] ?? `\\${c}`)
    .replace(/[⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+/g, (run) => `$^{${plainPowers(run).slice(1)}}$`)
    .replace(/[₀-₉]+/g, (run) => `$_{${[...run].map((d) => '₀₁₂₃₄₅₆₇₈₉'.indexOf(d)).join('')}}$`);
  return `\\text{${escaped}}`;
}
