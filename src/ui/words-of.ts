/** What is read where it stands, and not told of: controls, and lines to walk through. */
const READ_THERE = 'button, input, select, textarea, progress, meter, [tabindex]';
const BLOCK = /^(?:block|flex|grid|list-item|table|table-row)$/;

/** An element's text as it is to be heard: a sentence a block, and formulas in words. */
export const wordsOf = (element: Element): string =>
  spoken(element)
    .replace(/\s+/g, ' ')
    .replace(/\s([.,:;!?)])/g, '$1')
    .trim();

function spoken(node: Node): string {
  if (node.nodeType === Node.TEXT_NODE) return node.nodeValue ?? '';
  if (!(node instanceof Element) || node.matches('[aria-hidden="true"]')) return '';
  const { display } = getComputedStyle(node);
  if (display === 'none') return '';
  if (node.matches(READ_THERE)) return sentence(node.getAttribute('aria-label') ?? '');
  const parts = [...node.childNodes].map(spoken);
  const math = FORMULAS[node.localName];
  if (math) return math(parts.filter((part) => part.trim() !== ''));
  const text = parts.join('');
  return BLOCK.test(display) ? sentence(text) : text;
}

function sentence(text: string): string {
  const words = text.trim();
  if (words === '') return ' ';
  return ` ${words}${/[.,:;!?…]$/.test(words) ? '' : '.'} `;
}

type Parts = readonly string[];

const raised = (base = '', power = ''): string =>
  power.trim() === '2' ? `${base} squared` : `${base} to the power ${power}`;

/** MathML's elements that are not read as a row of their parts. */
const FORMULAS: Readonly<Record<string, (parts: Parts) => string>> = {
  math: (parts) => ` ${parts.join(' ')} `,
  mrow: (parts) => parts.join(' '),
  mfrac: ([over, under]) => `${over} over ${under}`,
  msqrt: (parts) => `the root of ${parts.join(' ')}`,
  msub: (parts) => parts.join(''),
  msup: ([base, power]) => raised(base, power),
  msubsup: ([base, index, power]) => raised(`${base}${index}`, power),
};
