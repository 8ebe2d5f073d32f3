import { html, nothing, type TemplateResult } from 'lit';
import type { Dispatch } from '../state/actions.ts';
import { type AppState, PAGES, type PageId } from '../state/state.ts';
import { encode } from '../state/url.ts';
import type { Theme } from '../ui/theme.ts';
import type { Command } from './commands.ts';
import { ICONS, LOGO } from './icons.ts';
import './shell.css';

interface ShellTools {
  readonly theme: Theme;
  readonly command: (id: string) => Command | undefined;
  /** Shows a page; loads its code again if that failed. */
  readonly turn: (page: PageId) => void;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /** Words on the last action; '' for none. */
  readonly said: string;
}

/** The header of every page, and the messages on the opened link or file. */
export function shell(state: AppState, dispatch: Dispatch, tools: ShellTools): TemplateResult {
  // The links can be copied or opened in a tab. A plain click keeps the state that no link carries.
  const turnTo = (page: PageId) => (event: MouseEvent) => {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    event.preventDefault();
    tools.turn(page);
  };
  return html`<header class="header">
      <h1 class="visually-hidden">Graze: where does a ray meet a surface?</h1>
      <a class="brand" href="#/explore">${LOGO}<span>Graze</span></a>
      <nav aria-label="Pages">
        ${PAGES.map(
          ({ id, title }) =>
            html`<a class="tab" href=${encode({ ...state, page: id })} @click=${turnTo(id)}
              aria-current=${id === state.page ? 'page' : nothing}>${title}</a>`,
        )}
      </nav>
      <div class="tools" role="group" aria-label="Tools">
        <span class="said">${tools.said}</span>
        ${tool(tools, 'undo', 'Undo', !tools.canUndo)} ${tool(
          tools,
          'redo',
          'Redo',
          !tools.canRedo,
        )}
        <span class="divider"></span>
        ${tool(tools, 'link', 'Copy link')} ${tool(tools, 'export', 'File and export')}
        <span class="divider"></span>
        ${tool(tools, 'full', 'Full screen')} ${tool(tools, 'theme', `Theme: ${tools.theme}`)}
        ${tool(tools, 'help', 'Help')}
      </div>
    </header>
    ${state.problems.length > 0 ? problems(state, dispatch) : nothing}`;
}

function problems(state: AppState, dispatch: Dispatch): TemplateResult {
  return html`<aside class="problems" data-say="problem">
    <p>${state.problems.join(' · ')}</p>
    <button type="button" class="dismiss"
      @click=${() => dispatch({ type: 'dismiss' })}>Dismiss</button>
  </aside>`;
}

function tool(
  { command }: ShellTools,
  id: keyof typeof ICONS,
  label: string,
  resting = false,
): TemplateResult {
  const keys = command(id)?.keys.join(' or ') ?? '';
  return html`<button
    type="button"
    class="tool tool-${id}"
    aria-label=${label}
    title=${keys ? `${label} (${keys})` : label}
    aria-disabled=${resting}
    @click=${() => command(id)?.run()}
  >${ICONS[id]}</button>`;
}
