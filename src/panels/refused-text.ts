import { html, nothing, type TemplateResult } from 'lit';

/** Why what was typed last into a box was not taken, by the name of the box. */
export type Refusals = Readonly<Record<string, string>>;

/** The reason, beside its box. */
export const refusal = (refusals: Refusals, box: string): TemplateResult =>
  html`<p class="refusal" data-say="problem">${refusals[box] || nothing}</p>`;

export const typedIn = (event: Event): string => (event.target as HTMLInputElement).value.trim();
