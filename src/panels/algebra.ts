import { html, mathml, nothing, type TemplateResult } from 'lit';
import { guard } from 'lit/directives/guard.js';
import {
  type ConditionStep,
  type Derivation,
  type Expr,
  plus,
  type Step,
  scalar,
  walkLength,
} from '../math/formula.ts';
import { METHODS } from '../math/index.ts';
import type { Dispatch } from '../state/actions.ts';
import type { AsTyped } from '../state/as-typed.ts';
import type { ExploreModel } from '../state/derive.ts';
import type { NumberSpace } from '../state/number-space.ts';
import type { PutIn } from '../state/put-in.ts';
import type { Comparison, Piece } from '../state/verdict-parts.ts';

import type { VerdictWords } from '../state/verdict-words.ts';

import { rootTexts } from '../text/distinguish.ts';

import { display } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import { formula } from './formula.ts';
import { hitTable, was } from './hits.ts';
import {
  typesetNumbers,
  typesetNumbersInPieces,
  typesetRelation,
  typesetSymbols,
} from './typeset.ts';
import { value } from './value.ts';
import './algebra.css';
import './normal-line.css';

/** For the line of N, as long as its code is not loaded. */
const ROOM = html`<div class="step normal-line"></div>`;

/**
 * The surface's equation, each step in symbols and numbers with its value, the verdict, the hits.
 * `normalLine` writes the line of N; null for room for it, left out for none. `ends` writes what
 * the shape's ends do.
 */
export function algebra(
  model: ExploreModel,
  dispatch: Dispatch,
  normalLine?: ((model: ExploreModel, dispatch: Dispatch) => TemplateResult) | null,
  ends?: ((model: ExploreModel, dispatch: Dispatch) => unknown) | null,
): TemplateResult {
  const { derivation, title, shown, found, exactly, digits } = model;
  const whyCondition = (i: number) => why(`condition ${i + 1}`, walkLength(model.shape), dispatch);
  const note = shown.verdict && digits?.rangeNote(derivation, found, exactly);
  const equation = mathml`<mi>f</mi><mo stretchy="false">(</mo><mi>t</mi><mo
    stretchy="false">)</mo><mo>=</mo>${typesetSymbols(derivation.f)}<mo>=</mo><mn>0</mn>`;
  return html`<section class="algebra" aria-label="Algebra">
    <div class="put-in" role="group" aria-label="Derivation and method">
      <p class="lead"><span class="words">Put into the ${title}:</span>
        ${formula(equation)}</p>
      <button type="button" class="derive"
        title="Where these lines come from (d)"
        @click=${() => dispatch({ type: 'derive', step: 1 })}>derive</button>
      <label class="in-full"><input type="checkbox" />in full</label>
      ${methodPicker(model, dispatch)}
    </div>
    <div class="steps" role="group" aria-label="Lines">
      ${derivation.steps.map((step, i) => stepLine(step, model, i < shown.steps, dispatch))}
      ${normalLine === undefined ? nothing : (normalLine?.(model, dispatch) ?? ROOM)}
      ${shown.conditions ? conditions(derivation, digits, whyCondition) : nothing}
      ${note ? html`<p class="beside">${note}</p>` : nothing}
    </div>
    ${shown.verdict ? verdict(model, dispatch) : concealed(model)}
    ${shown.hits ? hitTable(model) : html`<div class="hits"></div>`}
    ${shown.hits ? ends?.(model, dispatch) : nothing}
  </section>`;
}

function methodPicker({ state }: ExploreModel, dispatch: Dispatch): unknown {
  const pick = (event: Event) =>
    dispatch({ type: 'method', id: (event.target as HTMLSelectElement).value });
  return guard(
    [state.method],
    () => html`<label class="method">by
    <select @change=${pick} .value=${state.method}>
      ${METHODS.map(
        ({ id, title, idea }) =>
          html`<option value=${id} title=${idea}
            ?selected=${id === state.method}>${title}</option>`,
      )}
    </select></label>
    ${methodWords(state.method)}`,
  );
}

/** The chosen method's title, idea and promise. */
function methodWords(chosen: string): TemplateResult | typeof nothing {
  const method = METHODS.find(({ id }) => id === chosen);
  if (!method) return nothing;
  const { title, idea, promise } = method;
  const close = ({ key, currentTarget }: KeyboardEvent): void => {
    if (key === 'Escape') (currentTarget as HTMLDetailsElement).open = false;
  };
  return html`<details class="method-words" @keydown=${close}>
    <summary aria-label=${`What ${title} means`}>?</summary>
    <p><strong>${title}</strong>: ${idea} Promise: ${promise}</p>
  </details>`;
}

