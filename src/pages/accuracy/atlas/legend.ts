import { html, type TemplateResult } from 'lit';
import { ref } from 'lit/directives/ref.js';
import { inkOfLost, PATTERNS } from '../../../charts/map-ink.ts';
import { MARKS, type Mark, TENTHS } from '../../../lab/atlas/marks.ts';
import { LEAVING_WORDS, MARK_WORDS, shareWords } from '../../../state/accuracy/atlas-words.ts';
import type { Shown } from './atlas-exports.ts';

/** How the marks of a map look, and what share of each map they are. */
export function legend(shown: readonly Shown[], isLeaving: boolean): TemplateResult {
  const words = isLeaving ? LEAVING_WORDS : MARK_WORDS;
  const marks = MARKS.filter((mark) => !isLeaving || (mark !== 'count' && mark !== 'undecided'));
  return html`<ul class="atlas-legend" aria-label="What the marks mean">
    ${marks.map((mark) =>
      mark === 'right'
        ? item(
            mark,
            isLeaving ? 'right' : 'right; darker: more digits lost',
            isLeaving ? () => 0 : lost,
            shown,
          )
        : item(mark, words[mark], PATTERNS[mark], shown),
    )}
  </ul>`;
}

/** The share of a mark in each map, of the pixels that have a ray. */
const shares = (mark: Mark, shown: readonly Shown[]): string =>
  mark === 'nothing'
    ? ''
    : shown
        .map(({ summary }) =>
          summary && summary.rays > 0 ? shareWords(summary.counts[mark], summary.rays) : '…',
        )
        .join(' | ');

const WIDTH = 44;
const HEIGHT = 15;
/** Places of the pattern per pixel of the sample. */
const DENSITY = 2;

/** From no digit lost to all. */
const lost = (x: number): number => inkOfLost((16 * TENTHS * x) / (WIDTH * DENSITY));

function item(
  mark: Mark,
  words: string,
  ink: (x: number, y: number, size: number) => number,
  shown: readonly Shown[],
): TemplateResult {
  return html`<li><canvas class="atlas-sample" width=${WIDTH * DENSITY} height=${HEIGHT * DENSITY}
    data-mark=${mark} aria-hidden="true" ${ref((element) => paint(element, ink))}></canvas>
    <span>${words}</span> <b>${shares(mark, shown)}</b></li>`;
}

function paint(element: Element | undefined, ink: (x: number, y: number, size: number) => number) {
  if (!(element instanceof HTMLCanvasElement)) return;
  const context = element.getContext('2d');
  if (!context) return;
  // Ink on nothing: what is below shows through, in every theme.
  const { color } = getComputedStyle(element.parentElement ?? element);
  context.clearRect(0, 0, element.width, element.height);
  context.fillStyle = color;
  for (let y = 0; y < element.height; y++) {
    for (let x = 0; x < element.width; x++) {
      context.globalAlpha = ink(x, y, 5 * DENSITY);
      context.fillRect(x, y, 1, 1);
    }
  }
}
