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

/** Writes formulas as MathML templates; symbols and the numbers put in for them have colours. */
export const MARKS: Marks<TemplateResult> = {
  join: (parts) => mathml`${parts}`,
  symbol: (id, sort) =>
    mathml`<mi class=${classOf(id, sort)} data-symbol=${highlightOf(id, sort)}>${id}</mi>`,
  component: (id, axis) =>
    mathml`<msub class=${classOf(id, 'vector')}
      data-symbol=${highlightOf(id, 'vector')}><mi>${id}</mi><mi>${axis}</mi></msub>`,
  componentSquared: (id, axis) =>
    mathml`<msubsup class=${classOf(id, 'vector')}
      data-symbol=${highlightOf(id, 'vector')}><mi>${id}</mi><mi>${axis}</mi><mn>2</mn></msubsup>`,
  indexed: (id, index) =>
    mathml`<msub class=${classOf(id, 'scalar')}
      data-symbol=${highlightOf(id, 'scalar')}><mi>${id}</mi><mn>${index}</mn></msub>`,
  numeral: (figures) => mathml`<mn>${figures}</mn>`,
  // At the start of a line a browser would take the operator for a prefix.
  operator: (sign) => mathml`<mo form="infix">${sign}</mo>`,
  minus: mathml`<mo form="prefix">−</mo>`,
  parens: (m) => mathml`<mrow><mo stretchy="false">(</mo>${m}<mo stretchy="false">)</mo></mrow>`,
  bars: (m) =>
    mathml`<mo form="prefix" stretchy="false">|</mo>${m}<mo form="postfix" stretchy="false">|</mo>`,
  fraction: (over, under) => mathml`<mfrac><mrow>${over}</mrow><mrow>${under}</mrow></mfrac>`,
  root: (m) => mathml`<msqrt>${m}</msqrt>`,
  power: (base, exponent) => mathml`<msup><mrow>${base}</mrow><mrow>${exponent}</mrow></msup>`,
  put: (m, id, sort) =>
    mathml`<mrow class=${classOf(id, sort)} data-symbol=${highlightOf(id, sort)}>${m}</mrow>`,
};

/** Cache by tree: most trees stay the same while a slider changes their numbers. */
const inTheirSymbols = new WeakMap<Expr, TemplateResult>();

/** The formula in its symbols. */
export function typesetSymbols(expr: Expr): TemplateResult {
  const known = inTheirSymbols.get(expr);
  if (known) return known;
  const m = inSymbols(expr, MARKS);
  inTheirSymbols.set(expr, m);
  return m;
}

/** The formula with its numbers put in, each with `digits` significant digits. */
export function typesetNumbers(
  expr: Expr,
  values: Values<number>,
  options: { readonly worked: boolean; readonly digits: number },
): TemplateResult {
  return inNumbers(expr, MARKS, values, options);
}

/** The same in pieces between which a line may be broken: terms, or sides of a dot product. */
export function typesetNumbersInPieces(
  expr: Expr,
  values: Values<number>,
  digits: number,
): TemplateResult[] {
  const operators = new Set<TemplateResult>();
  let row: readonly TemplateResult[] = [];
  const marks: Marks<TemplateResult> = {
    ...MARKS,
    operator(sign) {
      const m = MARKS.operator(sign);
      operators.add(m);
      return m;
    },
    join(parts) {
      row = parts;
      return MARKS.join(parts);
    },
  };
  const whole = inNumbers(expr, marks, values, { worked: false, digits });
  if (expr.op !== 'sum' && expr.op !== 'dot') return [whole];
  // A formula is written from the leaves up, so the last joined row is the outermost.
  const pieces: TemplateResult[][] = [[]];
  for (const m of row) {
    if (operators.has(m)) pieces.push([]);
    pieces.at(-1)?.push(m);
  }
  return pieces.map(MARKS.join);
}

export function typesetRelation({ left, relation, right }: Relation): TemplateResult {
  return mathml`${typesetSymbols(left)}<mo>${relation}</mo>${typesetSymbols(right)}`;
}

/** A number in MathML: its sign is an operator, a power of ten has a raised exponent. */
export function typesetNumber(x: number, digits = 6): TemplateResult {
  return mathml`<mrow>${numberPiece(x, MARKS, digits).m}</mrow>`;
}