/** A step's line. A hidden one keeps its formula and its height, but not its numbers. */
function stepLine(
  step: Step,
  model: ExploreModel,
  shown: boolean,
  dispatch: Dispatch,
): TemplateResult {
  const { id, letter, expr } = step;
  const line = shown ? numbersOf(step, model) : null;
  const stacked = id !== 't' && (id !== 'D' || line?.below === true);
  const symbols = formula(typesetSymbols(expr), id === 't');
  const sign = line?.isFaithful === false ? '≈' : '=';
  const look = line?.long ? 'stacked wide' : stacked ? 'stacked' : 'inline';
  return html`<div class="step ${look}" data-step=${id}>
    <span class="letter" data-symbol=${letter ? `coefficient-${id}` : nothing}>${
      letter ? formula(typesetSymbols(letter)) : nothing
    }${why(id, step.why, dispatch)}</span>
    <span class="equals">${letter ? '=' : ''}</span>
    <span class="body">
      <span class="in-symbols">${symbols}</span>
      ${stacked || line === null ? nothing : html`<span class="equals">${sign}</span>`}
      ${line === null ? html`<span class="in-numbers">?</span>` : line.content}
    </span>
    ${
      step.value === null || !shown
        ? nothing
        : html`<span class="equals">${sign}</span>${result(step, step.value, model)}`
    }
  </div>`;
}

/** A button that opens the walk at the step that derives the line. */
const why = (id: string, step: number, dispatch: Dispatch): TemplateResult =>
  html`<button type="button" class="why" aria-label=${`why ${id}`}
    @click=${() => dispatch({ type: 'derive', step })}>why</button>`;

interface NumbersLine {
  readonly content: TemplateResult;
  readonly below: boolean;
  readonly long: boolean;
  readonly isFaithful: boolean;
}

type Digits = NonNullable<ExploreModel['digits']>;
type Chosen = (PutIn & { readonly space: NumberSpace | null }) | null;

/** Cache by step, since the page is drawn more often than a step's numbers change. */
const chosenBefore = new WeakMap<Step, Chosen>();

function chosen(
  step: Step,
  { derivation, found, exactly }: ExploreModel,
  { fitsInto, putIn, resultsOf, spacesOf }: Digits,
): Chosen {
  const before = chosenBefore.get(step);
  if (before !== undefined) return before;
  const results = resultsOf(step, found, exactly);
  const now = putIn(step, derivation, results, spacesOf(step), (digits, space) =>
    fitsInto(step, derivation.numbers, digits, space),
  );
  chosenBefore.set(step, now);
  return now;
}

/** The formula with its numbers put in; words if one of them is not finite. */
function numbersOf(step: Step, model: ExploreModel): NumbersLine {
  const { derivation, digits: code } = model;
  const { id, expr, worked } = step;
  const { numbers } = derivation;
  if (code === null) {
    // Keeps the line's height until the numbers are loaded.
    const content = html`<span class="in-numbers">\u00a0</span>`;
    return { content, below: !worked && id !== 'D', long: false, isFaithful: true };
  }
  const put = chosen(step, model, code);
  if (put === null) {
    const words = 'a number of it is beyond the doubles';
    const content = html`<span class="in-numbers words">${words}</span>`;
    return { content, below: id === 'D', long: false, isFaithful: true };
  }
  const { digits, isFaithful, space } = put;
  const { long, below } = space ?? code.LONG;
  const sign = !isFaithful && below ? html`≈ ` : nothing;
  const content = below
    ? html`<span class=${long ? 'in-numbers long' : 'in-numbers'}>${sign}${typesetNumbersInPieces(
        expr,
        numbers,
        digits,
      ).map((m) => html`${formula(m)} `)}</span>`
    : html`<span class="in-numbers">${formula(
        typesetNumbers(expr, numbers, { worked, digits }),
        id === 't',
      )}</span>`;
  return { content, below, long, isFaithful };
}

/** The method's value, and beside it the exact digits if they differ. */
function result(
  { id, letter }: Step,
  x: number,
  { found, exactly, digits, before }: ExploreModel,
): TemplateResult {
  const { text = null, beside = null } = digits?.shownResult(id, x, found, exactly) ?? {};
  return html`<span class="result"
    data-symbol=${letter ? `coefficient-${id}` : nothing}>${was(before[id], x)}${value(id, x, {
      text,
    })}${beside ? html`<span class="beside">${beside}</span>` : nothing}</span>`;
}

/** Digits of a line until the code that chooses them is loaded. */
const UNCHECKED: PutIn = { digits: 6, isFaithful: true };

