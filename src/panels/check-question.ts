import { html, nothing, type TemplateResult } from 'lit';
import type { Posed } from '../check/compose.ts';
import { courseOf } from '../check/course.ts';
import { FOUR_DIGITS_WORDS, readAll } from '../check/grade.ts';
import type { Judged } from '../check/judge.ts';
import { editedLines, type Line, linesOf } from '../check/lines.ts';
import { meaningOf } from '../check/meaning.ts';
import { type Asked, askedAt, type Progress } from '../check/progress.ts';
import { summary } from '../check/summary.ts';
import type { Answer, Field } from '../check/types.ts';
import { definitionOf } from '../math/shapes/lookup.ts';
import { display, displayTriple } from '../text/format.ts';
import { fieldRow } from './check-field.ts';
import { inputRow } from './check-given.ts';
import { derivationLines } from './check-lines.ts';
import { value } from './value.ts';
import './check-question.css';

export interface QuestionView {
  readonly posed: Posed;
  /** From 0. */
  readonly index: number;
  readonly count: number;
  readonly progress: Progress;
  /** The answer that was committed last, if the boxes still hold it. */
  readonly judged: Judged | null;
}

export interface QuestionTools {
  type(field: string, text: string): void;
  check(): void;
  hint(): void;
  solution(): void;
  go(index: number): void;
  seed(seed: number): void;
}

/** The words, the formula in symbols, the formula with numbers. */
export const HINTS = 3;

export function questionHead(view: QuestionView, tools: QuestionTools): TemplateResult {
  const { index, count, progress } = view;
  const { lines } = summary(progress);
  return html`<div class="question-head">
    <h2>Question ${index + 1} of ${count}</h2>
    <ol class="dashes">${lines.map(
      (line, i) => html`<li><button
        type="button"
        class="dash"
        data-done=${line.solvedAt !== null ? 'right' : line.tries > 0 || line.solutionShown ? 'tried' : 'open'}
        aria-current=${i === index ? 'step' : nothing}
        aria-label=${`Question ${i + 1}, ${line.topic}, ${line.shape}: ${line.says}`}
        title=${`${i + 1}: ${line.topic}, ${line.says}`}
        @click=${() => tools.go(i)}
      ></button></li>`,
    )}</ol>
  </div>`;
}

/** Another seed, other numbers; the same seed, the same ones for everybody. */
export function seedForm(seed: number, tools: QuestionTools): TemplateResult {
  return html`<form class="seed" @submit=${(event: Event) => {
    event.preventDefault();
    const text = new FormData(event.target as HTMLFormElement).get('seed');
    const wanted = Number(text);
    if (Number.isSafeInteger(wanted)) tools.seed(wanted);
  }}><label>seed <input name="seed" inputmode="numeric" pattern="-?[0-9]{1,9}" title="a whole number of up to nine digits" .value=${String(seed)} @change=${(event: Event) => (event.target as HTMLInputElement).form?.requestSubmit()} /></label></form>`;
}

export function questionText({ posed }: QuestionView): TemplateResult {
  const { draft, exercise, given } = posed;
  const unknown = exercise.id === 'tangent' ? (draft.param?.key ?? null) : null;
  const { title } = definitionOf(draft.shape);
  const told = Object.entries(given);
  return html`<div class="question-text">
    <p class="topic">${title}: ${exercise.topic}</p>
    <p class="ask">${exercise.ask(draft)}</p>
    ${inputRow(draft, unknown)}
    ${
      told.length === 0
        ? nothing
        : html`<ul class="given told" aria-label="Also given">${told.map(
            ([id, answer]) => html`<li>${SHORT[id] ?? id} = ${shown(answer)}</li>`,
          )}</ul>`
    }
  </div>`;
}

const SHORT: Readonly<Record<string, string>> = { t1: 't₁', t2: 't₂' };

const shown = (answer: Answer): string => {
  if (typeof answer === 'number') return display(answer, 8);
  return typeof answer === 'object' ? displayTriple(answer, 8) : answer;
};

export function answerForm(view: QuestionView, tools: QuestionTools): TemplateResult {
  const { posed, progress, index, judged } = view;
  const asked = askedAt(progress, index);
  const numbers = posed.fields.some(({ kind }) => kind !== 'choice');
  return html`<form class="answers" @submit=${(event: Event) => {
    event.preventDefault();
    tools.check();
  }}>
    ${posed.fields.map((field) => answerRow(field, view, asked, tools))}
    <div class="commit">
      <button type="submit" class="button primary">Check</button>
      ${numbers ? html`<span class="tolerance">${FOUR_DIGITS_WORDS}</span>` : nothing}
    </div>
    <div role="status" aria-live="polite">${judged ? feedback(judged, view, tools) : nothing}</div>
    ${judged || !mayBeHelped(asked) ? nothing : helpButtons(asked, view, tools)}
    ${helps(asked, view)}
  </form>`;
}

function answerRow(
  field: Field,
  { judged, index }: QuestionView,
  asked: Asked,
  tools: QuestionTools,
) {
  const mark = judged?.marks[field.id];
  const follows = judged?.follow.includes(field.id) ?? false;
  const words = !mark
    ? ''
    : mark.verdict === 'invalid'
      ? mark.reason
      : follows
        ? 'right for your earlier value'
        : mark.verdict === 'correct'
          ? 'right'
          : 'not right';
  const glyph = !mark
    ? ''
    : mark.verdict === 'invalid'
      ? '?'
      : follows
        ? '→'
        : mark.verdict === 'correct'
          ? '='
          : '≠';
  return fieldRow({
    field,
    id: `answer-${index}-${field.id}`,
    text: asked.texts[field.id] ?? '',
    mark: words,
    glyph,
    invalid: mark?.verdict === 'invalid',
    onText: (text) => tools.type(field.id, text),
  });
}

