import { html, nothing, type TemplateResult } from 'lit';
import type { Output } from '../check/program/judge.ts';
import type { ConsoleLine } from '../check/program/protocol.ts';
import type { Failure, FamilyReport, GroupScore, Report } from '../check/program/report.ts';
import { BRANCHES, type Finding } from '../check/program/suspects.ts';
import { definitionOf, findShape } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import { lineName } from './check-feedback.ts';
import { inputRow } from './check-given.ts';
import type { ProgramTools, ProgramView } from './check-program-view.ts';

export function programReport(view: ProgramView, tools: ProgramTools): TemplateResult {
  const { running, trouble, report, notes } = view;
  return html`<div class="program-report" data-finished=${view.finished}
    data-shrinking=${String(view.shrinking)}>
    ${
      running
        ? html`<div class="progress"><progress max=${running.total} value=${running.done}
          aria-label="cases that came back"></progress> <span
          >case ${running.done} of ${running.total}</span></div>`
        : nothing
    }
    <div data-say>
      ${trouble ? html`<p class="feedback trouble"><strong>${trouble}</strong></p>` : nothing}
      ${notes.map((note) => html`<p class="tolerance">on the way: ${note}</p>`)}
      ${report ? summary(report, view) : nothing}
    </div>
    ${view.lines.length > 0 ? consoleLines(view.lines) : nothing}
    ${report ? branches(report, view, tools) : nothing}
    ${view.selected ? failure(view.selected, view) : nothing}
    ${report ? families(report, view, tools) : nothing}
  </div>`;
}

/** A score for each group, so that failures in hard cases alone are seen as such. */
function summary(report: Report, view: ProgramView): TemplateResult {
  const { groups, common, findings, remarks, silent, left } = report;
  return html`<ul class="scores" aria-label="Exact cases right, by group">${groups.map(score)}</ul>
    ${left > 0 ? html`<p>${left} cases have no result and count as not right.</p>` : nothing}
    ${silent ? html`<p>It never returns a root, so a miss counts for nothing.</p>` : nothing}
    ${common ? html`<p class="common">Wherever it is not right: ${common}.</p>` : nothing}
    ${remarks.map((words) => html`<p class="remark">${words}</p>`)}
    ${findings.map((one, i) => finding(one, i, view))}
    ${time(view)}`;
}

function score({ id, title, passed, total, others }: GroupScore): TemplateResult {
  return html`<li><span class="group-name">${title}</span>
    <strong data-quantity=${`passed.${id}`} data-value=${passed}
      data-total=${total}>${passed} of ${total}</strong>${
        others.length > 0
          ? html` <span
          class="tolerance">${others.map(
            ({ method, passed: right }, i) => html`${
              i > 0 ? ', ' : nothing
            }${method}: <span data-quantity=${`passed.${id}.${method}`}
              data-value=${right}>${right}</span>`,
          )}</span>`
          : nothing
      }</li>`;
}

/**
 * Ratio of a time's quartiles above which the page calls it unsteady and shows only their range.
 */
const STEADY = 1.5;

function time({ timing, untimed }: ProgramView): TemplateResult | typeof nothing {
  if (untimed) return html`<p class="tolerance">Its time was not measured: ${untimed}.</p>`;
  if (!timing) return nothing;
  const { low, median, high } = timing;
  const range = `${display(low, 2)} to ${display(high, 2)}`;
  const quantity = (words: string): TemplateResult =>
    html`<span data-quantity="multiple" data-value=${median}>${words}</span>`;
  return high / low > STEADY
    ? html`<p
      class="tolerance"
      >Its time is too unsteady to tell: ${quantity(range)} times the textbook method’s, in the
      middle half of the rounds.</p>`
    : html`<p
      class="tolerance">It takes ${quantity(
        display(median, 2),
      )} times the textbook method’s time (${range} in the middle half of the rounds).</p>`;
}

function finding(one: Finding, i: number, view: ProgramView): TemplateResult {
  const { flaw, or, branch, cases, changed, kinds } = one;
  const shapes = kinds.map((kind) => findShape(kind)?.title).join(', ');
  const where = `${view.kind === 'all' ? `${shapes}, ` : ''}${BRANCHES[branch]}`;
  const agree = branch === 'hard' ? 'nearly all that it changes' : `all ${cases}`;
  return html`<div class="feedback">
    <p class="verdict"><span class="glyph"
      aria-hidden="true">≠</span> <span>${i === 0 ? 'It looks like' : 'And like'} <span
        data-cause=${flaw.id}>${flaw.says}</span>${
          or
            ? html`, or like <span
          data-cause=${or.id}>${or.says}</span>`
            : nothing
        }.</span></p>
    <p>Of the cases ${where}, ${agree} come out just as they do with ${
      or ? 'either' : 'it'
    }; it changes ${changed} of ${cases}. It happens on ${lineName(flaw.line)}. ${flaw.remedy}</p>
  </div>`;
}

