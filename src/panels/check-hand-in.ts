import { html, type TemplateResult } from 'lit';
import './check-hand-in.css';

interface HandInView {
  readonly who: string;
  readonly open: boolean;
  /** '' while it is closed. */
  readonly code: string;
  /** Whether a course system has it already. */
  readonly reported: boolean;
  /** The code as a picture, or words on why there is none. */
  readonly picture: TemplateResult;
}

interface HandInTools {
  toggle(open: boolean): void;
  name(who: string): void;
  copy(): void;
  save(): void;
  statements(): void;
}

/** The session as a code for whoever marks it. */
export function handInBox(view: HandInView, tools: HandInTools): TemplateResult {
  return html`<details class="hand-in" ?open=${view.open}
    @toggle=${(event: Event) => tools.toggle((event.target as HTMLDetailsElement).open)}>
    <summary>Hand in</summary>
    ${view.open ? content(view, tools) : ''}
  </details>`;
}

function content({ who, code, picture, reported }: HandInView, tools: HandInTools): TemplateResult {
  return html`<p>${
    who === ''
      ? 'No name or number is given: the code cannot be told from others’.'
      : html`For <strong>${who}</strong>.`
  } The code holds the name or number, the set, the seed, and of each question what stands in the
    boxes, how many tries and hints it took, and which mistakes were named. Nothing else${
      reported
        ? '. The course system gets it.'
        : ', and nothing is sent: give it to your lecturer as you were asked to.'
    }</p>
    <label class="hand-in-code"><span>Code</span>
      <textarea readonly rows="4" spellcheck="false" .value=${code}></textarea></label>
    <div class="buttons">
      <button type="button" class="button" @click=${tools.copy}>Copy the code</button>
      <button type="button" class="button" @click=${tools.save}>Save as a text</button>
    </div>
    <p>${
      who === ''
        ? 'Under a name or number it can be saved as statements of xAPI, too.'
        : html`<button type="button" class="button" @click=${tools.statements}>Save as xAPI
            statements</button> JSON for a learning record store: for each question that was
            tried, under this name, the last answer, whether it was right, and what was right.`
    }</p>
    ${picture}
    <p class="tolerance">A check value at its end finds a code that was cut or changed. It deters;
      it proves nothing about who answered.</p>`;
}

/** The box for a name or number, by which a student gets own numbers. */
export function nameForm(who: string, change: (who: string) => void): TemplateResult {
  return html`<label class="seed who">name or number <input name="who" maxlength="60"
    autocomplete="off" title="You get numbers of your own by it; the same name gets the same ones"
    .value=${who} @change=${(event: Event) =>
      change((event.target as HTMLInputElement).value)} /></label>`;
}
