import { html, mathml, nothing, type TemplateResult } from 'lit';
import { digitCount, markDigits } from '../lab/digits.ts';
import { whyLost } from '../lab/explain.ts';
import type { Losses, StepLoss } from '../lab/losses.ts';
import { plainText } from '../lab/plain-text.ts';
import { type Surd, toNumber } from '../math/exact.ts';
import { display, shortest } from '../text/format.ts';
import { digitCell, markedNumber } from './digit-bar.ts';
import { formula } from './formula.ts';
import { typesetSymbols } from './typeset.ts';
import './digit-steps.css';

/**
 * "Where did the digits go?": a method's intermediate values in order, each with the digits that
 * can still be trusted.
 */
export function digitSteps(title: string, { steps, worst }: Losses): TemplateResult {
  return html`<div class="steps">
    <p class="steps-verdict" data-say>
      ${
        worst
          ? html`<b>${title}</b>: ${whyLost(worst)}`
          : html`<b>${title}</b>: no step loses digits worth telling.`
      }
    </p>
    <div class="steps-scroll" role="region" tabindex="0" aria-label="Steps">
      <table aria-label=${`Intermediate values of ${title}`}>
        <thead>
          <tr><th scope="col">step</th><th scope="col">value</th><th
            scope="col">digits that are right</th><th scope="col">exactly</th><th
              scope="col">lost here</th></tr>
        </thead>
        <tbody>${steps.map((step) => stepRow(step, step === worst))}</tbody>
      </table>
    </div>
  </div>`;
}

function stepRow(step: StepLoss, isWorst: boolean): TemplateResult {
  const { letter, expr, own, digits, exact, lost } = step;
  const name = letter && letter !== expr ? mathml`${typesetSymbols(letter)}<mo>=</mo>` : '';
  const count = digits === null ? 0 : digitCount(digits);
  return html`<tr class=${isWorst ? 'worst' : ''} data-step=${step.text}>
    <th scope="row">
      <span class="visually-hidden">${
        letter && letter !== expr ? `${plainText(letter)} = ` : ''
      }${step.text}</span>
      <span aria-hidden="true">${formula(mathml`${name}${typesetSymbols(expr)}`)}</span></th>
    <td data-value=${Number.isNaN(own) ? nothing : shortest(own)}>${
      Number.isNaN(own) ? 'not a number' : markedNumber(markDigits(own, count))
    }</td>
    <td>${digitCell(digits, null)}</td>
    <td class="exactly">${exactly(exact)}</td>
    <td class="lost">${
      lost >= 0.5
        ? html`${isWorst ? html`<b>◀ ${display(lost, 2)} digits</b>` : `${display(lost, 2)}`}`
        : nothing
    }</td>
  </tr>`;
}

const exactly = (exact: Surd | null): string =>
  exact === null ? 'no real number' : display(toNumber(exact), 16);
