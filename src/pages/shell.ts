import { html, nothing, type TemplateResult } from 'lit';
import type { Dispatch } from '../state/actions.ts';
import { type AppState, PAGES } from '../state/state.ts';
import type { Theme } from '../ui/theme.ts';
import './shell.css';

export interface ShellTools {
  readonly theme: Theme;
  readonly nextTheme: () => void;
  readonly copyLink: () => void;
  /** What was just done, in words; '' for nothing. */
  readonly said: string;
}

/** The header of every page, and what was wrong with the link that was opened. */
export function shell(state: AppState, dispatch: Dispatch, tools: ShellTools): TemplateResult {
  return html`<header class="header">
      <a class="brand" href="#/explore">${LOGO}<span>Graze</span></a>
      <nav aria-label="Pages">
        ${PAGES.map(
          ({ id, title }) =>
            html`<a class="tab" href=${`#/${id}`} aria-current=${id === state.page ? 'page' : nothing}>${title}</a>`,
        )}
      </nav>
      <div class="tools">
        <span class="said" role="status">${tools.said}</span>
        ${tool('Copy link', tools.copyLink, ICONS.link)}
        ${tool(`Theme: ${tools.theme}`, tools.nextTheme, ICONS.theme)}
      </div>
    </header>
    ${state.problems.length > 0 ? problems(state, dispatch) : nothing}`;
}

function problems(state: AppState, dispatch: Dispatch): TemplateResult {
  return html`<div class="problems" role="alert">
    <p>${state.problems.join(' · ')}</p>
    <button type="button" class="dismiss" @click=${() => dispatch({ type: 'dismiss' })}>Dismiss</button>
  </div>`;
}

function tool(label: string, act: () => void, icon: TemplateResult): TemplateResult {
  return html`<button type="button" class="tool" aria-label=${label} title=${label} @click=${act}>${icon}</button>`;
}

const LOGO = html`<svg viewBox="0 0 24 24" width="24" height="24" aria-hidden="true" class="logo">
  <circle cx="12" cy="14" r="6.6" class="logo-shape" />
  <path d="M1.5 7.4h21" class="logo-ray" />
  <circle cx="12" cy="7.4" r="2.6" class="logo-hit" />
</svg>`;

const ICONS = {
  link: html`<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><path d="M8.4 11.6a3 3 0 0 0 4.3 0l3-3a3 3 0 0 0-4.3-4.3l-1 1M11.600 8.400a3 3 0 0 0-4.3 0l-3 3a3 3 0 0 0 4.300 4.300l1-1" /></svg>`,
  theme: html`<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true"><circle cx="10" cy="10" r="6.600" /><path d="M10 3.4a6.600 6.600 0 0 1 0 13.200z" class="solid" /></svg>`,
};
