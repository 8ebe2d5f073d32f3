import { html, mathml, nothing, type TemplateResult } from 'lit';
import type { DerivationLine } from '../check/lines.ts';
import { type Expr, evaluate, float64, type Relation } from '../math/formula.ts';
import { comparableDigits, type PutIn, putInSideBySide, valuesAsResults } from '../state/put-in.ts';
import { display } from '../text/format.ts';
import { formula } from './formula.ts';
import {
  typesetNumber,
  typesetNumbers,
  typesetNumbersInPieces,
  typesetRelation,
  typesetSymbols,
} from './typeset.ts';
import './check-lines.css';

/** In symbols only, as in a hint, or also with numbers put in and the value. */
type Layer = 'symbols' | 'numbers';

/** Lines of a derivation, one under the other; each may break between its layers. */
export function derivationLines(lines: readonly DerivationLine[], layer: Layer): TemplateResult {
  return html`<ul class="lines" tabindex="0"
    aria-label="Lines of the derivation">${lines.map(
      (line) => html`<li
      data-line=${line.id}>${written(line, layer)}</li>`,
    )}</ul>`;
}

function written(line: DerivationLine, layer: Layer): TemplateResult {
  const { letter, exprs, relation, holds, values, numbers, worked } = line;
  const put = putIntoLine(line);
  const digits = put?.digits ?? 6;
  const sign = put?.isFaithful === false ? '≈' : '=';
  if (relation) {
    const side = (expr: Expr) => typesetNumbers(expr, numbers, { worked: false, digits });
    const rounded = sign === '≈' ? 'rounded: ' : '';
    return html`${formula(typesetRelation(relation))}${
      layer === 'symbols'
        ? nothing
        : html` <span
          class="put-in">${rounded}${formula(mathml`${side(relation.left)}<mo
          >${relation.relation}</mo>${side(relation.right)}`)}</span>${
            values.length === 2 && holds !== null
              ? html` <span
              class="result">${sides(relation, values, holds)}</span>`
              : nothing
          }`
    }`;
  }
  const name = letter ? mathml`${typesetSymbols(letter)}<mo>=</mo>` : nothing;
  const symbols = formula(mathml`${name}${row(exprs.map(typesetSymbols))}`);
  if (layer === 'symbols') return symbols;
  if (put === null) return html`${symbols} <span class="put-in">${BEYOND}</span>`;
  const equals = mathml`<mo form="infix">${sign}</mo>`;
  const [only, ...others] = exprs;
  if (only && others.length === 0 && !worked) {
    const pieces = typesetNumbersInPieces(only, numbers, digits);
    return html`${symbols} <span
      class="put-in">${pieces.map(
        (piece, i) => html`${formula(i === 0 ? mathml`${equals}${piece}` : piece)} `,
      )}</span>
      <span class="result">${result(line, sign)}</span>`;
  }
  const all = row(exprs.map((expr) => typesetNumbers(expr, numbers, { worked, digits })));
  return html`${symbols} <span class="put-in">${formula(mathml`${equals}${all}`)}</span>
    <span class="result">${result(line, sign)}</span>`;
}

const BEYOND = 'a number of it is beyond the doubles';

/** The digits with which the line gives its results; a line without shown results, its value. */
export function putIntoLine({
  exprs,
  relation,
  values,
  numbers,
  worked,
}: DerivationLine): PutIn | null {
  const trees = relation ? [relation.left, relation.right] : exprs;
  const [only, ...others] = trees;
  const ends = values.length === 0 && !relation ? worths(trees, numbers) : values;
  const isOne = only !== undefined && others.length === 0;
  const lines = isOne
    ? [{ expr: only, results: resultsIn(ends, numbers) }]
    : trees.map((expr, i) => ({ expr, results: resultsIn(ends.slice(i, i + 1), numbers) }));
  return putInSideBySide(lines, numbers, worked);
}

const resultsIn = (ends: readonly number[], { scalars }: DerivationLine['numbers']) =>
  valuesAsResults(ends, scalars.A).filter(({ value }) => Number.isFinite(value));

/** The value of each tree; for ± both, the smaller one first. */
function worths(trees: readonly Expr[], numbers: DerivationLine['numbers']): number[] {
  return trees.flatMap((tree) =>
    [...new Set(([1, -1] as const).map((branch) => evaluate(tree, float64, numbers, branch)))].sort(
      (a, b) => a - b,
    ),
  );
}

/** "that is 6.5 ≤ 6: false" */
function sides({ relation }: Relation, values: readonly number[], holds: boolean): TemplateResult {
  const [left = 0, right = 0] = values;
  const digits = comparableDigits(left, right, holds) ?? 6;
  return html`that is ${formula(
    mathml`${typesetNumber(left, digits)}<mo>${relation}</mo>${typesetNumber(right, digits)}`,
  )}: ${holds ? 'true' : 'false'}`;
}

/** One tree by itself, three as a triple. */
function row(parts: readonly TemplateResult[]): TemplateResult {
  const [only, ...others] = parts;
  if (only && others.length === 0) return only;
  return mathml`<mo
    stretchy="false">(</mo>${parts.map(
      (part, i) => mathml`${i > 0 ? mathml`<mo>,</mo>` : nothing}${part}`,
    )}<mo stretchy="false">)</mo>`;
}

function result({ id, values, exprs }: DerivationLine, sign: '=' | '≈'): TemplateResult | string {
  const equals = mathml`<mo form="infix">${sign}</mo>`;
  if (values.length === 0) return formula(mathml`${equals}<mtext>?</mtext>`);
  if (values.some(Number.isNaN)) return '= no value';
  if (exprs.length > 1)
    return formula(mathml`${equals}${row(values.map((x) => typesetNumber(x)))}`);
  if (id === 't' && values.length > 1) {
    return `: t₁ ${sign} ${display(values[0] ?? 0)}, t₂ ${sign} ${display(values[1] ?? 0)}`;
  }
  return formula(mathml`${equals}${typesetNumber(values[0] ?? 0)}`);
}
