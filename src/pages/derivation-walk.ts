import { html, mathml, nothing, type TemplateResult } from 'lit';
import {
  type Expr,
  evaluate,
  float64,
  inSymbols,
  LATEX,
  type Values,
  type WalkLine,
  type WalkStep,
  walkOf,
} from '../math/formula.ts';
import { formula } from '../panels/formula.ts';
import { typesetNumbersInPieces, typesetSymbols } from '../panels/typeset.ts';
import { value } from '../panels/value.ts';
import type { ExploreModel } from '../state/derive.ts';
import { putInSideBySide } from '../state/put-in.ts';
import { signWords } from '../state/walk-words.ts';
import { displayTriple } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import './derivation-walk.css';

/** Digits that doubles have for certain: where a line has no result to give back. */
const MOST = 15;

/** The walk with the step that is shown, from 0, and what goes to another one. */
interface Walk {
  readonly steps: readonly WalkStep[];
  readonly at: number;
  go(to: number): void;
}

/** f is a straight line: A is exactly 0, or it is a flat shape. */
export const stepsOf = ({ shape, exactly }: ExploreModel): readonly WalkStep[] => {
  const { details } = exactly.found;
  return walkOf(shape, details.family === 'curved' && details.signs.A === 0);
};

/** The lines up to the present step, and the bar to go to any other. */
export function derivationWalk(model: ExploreModel, { steps, at, go }: Walk): TemplateResult {
  const step = steps[at];
  const last = steps.length - 1;
  return html`<div class="walk">
    <ol class="walk-steps">
      ${steps.slice(0, at + 1).map((one, i) => stepOf(one, i, at, model))}
    </ol>
    <p class="walk-why" role="status">
      Step ${at + 1} of ${steps.length}, ${step?.name}: ${step?.why}
    </p>
    <nav class="walk-bar" aria-label="Steps of the derivation">
      <button type="button" class="button" aria-disabled=${at === 0}
        @click=${() => go(at - 1)}>Back</button>
      <ol>
        ${steps.map(
          ({ name }, i) =>
            html`<li><button type="button"
              class=${i <= at ? 'walk-stop done' : 'walk-stop'}
              aria-current=${i === at ? 'step' : nothing} @click=${() => go(i)}>${name}</button
            ></li>`,
        )}
      </ol>
      <button type="button" class="button primary" aria-disabled=${at === last}
        @click=${() => go(at + 1)}>Next</button>
    </nav>
  </div>`;
}

const MOVES: Readonly<Record<string, (at: number, last: number) => number>> = {
  ArrowRight: (at) => at + 1,
  PageDown: (at) => at + 1,
  ArrowLeft: (at) => at - 1,
  PageUp: (at) => at - 1,
  Home: () => 0,
  End: (_, last) => last,
};

/** The step that a key asks for; null for any other key. */
export function stepByKey(event: KeyboardEvent, at: number, last: number): number | null {
  if (event.altKey || event.ctrlKey || event.metaKey) return null;
  return MOVES[event.key]?.(at, last) ?? null;
}

function stepOf(
  { name, lines }: WalkStep,
  i: number,
  at: number,
  model: ExploreModel,
): TemplateResult {
  const isPresent = i === at;
  return html`<li class=${isPresent ? 'walk-step present' : 'walk-step'}
    data-derivation-step=${i + 1}>
    <span class="walk-name">${i + 1} ${name}</span>
    <div class="walk-lines">${lines.map((line) => lineOf(line, name, isPresent, model))}</div>
    ${isPresent && model.state.revealed === null ? resultsOf(name, model) : nothing}
  </li>`;
}

function lineOf(
  line: WalkLine,
  name: string,
  isPresent: boolean,
  model: ExploreModel,
): TemplateResult {
  const { left, relation, right } = line;
  const sign = relation === '≤' ? '\\le' : '=';
  const tex = `${inSymbols(left, LATEX)} ${sign} ${inSymbols(right, LATEX)}`;
  const layers = isPresent && model.state.revealed === null && name !== 'surface';
  return html`<div class="walk-line" data-tex=${tex}>
    <div>${pieces(left)} ${formula(mathml`<mo>${relation}</mo>`)} ${pieces(right)}</div>
    ${layers ? numbersOf(line, model) : nothing}
  </div>`;
}

