import { html, nothing, type TemplateResult } from 'lit';
import { GROUPS, type GroupId } from '../check/program/cases.ts';
import { type Graded, rowOf, type Weights } from '../check/program/marks.ts';
import { SHAPES } from '../math/index.ts';
import './check-set.css';
import './check-class.css';
import { type Refusals, refusal, typedIn } from './refused-text.ts';

interface GradesView {
  readonly graded: readonly Graded[];
  readonly running: { readonly done: number; readonly total: number } | null;
  readonly weights: Weights;
  readonly refusals: Refusals;
  /** The shape of the cases, or 'all'. */
  readonly cases: string;
  readonly casesSeed: number;
  /** "all shapes", in words. */
  readonly all: string;
  /** Shapes and seed of the table; '' if there is none. */
  readonly about: string;
  /** The table is of other cases than those that are chosen. */
  readonly isStale: boolean;
}

interface GradesTools {
  cancel(): void;
  again(): void;
  save(id: string): void;
  saveCases(format: 'json' | 'csv'): void;
  cases(kind: string): void;
  seed(text: string): void;
  weigh(group: GroupId, text: string): void;
}

const FILES = [
  {
    id: 'csv',
    title: 'CSV',
    says: 'A line for each: name, points, right cases by group, what was found.',
  },
  {
    id: 'gradescope',
    title: 'Gradescope',
    says: 'results.json with points by group; of several submissions one each, in a zip.',
  },
  { id: 'junit', title: 'JUnit XML', says: 'A suite for each, a test for each family of cases.' },
  { id: 'markdown', title: 'Markdown', says: 'The table and a tally of mistakes, for people.' },
] as const;

/** Where programs of a class become points. */
export function gradesPart(view: GradesView, tools: GradesTools): TemplateResult {
  const { graded, running, weights } = view;
  return html`<section class="grades" aria-labelledby="grades-title">
    <h3 id="grades-title">Programs</h3>
    <p>Programs in JavaScript and TypeScript, and files of results of other languages, are opened
      or dropped here, too: a file is a submission by its name, a folder by its own. Programs
      run one after another in the sandbox of “Own program”, on cases of the seed that you
      choose; with another than 41 a table of known answers gets nowhere.</p>
    <div class="set-choices">
      <label>cases of <select @change=${(event: Event) =>
        tools.cases((event.target as HTMLSelectElement).value)}>
        ${SHAPES.map(
          ({ kind, title }) =>
            html`<option value=${kind} ?selected=${view.cases === kind}>${title}</option>`,
        )}
        <option value="all" ?selected=${view.cases === 'all'}>${view.all}</option>
      </select></label>
      <label>seed of the cases <input class="set-seed" inputmode="numeric"
        .value=${String(view.casesSeed)} @change=${(event: Event) => tools.seed(typedIn(event))}
      /></label>
    </div>
    ${refusal(view.refusals, 'seed')}
    <div class="set-choices" role="group" aria-label="Weights"><span>weights</span>
      ${GROUPS.map(
        ({ id, title }) => html`<label>${title} <input class="set-pass" inputmode="decimal"
          aria-label=${`weight of ${title} cases`} .value=${String(weights[id])}
          @change=${(event: Event) => tools.weigh(id, typedIn(event))} /></label>`,
      )}
    </div>
    ${GROUPS.map(({ id }) => refusal(view.refusals, id))}
    <p class="tolerance">Points out of 100: the share of right cases of each group, weighted by
      these numbers. A case without a result is not right.</p>
    <div class="buttons">
      <button type="button" class="button" @click=${() => tools.saveCases('json')}>Save the cases
        as JSON</button>
      <button type="button" class="button" @click=${() => tools.saveCases('csv')}>as CSV</button>
      <span class="tolerance">Without right answers, for programs in other languages.</span>
    </div>
    <div data-say>${
      running
        ? html`<p class="progress"><progress max=${running.total} value=${running.done}
            aria-label="submissions that are graded"></progress> ${running.done} of
            ${running.total} graded
            <button type="button" class="button small" @click=${tools.cancel}>Cancel</button></p>`
        : nothing
    }</div>
    ${graded.length > 0 ? table(view, tools) : nothing}
  </section>`;
}

function table(
  { graded, weights, about, isStale, running }: GradesView,
  tools: GradesTools,
): TemplateResult {
  const count = graded.length;
  return html`<p><strong data-quantity="graded" data-value=${count}>${count}</strong> graded on
      cases for ${about}.
      ${
        isStale && !running
          ? html`Other cases are chosen now.
            <button type="button" class="button small" @click=${tools.again}>Grade again</button>`
          : nothing
      }</p>
    <div class="table-area" tabindex="0" role="region" aria-label="Points by submission"><table>
      <thead><tr><th scope="col">who</th><th scope="col">points</th>${GROUPS.map(
        ({ title }) => html`<th scope="col">${title}</th>`,
      )}<th scope="col">found</th></tr></thead>
      <tbody>${graded
        .map((one) => rowOf(one, weights))
        .map(
          ({ who, points, groups, found }) => html`<tr><th scope="row">${who}</th>
          <td>${points}</td>${groups.map((words) => html`<td>${words}</td>`)}
            <td>${found}</td></tr>`,
        )}</tbody>
    </table></div>
    <ul class="set-files">${FILES.map(
      ({ id, title, says }) => html`<li><button type="button" class="button"
        @click=${() => tools.save(id)}>${title}</button> <span>${says}</span></li>`,
    )}</ul>`;
}
