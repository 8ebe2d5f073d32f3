import { html, mathml, nothing, type TemplateResult } from 'lit';
import type { ConditionStep, Derivation, Step } from '../math/derivation.ts';
import type { Values } from '../math/formula/evaluate.ts';
import { type Expr, plus, scalar } from '../math/formula/expr.ts';
import { METHODS } from '../math/methods/index.ts';
import type { Dispatch } from '../state/actions.ts';
import type { ExploreModel } from '../state/derive.ts';
import type { Comparison, Piece } from '../state/verdict-parts.ts';
import { display } from '../text/format.ts';
import { formula } from './formula.ts';
import { hitTable } from './hits.ts';
import { digitsFor } from './room.ts';
import {
  typesetNumbers,
  typesetNumbersInPieces,
  typesetRelation,
  typesetSymbols,
} from './typeset.ts';
import { value } from './value.ts';
import './algebra.css';

/** From the surface's equation to the roots: symbols, numbers put in, value; the case in words; the hits. */
export function algebra(model: ExploreModel, dispatch: Dispatch): TemplateResult {
  const { derivation, title, shown } = model;
  return html`<section class="algebra" aria-label="Algebra">
    <div class="put-in">
      <p class="lead"><span class="words">Put the ray into the ${title}:</span> ${formula(mathml`<mi>f</mi><mo stretchy="false">(</mo><mi>t</mi><mo stretchy="false">)</mo><mo>=</mo>${typesetSymbols(derivation.f)}<mo>=</mo><mn>0</mn>`)}</p>
      ${methodPicker(model, dispatch)}
    </div>
    <div class="steps">
      ${derivation.steps.map((step, i) => stepLine(step, derivation, i < shown.steps))}
      ${shown.conditions ? conditions(derivation) : nothing}
    </div>
    ${shown.verdict ? verdict(model) : concealed()}
    ${shown.hits ? hitTable(model) : html`<div class="hits"></div>`}
  </section>`;
}

function methodPicker({ state }: ExploreModel, dispatch: Dispatch): TemplateResult {
  const pick = (event: Event) =>
    dispatch({ type: 'method', id: (event.target as HTMLSelectElement).value });
  return html`<label class="method">by
    <select @change=${pick} .value=${state.method}>
      ${METHODS.map(
        ({ id, title, idea }) =>
          html`<option value=${id} title=${idea} ?selected=${id === state.method}>${title}</option>`,
      )}
    </select></label>`;
}

/** Hidden, a line keeps its formula and its place, but not its numbers. */
function stepLine(step: Step, { numbers }: Derivation, shown: boolean): TemplateResult {
  const { id, letter, expr, worked } = step;
  const stacked = id !== 'D' && id !== 't';
  const symbols = formula(typesetSymbols(expr), id === 't');
  // With −B, √D and 2A worked out there is always room.
  const { digits, long } = worked
    ? { digits: 6, long: false }
    : digitsFor(expr, numbers, stacked ? 'below' : 'behind');
  const inNumbers = long
    ? typesetNumbersInPieces(expr, numbers, digits).map((m) => html`${formula(m)} `)
    : formula(typesetNumbers(expr, numbers, { worked, digits }), id === 't');
  return html`<div class="step ${stacked ? 'stacked' : 'inline'}" data-step=${id}>
    <span class="letter" data-symbol=${letter ? `coefficient-${id}` : nothing}>${letter ? formula(typesetSymbols(letter)) : nothing}</span>
    <span class="equals">${letter ? '=' : ''}</span>
    <span class="body">
      <span class="in-symbols">${symbols}</span>
      ${stacked || !shown ? nothing : html`<span class="equals">=</span>`}
      <span class=${long ? 'in-numbers long' : 'in-numbers'}>${shown ? inNumbers : '?'}</span>
    </span>
    ${
      step.value === null || !shown
        ? nothing
        : html`<span class="equals">=</span><span class="result" data-symbol=${letter ? `coefficient-${id}` : nothing}>${
            Number.isNaN(step.value) ? 'no value' : value(id, step.value)
          }</span>`
    }
  </div>`;
}

/** Two in a line where the numbers are short enough. */
function conditions(derivation: Derivation): TemplateResult {
  const { conditions: all, numbers } = derivation;
  const halves = all.every(
    ({ relation: { left, right } }) => !digitsFor(plus(left, right), numbers, 'half').long,
  );
  return html`<div class=${all.length > 1 && halves ? 'conditions halves' : 'conditions'}>
    ${all.map((c) => conditionLine(c, derivation))}
  </div>`;
}

const putIn = (expr: Expr, numbers: Values<number>): TemplateResult =>
  typesetNumbers(expr, numbers, { worked: false, digits: 5 });

function conditionLine(
  { relation, left, right, holds }: ConditionStep,
  { numbers }: Derivation,
): TemplateResult {
  const words = holds === null ? 'cannot tell' : holds ? 'holds' : 'fails';
  const put =
    relation.left.op === 'norm'
      ? html`${value('distance', left)} ≤ ${display(right)}`
      : formula(
          mathml`${putIn(relation.left, numbers)}<mo>≤</mo>${putIn(relation.right, numbers)}`,
        );
  return html`<div class="condition" data-holds=${String(holds)}>
    <span class="in-symbols">${formula(typesetRelation(relation))}</span>
    <span class="in-numbers">${put}</span>
    <span class="holds">${words}</span>
  </div>`;
}

function verdict({
  verdict: { relations, pieces },
  found,
  contradicted,
  derivation,
}: ExploreModel): TemplateResult {
  return html`<p class="verdict">
    <span data-quantity="class" data-value=${found.class}>${relations.map((relation, i) => comparison(relation, i, derivation))}
    <strong>${pieces.map(said)}</strong></span>
    ${contradicted ? html`<span class="contradicted">exact arithmetic says: ${contradicted}</span>` : nothing}
  </p>`;
}

const said = (piece: Piece): TemplateResult | string =>
  typeof piece === 'string' ? piece : value(piece.quantity, piece.value);

function concealed(): TemplateResult {
  return html`<p class="verdict">Hidden. Predict first, then reveal line by line.</p>`;
}

/** A step's name stands for its own tree: N·(E − P), or N·(E − C) for a circle. */
function comparison(
  { left, relation, right }: Comparison,
  i: number,
  { steps }: Derivation,
): TemplateResult {
  const step = steps.find(({ id }) => id === left);
  const side = typesetSymbols(step?.letter ?? step?.expr ?? scalar(left));
  return html`${i > 0 ? ', ' : nothing}${formula(mathml`${side}<mo>${relation}</mo><mn>${right}</mn>`)}`;
}
