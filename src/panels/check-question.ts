import { html, nothing, type TemplateResult } from 'lit';
import { askedOf } from '../check/asked.ts';
import { FOUR_DIGITS_WORDS, type Mark, roundedWords } from '../check/grade.ts';
import { type Asked, askedAt } from '../check/progress.ts';
import { summary } from '../check/summary.ts';
import type { Field } from '../check/types.ts';
import { questionDrawing } from './check-drawing.ts';
import { feedback, helpButtons, helps, mayBeHelped } from './check-feedback.ts';
import { type FieldView, fieldRow } from './check-field.ts';
import { givenLines } from './check-given.ts';
import type { QuestionTools, QuestionView } from './check-question-view.ts';
import './check-question.css';

export function questionHead(view: QuestionView, tools: QuestionTools): TemplateResult {
  const { index, count, progress } = view;
  const { lines } = summary(progress);
  return html`<div class="question-head">
    <h2>Question ${index + 1} of ${count}</h2>
    <ol class="dashes">${lines.map(
      (line, i) => html`<li><button
        type="button"
        class="dash"
        data-done=${
          line.solvedAt !== null ? 'right' : line.tries > 0 || line.solutionShown ? 'tried' : 'open'
        }
        aria-current=${i === index ? 'step' : nothing}
        aria-label=${`Question ${i + 1}, ${line.topic}, ${line.shape}: ${line.says}`}
        title=${`${i + 1}: ${line.topic}, ${line.says}`}
        @click=${() => tools.go(i)}
      ></button></li>`,
    )}</ol>
  </div>`;
}

/** The box for the seed, which decides the session's questions. */
export function seedForm(seed: number, tools: QuestionTools): TemplateResult {
  return html`<label class="seed">seed <input name="seed" inputmode="numeric" pattern="-?[0-9]{1,9}"
    title="a whole number of up to nine digits" .value=${String(seed)}
    @change=${({ target }: Event) => {
      const box = target as HTMLInputElement;
      if (box.value.trim() !== '' && box.reportValidity()) tools.seed(Number(box.value));
    }} /></label>`;
}

export function questionText({ posed, index }: QuestionView): TemplateResult {
  const { draft, exercise } = posed;
  return html`<div class="question-text">
    <p class="topic">${askedOf(posed).subject}: ${exercise.topic}</p>
    <p class="ask">${exercise.ask(draft)}</p>
    ${givenLines(posed)} ${questionDrawing(posed, `question-${index}`)}
  </div>`;
}

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
    <div data-say>${judged ? feedback(judged, view, tools) : nothing}</div>
    ${judged || !mayBeHelped(asked) ? nothing : helpButtons(asked, view, tools)}
    ${helps(asked, view)}
  </form>`;
}

function markOf(mark: Mark, follows: boolean): readonly [FieldView['glyph'], string] {
  if (mark.verdict === 'invalid') return ['?', mark.reason];
  if (mark.verdict === 'rounded') return ['≈', roundedWords(mark.digits)];
  if (follows) return ['→', 'right for your earlier value'];
  return mark.verdict === 'correct' ? ['=', 'right'] : ['≠', 'not right'];
}

function answerRow(
  field: Field,
  { judged, index }: QuestionView,
  asked: Asked,
  tools: QuestionTools,
) {
  const mark = judged?.marks[field.id];
  const follows = judged?.follow[field.id] !== undefined;
  const [glyph, words] = mark ? markOf(mark, follows) : (['', ''] as const);
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