const LEVELS: Readonly<Record<string, string>> = { warn: 'warning: ', error: 'error: ' };

function consoleLines(lines: readonly ConsoleLine[]): TemplateResult {
  const written = lines.map(({ level, text, index }) => {
    if (level === 'more') return '… more was written: only the first lines are shown';
    return `${index === null ? '' : `case ${index + 1}  `}${LEVELS[level] ?? ''}${text}`;
  });
  return html`<details class="console" open>
    <summary>Console</summary>
    <pre tabindex="0" role="region"
      aria-label="What your program wrote on its console">${written.join('\n')}</pre>
  </details>`;
}

/** By what a program has code of its own for, ordinary cases first. */
function branches(report: Report, view: ProgramView, tools: ProgramTools): TemplateResult {
  const rows = report.branches.map(({ id, title, passed, total, says, first }) => {
    const chosen = first !== null && first === view.selected;
    return html`<tr data-branch=${id} data-passed=${passed} data-total=${total}
      data-selected=${chosen ? 'true' : nothing}>
      <th scope="row"><span class="glyph"
        aria-hidden="true">${passed === total ? '✓' : '✕'}</span> ${title}</th>
      <td><strong>${passed}</strong> of ${total}</td>
      <td>${says === report.common ? nothing : says}${
        first
          ? html` <button type="button" class="link" aria-label=${`show the failing case: ${title}`}
        @click=${() => tools.select(first)}>show</button>`
          : nothing
      }</td>
    </tr>`;
  });
  const failing = report.branches.some(({ first }) => first !== null);
  return html`<div class="table-area" tabindex="0" role="region"
    aria-label="Results by branch"><table class="families">
    <thead><tr><th scope="col">case</th><th scope="col">right</th><th
      scope="col">what happened</th></tr></thead>
    <tbody>${rows}</tbody>
  </table></div>
  <p class="tolerance">${
    view.shrinking
      ? html`Your program runs again, to find the smallest failing case of each line. <button
        type="button" class="link" @click=${tools.cancel}>Cancel</button>`
      : failing
        ? '“show” has the simplest case that was found to fail for the commonest reason.'
        : nothing
  }</p>`;
}

function families(report: Report, view: ProgramView, tools: ProgramTools): TemplateResult {
  const { families: rows, groups, common } = report;
  return html`<div class="table-area" tabindex="0" role="region"
    aria-label="Results by family"><table class="families">
    <thead><tr><th scope="col">family</th><th scope="col">right</th><th scope="col"><span
      class="visually-hidden">share</span></th><th scope="col">digits</th><th
        scope="col">what happened</th></tr></thead>
    ${groups.map(
      ({ id, title }) => html`<tbody>
        <tr class="family-group"><th scope="rowgroup" colspan="5">${title}</th></tr>
        ${rows
          .filter(({ group }) => group === id)
          .map((row) => familyRow(row, common, view, tools))}
      </tbody>`,
    )}
  </table></div>`;
}

function familyRow(
  row: FamilyReport,
  common: string,
  view: ProgramView,
  tools: ProgramTools,
): TemplateResult {
  const { group, family, passed, total, digits, says } = row;
  const good = passed === total;
  return html`<tr data-group=${group} data-family=${family} data-passed=${passed}
    data-total=${total}
      data-selected=${row.first !== null && row.first === view.selected ? 'true' : nothing}>
    <th scope="row"><span class="glyph" aria-hidden="true">${good ? '✓' : '✕'}</span> ${family}</th>
    <td><strong>${passed}</strong> of ${total}</td>
    <td><meter min="0" max=${total} value=${passed}
      aria-label=${`${passed} of ${total}`}></meter></td>
    <td>${digits === null ? '–' : Math.floor(digits)}</td>
    <td>${says === common ? nothing : says}${
      row.first
        ? html` <button type="button" class="link"
      @click=${() => row.first && tools.select(row.first)}>show</button>`
        : nothing
    }</td>
  </tr>`;
}

function failure({ case: one, output, verdict }: Failure, { link }: ProgramView): TemplateResult {
  const { expected } = one;
  return html`<section class="failure" aria-label="A failing case">
    <h3>A failing case <span class="family">${definitionOf(one.shape).title}${
      one.id.endsWith('/simpler') ? nothing : `, ${one.family}`
    }</span>
      ${link ? html`<a class="link" href=${link}>See it in Explore</a>` : nothing}</h3>
    ${inputRow(one)}
    <p>expected: <strong>${
      expected ? listed(expected.t, expected.class) : 'an error, or no t'
    }</strong></p>
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
    case 'missing':
      return 'nothing';
  }
}
