import { html, nothing, type TemplateResult } from 'lit';
import type { Posed } from '../check/compose.ts';
import { drawnInput } from '../check/drawn-input.ts';
import { readAll, roundedWords } from '../check/grade.ts';
import type { Judged } from '../check/judge.ts';
import { editedLines } from '../check/lines.ts';
import { meaningOf } from '../check/meaning.ts';
import type { Misconception } from '../check/misconceptions/define.ts';
import { type Asked, askedAt } from '../check/progress.ts';
import { hintsOf, solutionOf } from '../check/solution.ts';
import type { Answer, Field } from '../check/types.ts';
import { shownAnswer } from './check-given.ts';
import { derivationLines } from './check-lines.ts';
import { HINTS, type QuestionTools, type QuestionView } from './check-question-view.ts';
import { value } from './value.ts';

/**
 * The verdict on an answer, the mistakes behind it, its meaning in the scene, and what to do next.
 */
export function feedback(judged: Judged, view: QuestionView, tools: QuestionTools): TemplateResult {
  const { posed, index, count, progress } = view;
  const asked = askedAt(progress, index);
  if (judged.verdict === 'invalid') {
    return html`<div class="feedback" data-verdict="invalid"><p class="verdict"><span class="glyph"
      aria-hidden="true">?</span> Not all of it could be read; this was no try.</p
      >${mayBeHelped(asked) ? helpButtons(asked, view, tools) : nothing}</div>`;
  }
  const read = readAll(posed.fields, asked.texts);
  const { input } = drawnInput(posed, read);
  const isWrong = ({ id }: Field): boolean => judged.marks[id]?.verdict === 'wrong';
  const meant = posed.fields.filter((field) => judged.verdict !== 'wrong' || isWrong(field));
  const meaning = meaningOf(
    input,
    read,
    meant.map(({ id }) => id),
  );
  const way = judged.way
    ? html`<p>What is marked right is right with ${judged.way.says}.</p>`
    : nothing;
  if (judged.verdict === 'rounded') {
    return html`<div class="feedback" data-verdict="rounded">
      <p class="verdict"><span class="glyph"
        aria-hidden="true">≈</span> ${roundedVerdict(judged)} This was no try.</p>
      ${way}
      ${mayBeHelped(asked) ? helpButtons(asked, view, tools) : nothing}
    </div>`;
  }
  if (judged.verdict === 'correct') {
    return html`<div class="feedback" data-verdict="correct">
      <p class="verdict"><span class="glyph" aria-hidden="true">=</span> Right.</p>
      ${way}
      ${meaning ? html`<p>${meaning}</p>` : nothing}
      <div class="buttons">
        ${
          index + 1 < count
            ? html`<button type="button" class="button primary"
          @click=${() => tools.go(index + 1)}>Next question</button>`
            : nothing
        }
        ${solutionButton(asked, view, tools)}
      </div>
    </div>`;
  }
  const { causes } = judged;
  const isAbout = (id: string): boolean =>
    posed.exercise.lines.includes(id) || causes.some(({ line }) => line === id);
  const edited = editedLines(causes, input).filter(({ id }) => isAbout(id));
  return html`<div class="feedback" data-verdict="wrong" data-cause=${ids(causes) || nothing}>
    <p class="verdict"><span class="glyph"
      aria-hidden="true">≠</span> Not right.${
        causes.length > 0 ? ` ${namedCauses(causes)}` : ''
      }</p>
    ${causes.map((cause) => html`<p>${whereAndWhat(cause, causes.length > 1)}</p>`)}
    ${
      edited.length > 0
        ? html`<p
      class="then">Then, as in your answer:</p>${derivationLines(edited, 'numbers')}`
        : nothing
    }
    ${way}
    ${meaning ? html`<p>${meaning}</p>` : nothing}
    ${helpButtons(asked, view, tools)}
  </div>`;
}

/** "Right to 3 digits, give one more." */
function roundedVerdict({ marks }: Judged): string {
  const digits = Object.values(marks).flatMap((mark) =>
    mark.verdict === 'rounded' ? [mark.digits] : [],
  );
  const words =
    digits.length > 0
      ? roundedWords(Math.min(...digits))
      : 'right for what you rounded before it, give more digits';
  return `${words[0]?.toUpperCase()}${words.slice(1)}.`;
}