/** The numbers put in, and the value where the line has one: where it holds no t, x, y or z. */
function numbersOf(
  { left, right }: WalkLine,
  model: ExploreModel,
): TemplateResult | typeof nothing {
  const { numbers } = model.derivation;
  const result = resultOf(left, right, numbers);
  if (result === null) {
    const put = (expr: Expr) => inNumbers(expr, numbers, MOST);
    return isBare(left, right)
      ? nothing
      : html`<div class="walk-numbers">${put(left)} = ${put(right)}</div>`;
  }
  const lines = [{ expr: right, results: [{ value: result, text: null, branch: 1 as const }] }];
  const written = putInSideBySide(lines, numbers, false);
  if (!written) return html`<div class="walk-numbers">a number of it is beyond the doubles</div>`;
  const { digits, isFaithful } = written;
  return html`<div class="walk-numbers">${inNumbers(right, numbers, digits)}
    ${isFaithful ? '=' : '≈'} ${value('', result)}</div>`;
}

/** A result of the kernel has its own double; any other line is worked out as it is written. */
function resultOf(left: Expr, right: Expr, numbers: Values<number>): number | null {
  if (left.op === 'scalar' && left.id !== 't') return numbers.scalars[left.id] ?? null;
  if (right.op === 'number') return null;
  try {
    return evaluate(right, float64, { ...numbers, scalars: known(numbers) });
  } catch (error) {
    // A symbol without a number: the line speaks of every t, or of every point.
    if (error instanceof RangeError) return null;
    throw error;
  }
}

/** x, y, z are those of any point here, not of the hit. */
const known = ({ scalars }: Values<number>): Record<string, number> =>
  Object.fromEntries(Object.entries(scalars).filter(([id]) => !/^[xyz]$/.test(id)));

/** A normal's component holds numbers of no one point: they are told hit by hit. */
const isBare = (left: Expr, right: Expr): boolean =>
  left.op === 'component' || right.op === 'plus-minus';

/** t, and N at each hit, as the page has them; what the signs of the coefficients say. */
function resultsOf(name: string, model: ExploreModel): TemplateResult | typeof nothing {
  const { hits, found, shape, ray } = model;
  if (name === 'A, B, C' || name === 'N·d and N·(E − P)') {
    const words = signWords(shape, ray);
    return html`${words.map((text) => html`<p class="walk-results walk-sign">${text}.</p>`)}`;
  }
  if (name === 'roots' || name === 't') {
    if (hits.length === 0) return html`<p class="walk-results">There is no root.</p>`;
    return html`<p class="walk-results">${hits.map(
      ({ index, t }) => html`t${subscript(index)} = ${value('', t)} `,
    )}</p>`;
  }
  if (name !== 'normal') return nothing;
  return html`<p class="walk-results">${found.hits.map(({ normal, singular }, i) =>
    singular
      ? html`N${subscript(i + 1)} is zero: every derivative vanishes there. `
      : html`N${subscript(i + 1)} = ${displayTriple(normal)} `,
  )}</p>`;
}

/** The line with its numbers, in pieces between which it can be broken. */
const inNumbers = (expr: Expr, numbers: Values<number>, digits: number): TemplateResult =>
  html`${typesetNumbersInPieces(expr, numbers, digits).map((m) => html`${formula(m)} `)}`;

/** A sum in formulas of their own, term by term, so that a line can be broken between them. */
function pieces(expr: Expr): TemplateResult {
  if (expr.op !== 'sum' || expr.terms.length < 3) return formula(typesetSymbols(expr));
  return html`${expr.terms.map(({ sign, expr: term }, i) => {
    const before = sign === -1 ? '−' : '+';
    const mark =
      i > 0 || sign === -1
        ? mathml`<mo form=${i > 0 ? 'infix' : 'prefix'}>${before}</mo>`
        : nothing;
    return html`${formula(mathml`${mark}${typesetSymbols(term)}`)} `;
  })}`;
}
