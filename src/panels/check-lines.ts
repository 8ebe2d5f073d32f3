import { html, mathml, nothing, type TemplateResult } from 'lit';
import type { Line } from '../check/lines.ts';
import type { Expr, Relation } from '../math/formula/expr.ts';
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

/** Symbols only (a hint), or with the numbers put in and the value behind. */
export type Layer = 'symbols' | 'numbers';

/** Lines of a derivation, one under the other; each may break between its layers. */
export function derivationLines(lines: readonly Line[], layer: Layer): TemplateResult {
  return html`<ul class="lines" tabindex="0" aria-label="Lines of the derivation">${lines.map((line) => html`<li data-line=${line.id}>${written(line, layer)}</li>`)}</ul>`;
}

function written(line: Line, layer: Layer): TemplateResult {
  const { letter, exprs, relation, holds, values, numbers, worked } = line;
  if (relation) {
    const put = (expr: Expr) => typesetNumbers(expr, numbers, { worked: false, digits: 6 });
    return html`${formula(typesetRelation(relation))}${
      layer === 'symbols'
        ? nothing
        : html` <span class="put-in">${formula(mathml`${put(relation.left)}<mo>${relation.relation}</mo>${put(relation.right)}`)}</span>${values.length === 2 && holds !== null ? html` <span class="result">${sides(relation, values, holds)}</span>` : nothing}`
    }`;
  }
  const name = letter ? mathml`${typesetSymbols(letter)}<mo>=</mo>` : nothing;
  const symbols = formula(mathml`${name}${row(exprs.map(typesetSymbols))}`);
  if (layer === 'symbols') return symbols;
  const [only, ...others] = exprs;
  if (only && others.length === 0 && !worked) {
    const pieces = typesetNumbersInPieces(only, numbers, 6);
    return html`${symbols} <span class="put-in">${pieces.map((piece, i) => html`${formula(i === 0 ? mathml`<mo form="infix">=</mo>${piece}` : piece)} `)}</span>
      <span class="result">${result(line)}</span>`;
  }
  const put = row(exprs.map((expr) => typesetNumbers(expr, numbers, { worked, digits: 6 })));
  return html`${symbols} <span class="put-in">${formula(mathml`<mo form="infix">=</mo>${put}`)}</span>
    <span class="result">${result(line)}</span>`;
}

/** "that is 6.5 ≤ 6: false" */
function sides({ relation }: Relation, values: readonly number[], holds: boolean): TemplateResult {
  const [left = 0, right = 0] = values;
  return html`that is ${formula(mathml`${typesetNumber(left)}<mo>${relation}</mo>${typesetNumber(right)}`)}: ${holds ? 'true' : 'false'}`;
}

/** One tree as it is, three as a triple. */
function row(parts: readonly TemplateResult[]): TemplateResult {
  const [only, ...others] = parts;
  if (only && others.length === 0) return only;
  return mathml`<mo stretchy="false">(</mo>${parts.map((part, i) => mathml`${i > 0 ? mathml`<mo>,</mo>` : nothing}${part}`)}<mo stretchy="false">)</mo>`;
}

function result({ id, values, exprs }: Line): TemplateResult | string {
  if (values.length === 0) return formula(mathml`<mo form="infix">=</mo><mtext>?</mtext>`);
  if (values.some(Number.isNaN)) return '= no value';
  if (exprs.length > 1)
    return formula(mathml`<mo form="infix">=</mo>${row(values.map((x) => typesetNumber(x)))}`);
  if (id === 't' && values.length > 1) {
    return `: t₁ = ${display(values[0] ?? 0)}, t₂ = ${display(values[1] ?? 0)}`;
  }
  return formula(mathml`<mo form="infix">=</mo>${typesetNumber(values[0] ?? 0)}`);
}