function feedback(judged: Judged, view: QuestionView, tools: QuestionTools): TemplateResult {
  const { posed, index, count, progress } = view;
  const asked = askedAt(progress, index);
  if (judged.verdict === 'invalid') {
    return html`<div class="feedback" data-verdict="invalid"><p class="verdict"><span class="glyph" aria-hidden="true">?</span> Not all of it could be read; this was no try.</p>${mayBeHelped(asked) ? helpButtons(asked, view, tools) : nothing}</div>`;
  }
  const read = readAll(posed.fields, asked.texts);
  const meaning = meaningOf(posed.draft, read);
  if (judged.verdict === 'correct') {
    return html`<div class="feedback" data-verdict="correct">
      <p class="verdict"><span class="glyph" aria-hidden="true">=</span> Right.</p>
      ${meaning ? html`<p>${meaning}</p>` : nothing}
      <div class="buttons">
        ${index + 1 < count ? html`<button type="button" class="button primary" @click=${() => tools.go(index + 1)}>Next question</button>` : nothing}
        ${solutionButton(asked, tools)}
      </div>
    </div>`;
  }
  const { cause } = judged;
  const edited = cause ? editedLines(cause, posed.draft) : [];
  return html`<div class="feedback" data-verdict="wrong" data-cause=${cause?.id ?? nothing}>
    <p class="verdict"><span class="glyph" aria-hidden="true">≠</span> ${
      cause ? html`Not right. This is what comes out with ${cause.says}.` : 'Not right.'
    }</p>
    ${cause ? html`<p>It happens on ${lineName(cause.line)}. ${cause.remedy}</p>` : nothing}
    ${edited.length > 0 ? html`<p class="then">Then, as in your answer:</p>${derivationLines(edited, 'numbers')}` : nothing}
    ${meaning ? html`<p>${meaning}</p>` : nothing}
    ${helpButtons(asked, view, tools)}
  </div>`;
}

const NAMES: Readonly<Record<string, string>> = {
  t: 'the line of the roots, t',
  first: 'the choice of the first visible hit',
  case: 'the case distinction',
  inside: 'the test of the figure’s bounds',
  'N.d': 'the line N·d',
  'N.(E-P)': 'the line N·(E − P)',
};

/** "the line B", "the choice of the first visible hit" */
export const lineName = (line: string): string => NAMES[line] ?? `the line ${line}`;

/** Hints come after a try. */
const mayBeHelped = ({ tries, solutionShown }: Asked): boolean => tries > 0 || solutionShown;

function helpButtons(asked: Asked, view: QuestionView, tools: QuestionTools): TemplateResult {
  const left = asked.hints < HINTS;
  const tried = view.judged?.verdict === 'wrong';
  const again = (event: Event): void => {
    const form = (event.target as HTMLElement).closest('form');
    form?.querySelector<HTMLElement>('input, select')?.focus();
  };
  return html`<div class="buttons">
    ${tried ? html`<button type="button" class="button" @click=${again}>Try again</button>` : nothing}
    <button type="button" class="button" ?disabled=${!left} @click=${tools.hint}>${left ? `Hint ${asked.hints + 1} of ${HINTS}` : 'No more hints'}</button>
    ${solutionButton(asked, tools)}
  </div>`;
}

const solutionButton = (asked: Asked, tools: QuestionTools): TemplateResult | typeof nothing =>
  asked.solutionShown
    ? nothing
    : html`<button type="button" class="button" @click=${tools.solution}>Show the solution</button>`;

function helps(asked: Asked, { posed }: QuestionView): TemplateResult | typeof nothing {
  const { exercise, draft, fields, truth } = posed;
  if (asked.hints === 0 && !asked.solutionShown) return nothing;
  const lines = linesOf(courseOf(draft.shape), draft);
  const about = lines.filter(({ id }) => exercise.lines.includes(id));
  return html`<div class="helps" role="status">
    ${asked.hints > 0 ? html`<p class="hint">Hint: ${exercise.clue}</p>` : nothing}
    ${asked.hints > 1 && asked.hints < HINTS ? derivationLines(about, 'symbols') : nothing}
    ${asked.hints >= HINTS && !asked.solutionShown ? derivationLines(withoutResults(about), 'numbers') : nothing}
    ${
      asked.solutionShown
        ? html`<section class="solution" aria-label="Solution">
          <h3>Solution</h3>
          <p>${fields.map((field, i) => html`${i > 0 ? ', ' : nothing}${field.label} ${field.kind === 'choice' ? '' : '= '}${solved(field, truth[field.id])}`)}</p>
          ${derivationLines(lines, 'numbers')}
        </section>`
        : nothing
    }
  </div>`;
}

/** The last hint puts the numbers in and leaves the arithmetic to the student. */
const withoutResults = (lines: readonly Line[]): readonly Line[] =>
  lines.map((line) => ({ ...line, values: [] }));

function solved(field: Field, answer: Answer | undefined): TemplateResult | string {
  if (answer === undefined) return 'does not exist';
  if (field.kind === 'choice') {
    return field.options.find(({ id }) => id === answer)?.title ?? String(answer);
  }
  return typeof answer === 'number' ? value(`solution.${field.id}`, answer) : shown(answer);
}
