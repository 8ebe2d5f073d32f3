import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { CASES_SEED } from '../check/program/cases.ts';
import { FORMAT_WORDS } from '../check/program/exchange.ts';
import { SHAPES } from '../math/index.ts';
import type { ProgramTools, ProgramView } from './check-program-view.ts';
import './check-program.css';

export function programHead(view: ProgramView, tools: ProgramTools): TemplateResult {
  return html`<div class="program-head">
    <h2>Your program</h2>
    <label class="kind"><span class="visually-hidden">for which shape</span>
      <select @change=${(event: Event) => tools.pick((event.target as HTMLSelectElement).value)}>
        ${SHAPES.map(
          ({ kind, title }) => html`<option value=${kind}
          ?selected=${view.kind === kind}>${title}</option>`,
        )}
        <option value="all" ?selected=${view.kind === 'all'}>${view.all}</option>
      </select>
    </label>
    <button type="button" class="button" @click=${tools.openFile}>Open file</button>
    ${
      view.running
        ? html`<button type="button" class="button primary" @click=${tools.cancel}>Cancel</button>`
        : html`<button type="button" class="button primary" @click=${tools.run}>Run</button>`
    }
  </div>`;
}

export function editor(view: ProgramView, tools: ProgramTools): TemplateResult {
  const { source, refusal } = view;
  const lines = source.split('\n').length;
  return html`<div class="editor" .style=${`--rows: ${Math.min(26, Math.max(11, lines))}`}>
      <div class="line-numbers" aria-hidden="true">${numbersTo(lines)}</div>
      <textarea
        class="code"
        aria-label="JavaScript that defines intersect(shape, ray)"
        aria-describedby="program-refusal"
        spellcheck="false"
        autocapitalize="off"
        autocomplete="off"
        wrap="off"
        .value=${live(source)}
        @input=${(event: Event) => tools.edit((event.target as HTMLTextAreaElement).value)}
        @beforeinput=${(event: InputEvent) => refuse(event, tools)}
        @scroll=${follow}
      ></textarea>
    </div>
    <p class="refusal" id="program-refusal" data-say="problem">${refusal || nothing}${
      view.unshown
        ? html` <button type="button" class="link"
          @click=${tools.saveUnshown}>Save it as a file</button>`
        : nothing
    }</p>
    <div class="buttons">
      <button type="button" class="button small" @click=${tools.template}>Template</button>
      <button type="button" class="button small" @click=${tools.example}>Example</button>
      <span class="tolerance">in a sandbox without network, storage or page</span>
    </div>`;
}

/** Refuses input that would make the text too long, before the browser lays it out. */
function refuse(event: InputEvent, tools: ProgramTools): void {
  const { value, selectionStart, selectionEnd } = event.target as HTMLTextAreaElement;
  const text = value.slice(0, selectionStart) + (event.data ?? '') + value.slice(selectionEnd);
  if (event.data && !tools.takes(text)) event.preventDefault();
}

/** Line numbers as one text, since an element for each would be slow. */
const numbersTo = (count: number): string =>
  Array.from({ length: count }, (_, i) => i + 1).join('\n');

/** Scrolls the line numbers with the text. */
function follow(event: Event): void {
  const { scrollTop, previousElementSibling } = event.target as HTMLTextAreaElement;
  if (previousElementSibling) previousElementSibling.scrollTop = scrollTop;
}

/** Controls to save the cases for a program in another language and to open its results. */
export function exchange(tools: ProgramTools, seed: number): TemplateResult {
  return html`<details class="exchange">
    <summary>A program in C++, Python, Java, …</summary>
    <p>Save the cases, let your program answer them, and open its results here (or drop the file on
    the page).</p>
    <div class="buttons">
      <button type="button" class="button small"
        @click=${() => tools.saveCases('json')}>Cases as JSON</button>
      <button type="button" class="button small"
        @click=${() => tools.saveCases('csv')}>Cases as CSV</button>
      <button type="button" class="button small" @click=${tools.openResults}>Open results</button>
    </div>
    <label class="cases-seed">seed of the cases <input inputmode="numeric" .value=${String(seed)}
      @change=${(event: Event) => tools.seed((event.target as HTMLInputElement).value.trim())}
      /></label>
    <p class="tolerance">With another seed than ${CASES_SEED} the cases are others, in no order,
    under ids that tell nothing: for whoever marks programs.</p>
    ${FORMAT_WORDS.map((words) => html`<p class="tolerance">${words}</p>`)}
  </details>`;
}
