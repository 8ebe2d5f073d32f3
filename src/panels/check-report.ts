import { html, nothing, type TemplateResult } from 'lit';
import type { Output } from '../check/program/judge.ts';
import type { Failure, FamilyReport, Report } from '../check/program/report.ts';
import type { Finding } from '../check/program/suspects.ts';
import { definitionOf } from '../math/shapes/lookup.ts';
import { display } from '../text/format.ts';
import { lineName } from './check-feedback.ts';
import { inputRow } from './check-given.ts';
import type { ProgramTools, ProgramView } from './check-program-view.ts';

export function programReport(view: ProgramView, tools: ProgramTools): TemplateResult {
  const { running, trouble, report, multiple, notes } = view;
  return html`<div class="program-report" data-finished=${view.finished}>
    ${
      running
        ? html`<div class="progress"><progress max=${running.total} value=${running.done} aria-label="cases that came back"></progress> <span>case ${running.done} of ${running.total}</span></div>`
        : nothing
    }
    <div role="status" aria-live="polite">
      ${trouble ? html`<p class="feedback trouble"><strong>${trouble}</strong></p>` : nothing}
      ${notes.map((note) => html`<p class="tolerance">on the way: ${note}</p>`)}
      ${
        report
          ? html`<p class="score"><strong data-quantity="passed" data-value=${report.passed}>${report.passed} of ${report.total}</strong> exact cases right${report.silent ? '; it never returns a root' : nothing}${report.left > 0 ? html`, ${report.left} not run` : nothing}${
              multiple === null
                ? nothing
                : html`; <span data-quantity="multiple" data-value=${multiple}>${display(multiple, 2)}</span> times the textbook method’s time`
            }</p>`
          : nothing
      }
      ${report ? report.findings.slice(0, shownFindings(report.findings)).map(finding) : nothing}
    </div>
    ${report ? families(report, view, tools) : nothing}
    ${view.selected ? failure(view.selected, view) : nothing}
  </div>`;
}

/** Two that agree equally often cannot be told apart by what comes out; a third is named no more. */
function shownFindings(found: readonly Finding[]): number {
  return found[1] && found[1].agrees === found[0]?.agrees ? 2 : 1;
}

function finding({ misconception, agrees, of }: Finding, i: number): TemplateResult {
  return html`<div class="feedback" data-cause=${misconception.id}>
    <p class="verdict"><span class="glyph" aria-hidden="true">≠</span> ${i === 0 ? 'It looks like' : 'Or like'} ${misconception.says}.</p>
    <p>On ${agrees} of the ${of} cases that this changes, your program returns just that. It happens on ${lineName(misconception.line)}. ${misconception.remedy}</p>
  </div>`;
}

function families(
  { families: rows }: Report,
  view: ProgramView,
  tools: ProgramTools,
): TemplateResult {
  return html`<div class="table-area" tabindex="0" role="region" aria-label="Results by family"><table class="families">
    <thead><tr><th scope="col">group</th><th scope="col">family</th><th scope="col">right</th><th scope="col"><span class="visually-hidden">share</span></th><th scope="col">digits</th><th scope="col">what happened</th></tr></thead>
    <tbody>${rows.map((row, i) => familyRow(row, rows[i - 1]?.group !== row.group, view, tools))}</tbody>
  </table></div>`;
}

function familyRow(
  row: FamilyReport,
  first: boolean,
  view: ProgramView,
  tools: ProgramTools,
): TemplateResult {
  const { group, family, passed, total, digits, says } = row;
  const good = passed === total;
  return html`<tr data-family=${family} data-passed=${passed} data-total=${total} data-selected=${row.first !== null && row.first === view.selected ? 'true' : nothing}>
    <td>${first ? group : nothing}</td>
    <th scope="row"><span class="glyph" aria-hidden="true">${good ? '✓' : '✕'}</span> ${family}</th>
    <td><strong>${passed}</strong> of ${total}</td>
    <td><meter min="0" max=${total} value=${passed} aria-label=${`${passed} of ${total}`}></meter></td>
    <td>${digits === null ? '–' : Math.floor(digits)}</td>
    <td>${says}${row.first ? html` <button type="button" class="link" @click=${() => row.first && tools.select(row.first)}>show</button>` : nothing}</td>
  </tr>`;
}

function failure({ case: one, output, verdict }: Failure, { link }: ProgramView): TemplateResult {
  const { expected } = one;
  return html`<section class="failure" aria-label="A failing case">
    <h3>A failing case <span class="family">${definitionOf(one.shape).title}, ${one.family}</span>
      ${link ? html`<a class="link" href=${link}>See it in Explore</a>` : nothing}</h3>
    ${inputRow(one)}
    <p>expected: <strong>${expected ? listed(expected.t, expected.class) : 'an error, or no t'}</strong></p>
    <p>returned: <strong>${returned(output)}</strong></p>
    <p>${verdict.says}</p>
  </section>`;
}

function listed(t: readonly number[], verdict: string): string {
  if (verdict === 'contained') return 'no t: the whole line lies in it';
  return t.length === 0 ? 'no root' : t.map((x) => `t = ${display(x, 15)}`).join(', ');
}

function returned(output: Output): string {
  switch (output.type) {
    case 'value':
      return `[${output.t.map((x) => (Number.isNaN(x) ? 'NaN' : display(x, 15))).join(', ')}]`;
    case 'threw':
      return `an error${output.line === null ? '' : ` in line ${output.line}`}: ${output.message}`;
    case 'shape':
      return output.message;
    case 'stopped':
      return 'nothing within a second';
  }
}
