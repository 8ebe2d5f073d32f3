import { html, nothing, type TemplateResult } from 'lit';
import { setName } from '../check/sets.ts';
import type { Summary } from '../check/summary.ts';
import './check-summary.css';

interface SummaryTools {
  save(): void;
  print(): void;
  /** Whether a page around this one is told the score. */
  readonly isFramed: boolean;
  /** Null where answers are reported, and none is taken back. */
  readonly restart: (() => void) | null;
}

/** A row for each question: at which try it was right. */
export function summaryTable(
  { seed, set, right, total, lines }: Summary,
  tools: SummaryTools,
): TemplateResult {
  return html`<details class="summary">
    <summary>Summary: ${right} of ${total} right, ${setName(set)}, seed ${seed}</summary>
    <div class="table-area" tabindex="0" role="region" aria-label="Summary of the session">
    <table>
      <thead><tr><th scope="col">#</th><th scope="col">topic</th><th scope="col">shape</th><th
        scope="col">result</th><th scope="col">hints</th><th
          scope="col">named on the way</th></tr></thead>
      <tbody>${lines.map(
        (line) => html`<tr>
          <td>${line.question}</td>
          <th scope="row">${line.topic}</th>
          <td>${line.shape}</td>
          <td>${line.says}</td>
          <td>${line.hints || nothing}</td>
          <td>${line.misconceptions.join('; ')}</td>
        </tr>`,
      )}</tbody>
    </table>
    </div>
    ${
      tools.restart
        ? html`<p class="tolerance">${
            tools.isFramed
              ? 'The page around this one is told how many are right; nothing else is sent.'
              : 'Nothing is sent anywhere; it stays on this device.'
          }</p>`
        : nothing
    }
    <div class="buttons">
      <button type="button" class="button" @click=${tools.print}>Print</button>
      <button type="button" class="button" title="this table with set and seed, without a name"
        @click=${tools.save}>Save as JSON</button>
      ${
        tools.restart
          ? html`<button type="button" class="button" @click=${tools.restart}>Start this seed
              anew</button>`
          : nothing
      }
    </div>
  </details>`;
}
