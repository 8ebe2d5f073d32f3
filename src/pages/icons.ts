import { html, svg, type TemplateResult } from 'lit';

const icon = (content: TemplateResult): TemplateResult =>
  html`<svg viewBox="0 0 20 20" width="18" height="18" aria-hidden="true">${content}</svg>`;

export const ICONS = {
  undo: icon(svg`<path d="M7.5 4.500L4 8l3.5 3.500M4.5 8H12a3.8 3.8 0 0 1 0 7.600H8.5" />`),
  redo: icon(svg`<path d="M12.5 4.500L16 8l-3.5 3.500M15.5 8H8a3.8 3.8 0 0 0 0 7.600h3.5" />`),
  link: icon(
    svg`<path
      d="M8.4 11.600a3 3 0 0 0 4.3 0l3-3a3 3 0 0 0-4.3-4.300l-1
        1M11.6 8.400a3 3 0 0 0-4.3 0l-3 3a3 3 0 0 0 4.3 4.300l1-1" />`,
  ),
  export: icon(svg`<path d="M5 2.800h6.500L15 6.300v10.900H5zM11.5 2.800v3.500H15" />`),
  full: icon(svg`<path d="M3 4.500h14v9H3zM10 13.500v3M6.5 16.500h7" />`),
  theme: icon(
    svg`<circle cx="10" cy="10" r="6.6" /><path d="M10 3.400a6.6 6.6 0 0 1 0 13.200z" class="solid"
      />`,
  ),
  help: icon(
    svg`<circle cx="10" cy="10" r="6.8" /><path
      d="M7.9 8.200a2.1 2.1 0 1 1 3 1.900c-.6.3-.9.7-.9 1.300M10 13.600v.3" />`,
  ),
};

export const LOGO = html`<svg viewBox="0 0 24 24" width="24" height="24" aria-hidden="true"
  class="logo">
  <circle cx="12" cy="14" r="6.6" class="logo-shape" />
  <path d="M1.5 7.400h21" class="logo-ray" />
  <circle cx="12" cy="7.4" r="2.6" class="logo-hit" />
</svg>`;
