import { html, nothing, type TemplateResult } from 'lit';
import { courseOf } from '../check/course.ts';
import { readAll } from '../check/grade.ts';
import type { Judged } from '../check/judge.ts';
import { editedLines, type Line, linesOf } from '../check/lines.ts';
import { meaningOf } from '../check/meaning.ts';
import { type Asked, askedAt } from '../check/progress.ts';
import type { Answer, Field } from '../check/types.ts';
import { shownAnswer } from './check-given.ts';
import { derivationLines } from './check-lines.ts';
import { HINTS, type QuestionTools, type QuestionView } from './check-question-view.ts';
import { value } from './value.ts';

/** Right, wrong and by which mistake, or unread; what it means in the scene, and what can be done next. */
export function feedback(judged: Judged, view: QuestionView, tools: QuestionTools): TemplateResult {
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
  const isAbout = (id: string): boolean => posed.exercise.lines.includes(id) || id === cause?.line;
  const edited = cause ? editedLines(cause, posed.draft).filter(({ id }) => isAbout(id)) : [];
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
export const mayBeHelped = ({ tries, solutionShown }: Asked): boolean => tries > 0 || solutionShown;

export function helpButtons(
  asked: Asked,
  view: QuestionView,
  tools: QuestionTools,
): TemplateResult {
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

export function helps(asked: Asked, { posed }: QuestionView): TemplateResult | typeof nothing {
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
  return typeof answer === 'number' ? value(`solution.${field.id}`, answer) : shownAnswer(answer);
}
