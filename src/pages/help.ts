import { html, type TemplateResult } from 'lit';
import type { Command } from './commands.ts';
import './help.css';

export interface KeyChoice {
  readonly singleKeys: boolean;
  readonly choose: (on: boolean) => void;
}

/** Every key there is, from the same table that the keys come from, and how the controls are worked. */
export function helpContent(
  commands: readonly Command[],
  { singleKeys, choose }: KeyChoice,
): TemplateResult {
  return html`<div class="help">
    <p>Choose a shape and move the ray R(t) = E + t d. Everything else follows: the coefficients, the
      roots, the points and the normals. t counts in lengths of d.</p>
    <dl class="keys">
      ${commands.map(
        ({ title, keys }) =>
          html`<div><dt>${keys.map((key, i) => html`${i > 0 ? ' or ' : ''}<kbd>${shown(key)}</kbd>`)}</dt><dd>${title}</dd></div>`,
      )}
    </dl>
    <label class="choice-line"><input
      type="checkbox"
      .checked=${singleKeys}
      @change=${(event: Event) => choose((event.target as HTMLInputElement).checked)}
    /> single letters and digits work as keys</label>
    <h3>Numbers</h3>
    <p>A box takes any number: <code>1/3</code>, <code>sqrt(2)</code>, <code>1e7</code>,
      <code>-2^-40</code>, <code>0,5</code>. Three numbers pasted into a box of E, d, N, P, C or V fill
      all three. Up and Down change it by a step, with Shift by a tenth. A click on a result shows all of its digits.</p>
    <h3>In the scene</h3>
    <p>Drag E, the tip of d, the shape’s own point or its radius; drag the background to look from elsewhere, turn the
      wheel or pinch to come closer. With the keyboard: Tab to a handle, arrows move it along x and y, Page Up and Page
      Down along z, Shift makes the steps fine, Alt lets go of the grid. On the scene itself the arrows turn it, + and −
      zoom, 0 goes back.</p>
    <h3>Links and files</h3>
    <p>The address holds the whole state and can be written by hand. A saved state can be dropped on the page.</p>
  </div>`;
}

const NAMES: Readonly<Record<string, string>> = {
  ArrowRight: '→',
  ArrowLeft: '←',
  PageDown: 'Page Down',
  PageUp: 'Page Up',
};

function shown(key: string): string {
  return NAMES[key] ?? key.replace(/\+([a-z])$/, (_, letter: string) => `+${letter.toUpperCase()}`);
}