/** "This is what comes out with B/2 in place of B, and with + r² in place of − r²." */
export const namedCauses = (causes: readonly Misconception[]): string =>
  `This is what comes out with ${causes.map(({ says }) => says).join(', together with ')}.`;

/** The line of a mistake and its remedy, preceded by its name if there are several. */
export const whereAndWhat = (
  { says, line, remedy }: Misconception,
  isOneOfSome: boolean,
): string =>
  isOneOfSome
    ? `On ${lineName(line)}: ${says}. ${remedy}`
    : `It happens on ${lineName(line)}. ${remedy}`;

export const ids = (causes: readonly Misconception[]): string =>
  causes.map(({ id }) => id).join(' ');

const NAMES: Readonly<Record<string, string>> = {
  first: 'the choice of the first visible hit',
  case: 'the case distinction',
  inside: 'the test of the figure’s bounds',
  'N.d': 'the line N·d',
  'N.(E-P)': 'the line N·(E − P)',
};

/** "the line B", "the choice of the first visible hit" */
export const lineName = (line: string): string => NAMES[line] ?? `the line ${line}`;

/** Whether hints are offered: after a first try. */
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
    ${
      tried
        ? html`<button type="button" class="button"
      @click=${again}>Try again</button>`
        : nothing
    }
    ${
      view.withHints
        ? html`<button type="button" class="button" ?disabled=${!left}
      @click=${tools.hint}>${
        left ? `Hint ${asked.hints + 1} of ${HINTS}` : 'No more hints'
      }</button>`
        : nothing
    }
    ${solutionButton(asked, view, tools)}
  </div>`;
}

const solutionButton = (
  asked: Asked,
  { withHints }: QuestionView,
  tools: QuestionTools,
): TemplateResult | typeof nothing =>
  asked.solutionShown || !withHints
    ? nothing
    : html`<button type="button" class="button"
      @click=${tools.solution}>Show the solution</button>`;

export function helps(asked: Asked, { posed }: QuestionView): TemplateResult | typeof nothing {
  if (asked.hints === 0 && !asked.solutionShown) return nothing;
  const given = hintsOf(posed).slice(0, asked.hints);
  const last = given.length - 1;
  return html`<div class="helps">
    ${given.map(({ words, lines, layer }, i) => {
      // Only the last hint shows its lines; the words of earlier ones stay.
      const shown = i === last && !asked.solutionShown && lines.length > 0;
      return html`${
        words
          ? html`<p
        class="hint" data-say>Hint: ${words}</p>`
          : nothing
      }${shown ? derivationLines(lines, layer) : nothing}`;
    })}
    ${asked.solutionShown ? html`<div data-say>${solution(posed)}</div>` : nothing}
    ${
      asked.solutionShown && posed.draft.scene
        ? html`<p><a class="link"
          href=${`#/picture?scene=${posed.draft.scene.id}`}>See the scene in Picture</a></p>`
        : nothing
    }
  </div>`;
}

/** The lines of the solution, why they decide the question, and the answers. */
export function solution(posed: Posed): TemplateResult {
  const { lines, decision } = solutionOf(posed);
  const answers = posed.fields.map(
    (field, i) =>
      html`${i > 0 ? ', ' : nothing}${field.label} ${
        field.kind === 'choice' || posed.truth[field.id] === undefined ? '' : '= '
      }${solved(field, posed.truth[field.id])}`,
  );
  return html`<section class="solution" aria-label="Solution">
    <h3>Solution</h3>
    ${lines.length > 0 ? derivationLines(lines, 'numbers') : nothing}
    ${decision.map((words) => html`<p>${words}</p>`)}
    <p class="so">So ${answers}.</p>
  </section>`;
}

function solved(field: Field, answer: Answer | undefined): TemplateResult | string {
  if (answer === undefined) return 'does not exist';
  if (field.kind === 'choice') {
    return field.options.find(({ id }) => id === answer)?.title ?? String(answer);
  }
  return typeof answer === 'number' ? value(`solution.${field.id}`, answer) : shownAnswer(answer);
}
