export interface Element {
  readonly name: string;
  readonly attributes: Readonly<Record<string, string>>;
  readonly children: readonly (Element | string)[];
}

const TOKEN = /<(\/?)([a-z]+)((?:\s+[\w:-]+="[^"<&]*")*)\s*(\/?)>|([^<]+)/gy;

/**
 * A document that is well-formed XML, of the few kinds of things that ours have in them; throws on
 * anything else.
 */
export function parseXml(text: string): Element {
  const top: Open = { name: '', attributes: {}, children: [] };
  const open: Open[] = [top];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const at = TOKEN.lastIndex;
    const match = TOKEN.exec(text);
    if (!match) throw new Error(`not XML: ${text.slice(at, at + 40)}`);
    const [, closing, name = '', attributes = '', empty, words] = match;
    const inner = open.at(-1) ?? top;
    if (words !== undefined) inner.children.push(unescaped(words));
    else if (closing) {
      if (open.length < 2 || inner.name !== name) throw new Error(`</${name}> in ${inner.name}`);
      open.pop();
    } else {
      const element: Open = { name, attributes: attributesOf(attributes), children: [] };
      inner.children.push(element);
      if (!empty) open.push(element);
    }
  }
  const [root, ...rest] = top.children.filter((c) => typeof c !== 'string' || c.trim() !== '');
  if (open.length > 1) throw new Error(`<${open.at(-1)?.name}> stays open`);
  if (!root || typeof root === 'string' || rest.length > 0) throw new Error('not one root element');
  return root;
}

interface Open extends Element {
  readonly children: (Element | string)[];
}

function attributesOf(text: string): Record<string, string> {
  const pairs = [...text.matchAll(/([\w:-]+)="([^"]*)"/g)].map(([, k = '', v = '']) => [k, v]);
  if (new Set(pairs.map(([k]) => k)).size < pairs.length) throw new Error(`twice in ${text}`);
  return Object.fromEntries(pairs);
}

function unescaped(text: string): string {
  return text.replace(/&(\w*;?)/g, (_, name: string) => {
    const c = { 'amp;': '&', 'lt;': '<', 'gt;': '>' }[name];
    if (!c) throw new Error(`unknown entity &${name}`);
    return c;
  });
}

export const elements = ({ children }: Element): Element[] =>
  children.filter((c): c is Element => typeof c !== 'string');

export function textOf(node: Element | string): string {
  return typeof node === 'string' ? node : node.children.map(textOf).join('');
}

const ARITY: Readonly<Record<string, number>> = { mfrac: 2, msub: 2, msup: 2, msubsup: 3 };
const OPERATORS: Readonly<Record<string, string>> = { '−': '-', '·': '\\cdot', '±': '\\pm' };

/** What a MathML element says, in LaTeX. */
export function asLatex(element: Element): string {
  const { name } = element;
  const parts = elements(element);
  const arity = ARITY[name];
  if (arity !== undefined && parts.length !== arity) throw new Error(`${name} of ${parts.length}`);
  const [a = '', b = '', c = ''] = arity ? parts.map(asLatex) : [];
  if (name === 'mfrac') return `\\frac{${a}}{${b}}`;
  if (name === 'msub') return `${a}_${b}`;
  if (name === 'msup') return `${a}^{${b}}`;
  if (name === 'msubsup') return `${a}_${b}^{${c}}`;
  if (name === 'msqrt') return `\\sqrt{${inner(parts)}}`;
  if (name === 'mi' || name === 'mn') return textOf(element).replace('∞', '\\infty');
  if (name === 'mtext') return `\\text{${textOf(element)}}`;
  if (name === 'mo') {
    const sign = textOf(element);
    if (sign === '|') return element.attributes.form === 'prefix' ? '\\lvert' : '\\rvert';
    return OPERATORS[sign] ?? sign;
  }
  return inner(parts);
}

const inner = (parts: readonly Element[]): string => parts.map(asLatex).join(' ');
