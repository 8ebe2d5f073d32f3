import type { Marks } from './math-notation.ts';

const NAMESPACE = 'http://www.w3.org/1998/Math/MathML';

const bar = (form: 'prefix' | 'postfix'): string => `<mo form="${form}" stretchy="false">|</mo>`;

/**
 * Mathematics as a MathML string. Each piece is a run of elements; where one is needed it goes into
 * an mrow.
 */
export const MATHML: Marks<string> = {
  join: (parts) => parts.join(''),
  symbol: mi,
  component: (vector, axis) => `<msub>${mi(vector)}${mi(axis)}</msub>`,
  componentSquared: (vector, axis) => `<msubsup>${mi(vector)}${mi(axis)}<mn>2</mn></msubsup>`,
  indexed: (id, index) => `<msub>${mi(id)}<mn>${index}</mn></msub>`,
  numeral: (figures) => {
    if (figures === '∞') return '<mi>∞</mi>';
    return /^[\d.]+$/.test(figures) ? `<mn>${figures}</mn>` : mathmlText(figures);
  },
  operator: (sign) => `<mo>${escapeXml(sign)}</mo>`,
  minus: '<mo form="prefix">−</mo>',
  parens: (m) => `<mrow><mo stretchy="false">(</mo>${m}<mo stretchy="false">)</mo></mrow>`,
  bars: (m) => `<mrow>${bar('prefix')}${m}${bar('postfix')}</mrow>`,
  fraction: (over, under) => `<mfrac>${mrow(over)}${mrow(under)}</mfrac>`,
  root: (m) => `<msqrt>${m}</msqrt>`,
  power: (base, exponent) => `<msup>${mrow(base)}${mrow(exponent)}</msup>`,
  put: (m) => m,
};

/**
 * A document of its own, to be saved or pasted into a page.
 *
 * @param content MathML elements, as `inSymbols` makes them.
 * @example
 * mathmlDocument('<mi>t</mi>');
 * // → '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mi>t</mi></math>'
 */
export function mathmlDocument(content: string): string {
  return `<math xmlns="${NAMESPACE}" display="block">${content}</math>`;
}

/**
 * Words between formulas.
 *
 * @param words any text; what means something in XML is escaped.
 * @example
 * mathmlText('A < 0'); // → '<mtext>A &lt; 0</mtext>'
 */
export function mathmlText(words: string): string {
  return `<mtext>${escapeXml(words)}</mtext>`;
}

function escapeXml(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}

function mi(id: string): string {
  return `<mi>${escapeXml(id)}</mi>`;
}

function mrow(m: string): string {
  return `<mrow>${m}</mrow>`;
}
