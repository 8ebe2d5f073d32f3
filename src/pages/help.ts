import { html, type TemplateResult } from 'lit';
import type { PageId } from '../state/state.ts';
import { setVolume, volume } from '../ui/volume.ts';
import { commandTitle } from './command-titles.ts';
import type { Command } from './commands.ts';
import { ABOUT, HELP } from './help-pages.ts';
import './help.css';

interface KeyChoice {
  readonly singleKeys: boolean;
  readonly choose: (on: boolean) => void;
}

/** The help: every key that works on the page, from the table of commands, and its controls. */
export function helpContent(
  commands: readonly Command[],
  page: PageId,
  { singleKeys, choose }: KeyChoice,
): TemplateResult {
  return html`<div class="help">
    <p>${ABOUT[page]}</p>
    <dl class="keys">
      ${commands
        .filter(({ pages }) => pages?.includes(page) ?? true)
        .map(
          ({ id, keys }) =>
            html`<div><dt>${keys.map(
              (key, i) => html`${i > 0 ? ' or ' : ''}<kbd>${keyWords(key)}</kbd>`,
            )}</dt><dd>${commandTitle(id)}</dd></div>`,
        )}
    </dl>
    <label class="choice-line"><input
      type="checkbox"
      .checked=${singleKeys}
      @change=${(event: Event) => choose((event.target as HTMLInputElement).checked)}
    /> single letters and digits work as keys</label>
    <label class="choice-line">volume of what <kbd>m</kbd> lets hear <input type="range" min="0"
      max="1" step="0.05" .value=${String(volume())}
      @input=${(event: Event) => setVolume((event.target as HTMLInputElement).valueAsNumber)}
    /></label>
    <h3>Numbers</h3>
    <p>A box takes any number: <code>1/3</code>, <code>sqrt(2)</code>, <code>1e7</code>,
      <code>-2^-40</code>, <code>0,5</code >. Three numbers pasted into a box of E, d, N, P, C or
      V fill all three. Up and Down change it by a step, with Shift by a tenth. A click on a
      result shows all of its digits.</p>
    <h3>Keyboard</h3>
    <p>Tab stops once in a group of buttons, boxes or results; arrows, Home and End go on within it.
      In a box Left and Right do so at the ends of its text, and while all of it is selected.</p>
    ${HELP[page]}
    <h3>Clicker</h3>
    <p>Page Down and Page Up go on and back in Explore and in lessons, also after a click on a
      slider, a box, a list or the bead. In Explore a control that Tab, an arrow, Home or End was
      pressed on since keeps them. What ends the black screen does nothing else; in a text box the
      full stop is text. Clickers that send b for it are not understood: b plays the bead.</p>
    <h3>Links and files</h3>
    <p>The address holds the whole state and can be written by hand. A saved state can be dropped
      on the page.</p>
    ${licences()}
  </div>`;
}

/** The licences: inline in the offline file, a link to a file on a site. */
function licences(): TemplateResult {
  const kept = document.getElementById('third-party');
  if (kept instanceof HTMLTemplateElement) {
    return html`<details
      class="licences"><summary>Licences of the packages and the font in this file</summary>
      <pre tabindex="0">${kept.content.textContent}</pre></details>`;
  }
  return html`<p class="licences"><a href="./THIRD-PARTY.txt" target="_blank"
    rel="noopener">Licences of the packages and the font in Graze</a></p>`;
}

const NAMES: Readonly<Record<string, string>> = {
  ArrowRight: '→',
  ArrowLeft: '←',
  PageDown: 'Page Down',
  PageUp: 'Page Up',
};

export function keyWords(key: string): string {
  return NAMES[key] ?? key.replace(/\+([a-z])$/, (_, letter: string) => `+${letter.toUpperCase()}`);
}
