import { html, nothing, type TemplateResult } from 'lit';
import type { ClassReport } from '../check/class.ts';
import { setName } from '../check/sets.ts';
import type { PathFile } from '../ui/files.ts';
import './check-set.css';
import './check-class.css';

interface ClassView {
  /** What is in the box. */
  readonly text: string;
  /** Codes that are being marked; null while none are. */
  readonly running: { readonly done: number; readonly total: number } | null;
  /** What could not be read, each in words. */
  readonly problems: readonly string[];
  readonly report: ClassReport | null;
  /** Set and seed of the link, which hand-ins are compared with; '' if they are not. */
  readonly compared: string;
  readonly compares: boolean;
  readonly isGraded: boolean;
  /** The part for programs. */
  readonly grades: TemplateResult;
}

export interface ClassTools {
  type(text: string): void;
  mark(): void;
  files(files: readonly PathFile[]): void;
  chosen(input: HTMLInputElement): void;
  drop(transfer: DataTransfer): void;
  compare(wanted: boolean): void;
  cancel(): void;
  clear(): void;
  save(): void;
}

const ACCEPTED = '.txt,.csv,.tsv,.eml,.html,.json,.jsonl,.js,.mjs,.cjs,.ts,.mts,text/*';

/** Where hand-in codes of a class become a table. */
export function classForm(view: ClassView, tools: ClassTools): TemplateResult {
  const { running, report, problems } = view;
  const chosen = (event: Event): void => {
    const input = event.target as HTMLInputElement;
    tools.chosen(input);
    input.value = '';
  };
  return html`<section class="class-part" aria-label="Mark a class"
    @drop=${(event: DragEvent) => {
      if (!event.dataTransfer?.types.includes('Files')) return;
      event.preventDefault();
      event.stopPropagation();
      tools.drop(event.dataTransfer);
    }}>
    <h2>Mark a class</h2>
    <p>Paste hand-in codes, with whatever stands around them (a whole mail, a column of a table), or
      open or drop texts that hold some. Every answer is marked anew on this device; nothing is
      sent.</p>
    <label class="class-codes"><span>Hand-in codes</span>
      <textarea rows="5" spellcheck="false" .value=${view.text}
        @input=${(event: Event) => tools.type((event.target as HTMLTextAreaElement).value)}
      ></textarea></label>
    <label class="class-compare"><input type="checkbox" .checked=${view.compares}
      @change=${(event: Event) => tools.compare((event.target as HTMLInputElement).checked)}
      /> note what is not of ${view.compared}</label>
    <div class="buttons">
      <button type="button" class="button primary" @click=${tools.mark}>Mark these codes</button>
      <label class="button class-file">Open files<input type="file" multiple
        class="visually-hidden" accept=${ACCEPTED} @change=${chosen} /></label>
      <label class="button class-file">Open a folder<input type="file" multiple webkitdirectory
        class="visually-hidden" @change=${chosen} /></label>
      ${
        report || problems.length > 0 || view.isGraded
          ? html`<button type="button" class="button" @click=${tools.clear}>Clear</button>`
          : nothing
      }
    </div>
    ${
      running
        ? html`<p class="progress"><progress max=${running.total} value=${running.done}
            aria-label="codes that are marked"></progress> ${running.done} of ${running.total}
            <button type="button" class="button small" @click=${tools.cancel}>Cancel</button></p>`
        : report
          ? html`<p data-say><strong data-quantity="students"
              data-value=${report.students.length}>${report.students.length}</strong>
              ${report.students.length === 1 ? 'hand-in' : 'hand-ins'} marked.</p>`
          : nothing
    }
    ${problems.length > 0 ? problemList(problems) : nothing}
    ${report && report.students.length > 0 ? tables(report, tools) : nothing}
    <p class="tolerance">The check value of a code finds what was cut or changed by hand. It deters;
      it does not prove who answered, or with what help.</p>
    ${view.grades}
  </section>`;
}

const MOST_SHOWN = 20;

const problemList = (problems: readonly string[]): TemplateResult =>
  html`<ul class="class-problems" data-say="problem">${problems
    .slice(0, MOST_SHOWN)
    .map((words) => html`<li>${words}</li>`)}${
    problems.length > MOST_SHOWN ? html`<li>and ${problems.length - MOST_SHOWN} more</li>` : nothing
  }</ul>`;

function tables(report: ClassReport, tools: ClassTools): TemplateResult {
  const { students, topics, misconceptions } = report;
  return html`<div class="buttons"><button type="button" class="button"
      @click=${tools.save}>Save as CSV</button> <span class="tolerance">A line for each student:
      name, set, seed, right, tries, hints, solutions read, mistakes, notes, and 1 for each question
      that is right.</span></div>
    <h3>By topic</h3>
    ${shares(topics, 'topic', 'right')}
    <h3>By mistake</h3>
    ${
      misconceptions.length === 0
        ? html`<p>No known mistake was found.</p>`
        : shares(misconceptions, 'mistake', 'students')
    }
    <h3>By student</h3>
    <div class="table-area" tabindex="0" role="region" aria-label="Results by student"><table>
      <thead><tr><th scope="col">who</th><th scope="col">right</th><th scope="col">tries</th><th
        scope="col">hints</th><th scope="col">set</th><th scope="col">question by
          question</th><th scope="col">notes</th></tr></thead>
      <tbody>${students.map(
        ({ who, right, questions, set, notes }) => html`<tr>
          <th scope="row">${who || '–'}</th>
          <td>${right} of ${questions.length}</td>
          <td>${questions.reduce((sum, { tries }) => sum + tries, 0)}</td>
          <td>${questions.reduce((sum, { hints }) => sum + hints, 0)}</td>
          <td class="class-set">${setName(set)}</td>
          <td class="class-marks" aria-label=${questions
            .map((one, i) => `${i + 1} ${one.right ? 'right' : one.answered ? 'wrong' : 'open'}`)
            .join(', ')}>${questions.map(({ right: good, answered }) =>
            good ? '=' : answered ? '≠' : '·',
          )}</td>
          <td>${notes.join('; ')}</td>
        </tr>`,
      )}</tbody>
    </table></div>
    <p class="tolerance">= right, ≠ not right, · not answered. A question whose solution was read
      before it was right does not count as right.</p>`;
}

function shares(rows: ClassReport['topics'], first: string, counted: string): TemplateResult {
  return html`<div class="table-area" tabindex="0" role="region"
    aria-label=${`Results by ${first}`}><table class="class-shares">
    <thead><tr><th scope="col">${first}</th><th scope="col">${counted}</th><th scope="col"><span
      class="visually-hidden">share</span></th></tr></thead>
    <tbody>${rows.map(
      ({ name, count, of }) => html`<tr><th scope="row">${name}</th><td>${count} of ${of}</td>
        <td><meter min="0" max=${of} value=${count}
          aria-label=${`${count} of ${of}`}></meter></td></tr>`,
    )}</tbody>
  </table></div>`;
}
