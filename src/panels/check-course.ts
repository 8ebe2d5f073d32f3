import { html, nothing, type TemplateResult } from 'lit';
import { scoreWords } from '../check/summary.ts';
import type { CourseReport } from '../state/course/course.ts';
import './check-course.css';

interface CourseView {
  /** SCORM 1.2 */
  readonly name: string;
  /** Why no course system is reached; '' if one is. */
  readonly why: string;
  /** Whether the questions that are shown are those of the course. */
  readonly isShown: boolean;
  readonly readOnly: boolean;
  readonly report: CourseReport | null;
  readonly pass: number;
  /** Why the last report was not taken; '' if it was. */
  readonly problem: string;
  /** Statements that were not taken, and whether this device keeps them. */
  readonly unsent: { readonly count: number; readonly isKept: boolean };
}

interface CourseTools {
  handIn(): void;
  again(): void;
  /** Saves the statements that were not taken. */
  save(): void;
  back(): void;
}

/** What a course system gets of a session, and whether it has it. */
export function courseBox(view: CourseView, tools: CourseTools): TemplateResult {
  return html`<section class="course" aria-label="Course system">${content(view, tools)}</section>`;
}

function content(view: CourseView, tools: CourseTools): TemplateResult {
  const { name, why, isShown, readOnly, report, problem, unsent } = view;
  if (!report) {
    return html`<p data-say="problem">No answer is reported: ${name} was not reached, ${why}.
      Whoever marks this set can take the code under “Hand in” instead.</p>`;
  }
  if (readOnly) {
    return html`<p>The course system shows what was done: nothing is reported of this visit.</p>`;
  }
  if (!isShown) {
    return html`<p>These are not the questions of the course: they are not reported.
      <button type="button" class="button small" @click=${tools.back}>Back to them</button></p>`;
  }
  return html`<p data-say>${stateWords(view, report)}</p>
    ${
      problem
        ? html`<p data-say="problem">The course system did not take the last report: ${problem}.
            Nothing is lost on this page: it goes with the next answer, or now.
            <button type="button" class="button small" @click=${tools.again}>Report again</button>
            ${unsent.count > 0 ? unsentWords(unsent, tools) : nothing}
          </p>`
        : nothing
    }
    ${
      report.complete
        ? nothing
        : html`<div class="buttons"><button type="button" class="button"
            @click=${tools.handIn}>Hand in as it is</button></div>`
    }
    <p class="tolerance">The course system gets the score, how many questions are done, and of each
      answer that is checked what stood in its boxes and whether it was right; and the code under
      “Hand in”, from which this page goes on where it was left.</p>`;
}

const unsentWords = (
  { count, isKept }: CourseView['unsent'],
  { save }: CourseTools,
): TemplateResult =>
  html`${count === 1 ? 'One statement waits' : `${count} statements wait`}${
    isKept ? ', also for your next visit on this device' : ' until this page is left'
  }. As a file, whoever marks can take what waits:
    <button type="button" class="button small" @click=${save}>Save it</button>`;

function stateWords({ pass, problem }: CourseView, report: CourseReport): string {
  const { right, total, done, complete, passed } = report;
  const score = scoreWords(right, total);
  if (problem) return `${score}.`;
  if (!complete) return `${score}, ${done} done: reported to the course system.`;
  const outcome = passed ? 'passed' : 'not passed';
  return `Handed in: ${score}, ${outcome} (from ${pass} % on). What is answered later counts, too.`;
}
