import { html, type TemplateResult } from 'lit';
import { definitionOf } from '../../math/shapes.ts';
import { LINK_THEMES, type LinkTheme, PARTS, type Part } from '../../state/embed.ts';
import { type AppState, shapeOf } from '../../state/state.ts';
import { encode } from '../../state/url.ts';
import { copyText } from '../../ui/clipboard.ts';
import { createDialog } from '../../ui/dialog.ts';
import { elementLine, frameLine } from './lines.ts';
import './embed-dialog.css';

/** Titles of the parts, as the page calls them. */
const TITLES: Readonly<Record<Part, string>> = {
  scene: 'scene',
  graph: 'graph of f',
  algebra: 'algebra',
  parameters: 'parameters',
  hits: 'hits',
  caption: 'caption',
};

interface Choice {
  readonly parts: readonly Part[];
  readonly lock: readonly string[];
  readonly isHidden: boolean;
  readonly theme: LinkTheme | null;
}

/** Makes the line that puts the present state into another page, and shows what it will be. */
export function createEmbedDialog(now: () => AppState, say: (words: string) => void): () => void {
  let choice: Choice = { parts: ['scene', 'graph'], lock: [], isHidden: false, theme: null };
  const choose = (next: Partial<Choice>): void => {
    choice = { ...choice, ...next };
    dialog.refresh();
  };
  const dialog = createDialog('Embed in a page', () => content(now(), choice, choose, copy));
  const copy = async (line: string): Promise<void> => {
    const copied = await copyText(line);
    dialog.close();
    say(copied ? 'copied: the line for a page' : 'it could not be copied: mark it and copy it');
  };
  return () => {
    const { revealed, lock } = now();
    choice = { ...choice, isHidden: revealed !== null, lock };
    dialog.open();
  };
}

function content(
  state: AppState,
  { parts, lock, isHidden, theme }: Choice,
  choose: (next: Partial<Choice>) => void,
  copy: (line: string) => void,
): TemplateResult {
  const symbols = ['E', 'd', ...definitionOf(shapeOf(state)).params.map(({ symbol }) => symbol)];
  const kept = lock.filter((symbol) => symbols.includes(symbol));
  const revealed = isHidden ? 0 : null;
  const shown = { ...state, page: 'explore', embed: parts, lock: kept, theme, revealed } as const;
  const site = location.href.replace(/#.*$/, '');
  const link = `${site}${encode(shown)}`;
  const lines = [
    { id: 'frame', title: 'as a frame', line: frameLine(link) },
    { id: 'element', title: 'as an element', line: elementLine(shown, site) },
  ];
  return html`<div class="embed-dialog">
    <form class="embed-choices" @submit=${(event: Event) => event.preventDefault()}>
      <fieldset><legend>Shown</legend>
        ${boxes(
          PARTS,
          parts,
          (part) => TITLES[part],
          (next) => choose({ parts: next }),
        )}
      </fieldset>
      <fieldset><legend>Locked</legend>
        ${boxes(
          symbols,
          kept,
          (symbol) => symbol,
          (next) => choose({ lock: next }),
        )}
      </fieldset>
      <fieldset><legend>Look</legend>
        <label><input type="checkbox" .checked=${isHidden}
          @change=${(e: Event) => choose({ isHidden: (e.target as HTMLInputElement).checked })}
        /> results hidden</label>
        <label>theme <select .value=${theme ?? ''}
          @change=${(event: Event) => {
            const { value } = event.target as HTMLSelectElement;
            choose({ theme: LINK_THEMES.find((one) => one === value) ?? null });
          }}>
          <option value="">the reader's own</option>
          ${LINK_THEMES.map((one) => html`<option value=${one}>${one}</option>`)}
        </select></label>
      </fieldset>
    </form>
    ${
      parts.length === 0
        ? html`<p data-say>Nothing is shown: choose a part.</p>`
        : html`<iframe class="embed-preview" title="How it will look" src=${link}></iframe>`
    }
    ${lines.map(
      ({ id, title, line }) => html`<p class="embed-line" data-embed-line=${id}>
        <label>${title}<textarea readonly rows="3" .value=${line}></textarea></label>
        <button type="button" class="button" @click=${() => copy(line)}>Copy</button>
      </p>`,
    )}
    ${
      /^https?:/.test(site)
        ? ''
        : html`<p>This copy of Graze was opened from the disk: for a page on the web, the address in
          these lines has to be that of a copy on a server.</p>`
    }
  </div>`;
}

function boxes<T extends string>(
  all: readonly T[],
  chosen: readonly T[],
  title: (one: T) => string,
  choose: (next: readonly T[]) => void,
): TemplateResult[] {
  return all.map(
    (one) => html`<label><input type="checkbox" .checked=${chosen.includes(one)}
      @change=${(event: Event) => {
        const { checked } = event.target as HTMLInputElement;
        choose(all.filter((other) => (other === one ? checked : chosen.includes(other))));
      }}
    /> ${title(one)}</label>`,
  );
}
