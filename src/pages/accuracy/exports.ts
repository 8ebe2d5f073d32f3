import { html, type TemplateResult } from 'lit';
import { download } from '../../ui/files.ts';
import { svgPng, svgText } from '../../ui/svg-text.ts';
import type { ExportItem } from '../export-dialog.ts';
import { type Findings, toCsv, toJson } from './result-files.ts';

/** The exports of the numbers as CSV and JSON. */
export function tableExports(findings: () => Findings | null): ExportItem[] {
  const textOf = (write: (found: Findings) => string) => (): string => {
    const found = findings();
    return found ? write(found) : '';
  };
  return [
    {
      id: 'table-csv',
      title: 'table as CSV',
      file: 'graze-accuracy.csv',
      type: 'text/csv',
      text: textOf(toCsv),
      blob: null,
    },
    {
      id: 'all-json',
      title: 'everything as JSON',
      file: 'graze-accuracy.json',
      type: 'application/json',
      text: textOf(toJson),
      blob: null,
    },
  ];
}

/** The exports of a plot as SVG and PNG, as it looks on the page. */
export function plotExports(name: string, plot: HTMLElement): ExportItem[] {
  const drawn = (): SVGSVGElement | null => plot.querySelector('svg');
  const paper = (): string => getComputedStyle(document.body).getPropertyValue('--bg');
  return [
    {
      id: `${name}-svg`,
      title: `the ${name} plot as SVG`,
      file: `graze-${name}.svg`,
      type: 'image/svg+xml',
      text: () => {
        const svg = drawn();
        return svg ? svgText(svg, paper()) : '';
      },
      blob: null,
    },
    {
      id: `${name}-png`,
      title: `the ${name} plot as PNG`,
      file: `graze-${name}.png`,
      type: 'image/png',
      text: null,
      blob: async () => {
        const svg = drawn();
        return svg ? svgPng(svg, paper()) : null;
      },
    },
  ];
}

/** A button for each export, with the label that `name` gives. */
export function saveButtons(
  all: readonly ExportItem[],
  name: (item: ExportItem) => string,
): TemplateResult {
  return html`${all.map(
    (item) =>
      html`<button type="button" class="acc-link" aria-label=${`Save ${item.title}`}
        @click=${() => save(item)}>${name(item)}</button>`,
  )}`;
}

export const extensionOf = ({ file }: ExportItem): string =>
  file.split('.').at(-1)?.toUpperCase() ?? '';

async function save({ file, type, text, blob }: ExportItem): Promise<void> {
  const content = text?.() ?? (await blob?.());
  if (content) download(file, content, type);
}
