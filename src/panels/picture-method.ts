import { html, type TemplateResult } from 'lit';
import { METHODS } from '../math/index.ts';
import type { Dispatch } from '../state/actions.ts';
import { BOUNCES } from '../state/picture/bounces.ts';
import { changed, type PictureSettings } from '../state/picture/settings.ts';
import { readStartRule, START_TEXTS, startText, startWords } from '../state/picture/start-rule.ts';
import './picture-method.css';

/** Which method answers every question, and where rays that leave a surface begin. */
export function methodPanel(
  method: string,
  { start, bounces }: PictureSettings,
  dispatch: Dispatch,
): TemplateResult {
  return html`<h3 class="ledger-title" id="picture-method">Method for every ray</h3>
    <div class="method-grid" role="group" aria-labelledby="picture-method">
      ${METHODS.map(
        ({ id, title, idea }) => html`<button
          type="button"
          title=${idea}
          aria-pressed=${id === method}
          @click=${() => dispatch({ type: 'method', id })}
        >${title}</button>`,
      )}
    </div>
    ${startRow(startText(start), dispatch)}${bouncesRow(bounces, dispatch)}`;
}

function bouncesRow(current: number, dispatch: Dispatch): TemplateResult {
  const known: readonly number[] = BOUNCES;
  const all = known.includes(current) ? known : [...known, current].sort((a, b) => a - b);
  const pick = (event: Event): void =>
    dispatch({
      type: 'settings',
      values: changed({ bounces: (event.target as HTMLSelectElement).value }),
    });
  return html`<label class="start-row">A ray goes on for at most
    <select @change=${pick}>
      ${all.map(
        (n) =>
          html`<option value=${n} ?selected=${n === current}>${
            n === 1 ? '1 bounce' : `${n} bounces`
          }</option>`,
      )}
    </select>
  </label>`;
}

function startRow(current: string, dispatch: Dispatch): TemplateResult {
  const known: readonly string[] = START_TEXTS;
  const texts = known.includes(current) ? known : [...known, current];
  const pick = (event: Event): void =>
    dispatch({
      type: 'settings',
      values: changed({ start: (event.target as HTMLSelectElement).value }),
    });
  return html`<label class="start-row">A ray that leaves a surface
    <select @change=${pick} .value=${current}>
      ${texts.map(
        (text) =>
          html`<option value=${text}
            ?selected=${text === current}>${
              START_WORDS[text] ?? startWords(readStartRule(text))
            }</option>`,
      )}
    </select>
  </label>`;
}

const START_WORDS: Readonly<Record<string, string>> = {
  from: 'drops the root where it starts (start rule)',
  none: 'counts every t > 0 (no rule)',
};