/** The conditions of a figure; two share a line if their numbers are short enough. */
export function conditions(
  derivation: Derivation,
  code: Digits | null,
  why: (i: number) => unknown = () => nothing,
): TemplateResult {
  const { conditions: all, numbers } = derivation;
  const halves = all.every(
    ({ relation: { left, right } }) => code?.isHalf(plus(left, right), numbers) !== false,
  );
  return html`<div class=${all.length > 1 && halves ? 'conditions halves' : 'conditions'}>
    ${all.map((c, i) => conditionLine(c, derivation, code, why(i)))}
  </div>`;
}

function conditionLine(
  condition: ConditionStep,
  { numbers }: Derivation,
  code: Digits | null,
  why: unknown,
): TemplateResult {
  const { relation, left, right, holds } = condition;
  const words = holds === null ? 'cannot tell' : holds ? 'holds' : 'fails';
  const { digits, isFaithful } = code?.conditionDigits(condition, numbers) ?? UNCHECKED;
  const putIn = (expr: Expr): TemplateResult =>
    typesetNumbers(expr, numbers, { worked: false, digits });
  const sides =
    relation.left.op === 'norm'
      ? html`${value('distance', left, { digits })} ≤ ${display(right, digits)}`
      : formula(mathml`${putIn(relation.left)}<mo>≤</mo>${putIn(relation.right)}`);
  return html`<div class="condition" data-holds=${String(holds)}>
    ${why}<span class="in-symbols">${formula(typesetRelation(relation))}</span>
    <span class="in-numbers">${isFaithful ? nothing : 'rounded: '}${sides}</span>
    <span class="holds">${words}</span>
  </div>`;
}

function verdict(model: ExploreModel, dispatch: Dispatch): TemplateResult {
  const { verdict, found, contradicted, derivation, exactly, near, asTyped } = model;
  const find = near?.find;
  const { relations, pieces } = verdict;
  const at = (): string =>
    rootTexts(exactly.found.hits.map(({ t }) => t))
      .map((text, i) => `, t${subscript(i + 1)} = ${text}`)
      .join('');
  const stored = asTyped.differs ? ' on the stored numbers' : '';
  return html`<p class="verdict">
    <span data-quantity="class" data-value=${found.class}>${relations.map((relation, i) =>
      comparison(relation, i, derivation),
    )}
    <strong>${pieces.map(said)}</strong></span>
    ${
      contradicted
        ? html`<span class="contradicted">exact arithmetic${stored} says: ${contradicted}${at()}${
            near ? `; ${near.text}` : ''
          }</span>`
        : nothing
    }
    ${
      find
        ? html`<button type="button" class="touch" title=${near.reason}
            @click=${() => dispatch({ type: 'tangent', find })}>Make it exactly tangent</button>`
        : nothing
    }
  </p>
  ${typedWords(asTyped)}`;
}

/** The verdict for the numbers as typed, if it differs, and notes on them. */
function typedWords({ differs, notes }: AsTyped): TemplateResult | typeof nothing {
  if (!differs && notes.length === 0) return nothing;
  const pieces = (words: VerdictWords, which: string): (TemplateResult | string)[] =>
    words.pieces.map((piece) =>
      typeof piece === 'string' ? piece : value(`${which}.${piece.quantity}`, piece.value),
    );
  return html`<p class="as-typed">
    ${
      differs
        ? html`As typed: <strong data-quantity="typed.class" data-value=${differs.class}>${pieces(
            differs.typed,
            'typed',
          )}</strong>. As stored (${differs.because}): ${pieces(differs.stored, 'stored')}.`
        : nothing
    }
    ${notes.join(' ')}
  </p>`;
}

const said = (piece: Piece): TemplateResult | string =>
  typeof piece === 'string' ? piece : value(piece.quantity, piece.value);

function concealed({ waiting }: ExploreModel): TemplateResult {
  const words = waiting ? '' : 'Hidden. Predict first, then reveal line by line.';
  return html`<p class="verdict">${words}</p>`;
}

/** A relation of the verdict; a step's name is shown as its tree, N·(E − C) for a circle. */
function comparison(
  { left, relation, right }: Comparison,
  i: number,
  { steps }: Derivation,
): TemplateResult {
  const step = steps.find(({ id }) => id === left);
  const side = typesetSymbols(step?.letter ?? step?.expr ?? scalar(left));
  const line = mathml`${side}<mo>${relation}</mo><mn>${right}</mn>`;
  return html`${i > 0 ? ', ' : nothing}${formula(line)}`;
}
