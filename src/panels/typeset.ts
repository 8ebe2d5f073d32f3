import { mathml, type TemplateResult } from 'lit';
import {
  type Expr,
  inNumbers,
  inSymbols,
  type Marks,
  numberPiece,
  type Relation,
  type Values,
} from '../math/formula.ts';
import { classOf, highlightOf } from './symbols.ts';

/** Stands before and behind the figures of a number in markup. */
const FIGURES = '\0';

/**
 * Writes formulas as MathML markup; symbols and the numbers put in for them have colours. The names
 * of symbols are the course's: nothing in them is markup.
 */
export const MARKS: Marks<string> = {
  join: (parts) => parts.join(''),
  symbol: (id, sort) => `<mi ${lit(id, sort)}>${id}</mi>`,
  component: (id, axis) => `<msub ${lit(id, 'vector')}>${mi(id)}${mi(axis)}</msub>`,
  componentSquared: (id, axis) =>
    `<msubsup ${lit(id, 'vector')}>${mi(id)}${mi(axis)}<mn>2</mn></msubsup>`,
  indexed: (id, index) => `<msub ${lit(id, 'scalar')}>${mi(id)}<mn>${index}</mn></msub>`,
  numeral: (figures) => `<mn>${FIGURES}${figures}${FIGURES}</mn>`,
  // At the start of a line a browser would take the operator for a prefix.
  operator: (sign) => `${INFIX}${sign.replace('<', '&lt;')}</mo>`,
  minus: '<mo form="prefix">−</mo>',
  parens: (m) => `<mrow><mo stretchy="false">(</mo>${m}<mo stretchy="false">)</mo></mrow>`,
  bars: (m) =>
    `<mo form="prefix" stretchy="false">|</mo>${m}<mo form="postfix" stretchy="false">|</mo>`,
  fraction: (over, under) => `<mfrac><mrow>${over}</mrow><mrow>${under}</mrow></mfrac>`,
  root: (m) => `<msqrt>${m}</msqrt>`,
  power: (base, exponent) => `<msup><mrow>${base}</mrow><mrow>${exponent}</mrow></msup>`,
  put: (m, id, sort) => `<mrow ${lit(id, sort)}>${m}</mrow>`,
};

const INFIX = '<mo form="infix">';

const mi = (id: string): string => `<mi>${id}</mi>`;

const lit = (id: string, sort: 'scalar' | 'vector'): string =>
  `class="${classOf(id, sort)}" data-symbol="${highlightOf(id, sort)}"`;

/** Cache by markup without its figures: Lit knows a template by the identity of its strings. */
const known = new Map<string, TemplateStringsArray>();
/** Lines differ in signs and powers of ten: more than one drag leads to. */
const MOST_KNOWN = 500;

/** Markup as one template; another number is no more than another text in it. */
export function typeset(markup: string): TemplateResult {
  const strings: string[] = [];
  const figures: string[] = [];
  for (const [i, part] of markup.split(FIGURES).entries()) (i % 2 ? figures : strings).push(part);
  const key = strings.join(FIGURES);
  let template = known.get(key);
  if (!template) {
    if (known.size === MOST_KNOWN) known.clear();
    template = Object.assign(strings, { raw: strings });
    known.set(key, template);
  }
  return mathml(template, ...figures);
}

/** Cache by tree: most trees stay the same while a slider changes their numbers. */
const inTheirSymbols = new WeakMap<Expr, TemplateResult>();

/** The formula in its symbols. */
export function typesetSymbols(expr: Expr): TemplateResult {
  const before = inTheirSymbols.get(expr);
  if (before) return before;
  const m = typeset(inSymbols(expr, MARKS));
  inTheirSymbols.set(expr, m);
  return m;
}

/** The formula with its numbers put in, each with `digits` significant digits. */
export function typesetNumbers(
  expr: Expr,
  values: Values<number>,
  options: { readonly worked: boolean; readonly digits: number },
): TemplateResult {
  return typeset(inNumbers(expr, MARKS, values, options));
}

/** The same in pieces between which a line may be broken: terms, or sides of a dot product. */
export function typesetNumbersInPieces(
  expr: Expr,
  values: Values<number>,
  digits: number,
): TemplateResult[] {
  let row: readonly string[] = [];
  const marks: Marks<string> = {
    ...MARKS,
    join(parts) {
      row = parts;
      return MARKS.join(parts);
    },
  };
  const whole = inNumbers(expr, marks, values, { worked: false, digits });
  if (expr.op !== 'sum' && expr.op !== 'dot') return [typeset(whole)];
  // A formula is written from the leaves up, so the last joined row is the outermost.
  const pieces: string[] = [];
  for (const m of row) {
    if (pieces.length === 0 || m.startsWith(INFIX)) pieces.push(m);
    else pieces.push(pieces.pop() + m);
  }
  return pieces.map(typeset);
}

export function typesetRelation({ left, relation, right }: Relation): TemplateResult {
  return mathml`${typesetSymbols(left)}<mo>${relation}</mo>${typesetSymbols(right)}`;
}

/** A number in MathML: its sign is an operator, a power of ten has a raised exponent. */
export function typesetNumber(x: number, digits = 6): TemplateResult {
  return typeset(`<mrow>${numberPiece(x, MARKS, digits).m}</mrow>`);
}
