import { html, nothing, type TemplateResult } from 'lit';
import type { Lesson, Step } from '../../lesson/lesson.ts';
import type { WindowProblem } from './projected-window.ts';
import { type ProseTools, proseView } from './prose-view.ts';

export interface StepParts {
  readonly lesson: Lesson;
  /** From 1. */
  readonly number: number;
  readonly step: Step;
  readonly prose: ProseTools;
  /** The open question, or its answer. */
  readonly asked: TemplateResult | typeof nothing;
  /** The form in place of the text while it is edited. */
  readonly editor: TemplateResult | null;
  readonly slider: TemplateResult | typeof nothing;
  readonly isHidden: boolean;
}

interface StepTools {
  readonly go: (number: number) => void;
  readonly reveal: () => void;
  readonly edit: () => void;
  readonly add: () => void;
  readonly save: () => void;
  readonly print: () => void;
  /** Opens the presenter's window. */
  readonly present: () => void;
  /** Why that did not open; null where it did. */
  readonly problem: WindowProblem | null;
}

/** The text column of a step. */
export function stepView(parts: StepParts, tools: StepTools): TemplateResult {
  const { lesson, number, step, prose, asked, editor, slider, isHidden } = parts;
  const hasSlider = step.text.some(({ type }) => type === 'slider');
  return html`<header class="lesson-head">
      <p class="lesson-of"><a href="#/lesson">Lessons</a> · ${lesson.title}</p>
      ${dots(lesson, number, tools.go)}
      <h2>${step.title}</h2>
    </header>
    <div class="lesson-body" data-lesson-step=${number}>
      ${
        editor ??
        html`<div class="lesson-text">
            ${proseView(step.text, prose)}${hasSlider ? nothing : slider}</div>
          ${
            isHidden
              ? html`<button type="button" class="bordered reveal"
            @click=${tools.reveal}>Show the results</button>`
              : nothing
          }
          ${asked}
          <p class="lesson-tools" role="group" aria-label="This lesson">
            <button type="button" class="quiet" @click=${tools.edit}>Edit</button>
            <button type="button" class="quiet" @click=${tools.add}>Add a step from here</button>
            <button type="button" class="quiet" @click=${tools.save}>Save the lesson</button>
            <button type="button" class="quiet" @click=${tools.print}>Print the lesson</button>
            <button type="button" class="quiet" title="Notes, what comes next and a clock (p)"
              @click=${tools.present}>Presenter’s window</button>
            <span class="present-problem" data-say>${problemWords(tools.problem)}</span>
          </p>`
      }
    </div>
    ${foot(lesson, number, tools.go)}`;
}

function problemWords(problem: WindowProblem | null): TemplateResult | typeof nothing {
  if (!problem) return nothing;
  const { words, address, target } = problem;
  return address
    ? html`${words}: <a href=${address} target=${target}>open it here</a>.`
    : html`${words}`;
}

function dots({ steps }: Lesson, number: number, go: (number: number) => void): TemplateResult {
  return html`<div class="lesson-dots" role="group" aria-label="Steps">${steps.map((step, i) => {
    const at = i + 1;
    const look = at < number ? 'done' : at === number ? 'present' : 'to-come';
    return html`<button
      type="button"
      class="dot ${look}"
      aria-label=${`step ${at}: ${step.title}`}
      title=${step.title}
      aria-current=${at === number ? 'step' : nothing}
      @click=${() => go(at)}
    ></button>`;
  })}</div>`;
}

function foot({ steps }: Lesson, number: number, go: (number: number) => void): TemplateResult {
  const isLast = number === steps.length;
  return html`<footer class="lesson-foot">
    <button type="button" class="bordered"
      aria-disabled=${number === 1}
      @click=${() => go(number - 1)}>Back</button>
    <p>${number} of ${steps.length}</p>
    ${
      isLast
        ? html`<a class="bordered" href="#/lesson">All lessons</a>`
        : html`<button type="button" class="bordered next"
          @click=${() => go(number + 1)}>Next</button>`
    }
  </footer>`;
}
