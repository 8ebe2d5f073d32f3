import { html, type TemplateResult } from 'lit';
import { inkOfLost, PATTERNS } from '../../../charts/map-ink.ts';
import { MARKS, type Mark, TENTHS } from '../../../lab/atlas/marks.ts';
import { LEAVING_WORDS, MARK_WORDS, shareWords } from '../../../state/accuracy/atlas-words.ts';
import type { ShownMap } from './atlas-exports.ts';

/** How the marks of a map look, and what share of each map they are. */
export function legend(shown: readonly ShownMap[], isLeaving: boolean): TemplateResult {
  const words = isLeaving ? LEAVING_WORDS : MARK_WORDS;
  const marks = MARKS.filter((mark) => !isLeaving || (mark !== 'count' && mark !== 'undecided'));
  return html`<ul class="atlas-legend" aria-label="What the marks mean">
    ${marks.map((mark) =>
      item(
        mark,
        mark === 'right' && !isLeaving ? 'right; darker: more digits lost' : words[mark],
        shown,
      ),
    )}
  </ul>`;
}

/** The share of a mark in each map, of the pixels that have a ray. */
const shares = (mark: Mark, shown: readonly ShownMap[]): string =>
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

function item(mark: Mark, words: string, shown: readonly ShownMap[]): TemplateResult {
  return html`<li><canvas class="atlas-sample" width=${WIDTH * DENSITY} height=${HEIGHT * DENSITY}
    data-mark=${mark} aria-hidden="true" ></canvas>
    <span>${words}</span> <b>${shares(mark, shown)}</b></li>`;
}

/**
 * Paints the samples in this ink, on nothing: what is below shows through. They are painted once
 * for each ink.
 */
export function paintSamples(root: HTMLElement, isLeaving: boolean, ink: string): void {
  for (const canvas of root.querySelectorAll<HTMLCanvasElement>('.atlas-sample')) {
    const mark = MARKS.find((one) => one === canvas.dataset.mark) ?? 'right';
    const pattern = mark !== 'right' ? PATTERNS[mark] : isLeaving ? () => 0 : lost;
    const look = `${ink} ${mark} ${isLeaving}`;
    if (painted.get(canvas) === look) continue;
    painted.set(canvas, look);
    paint(canvas, pattern, ink);
  }
}

const painted = new WeakMap<HTMLCanvasElement, string>();

function paint(
  canvas: HTMLCanvasElement,
  pattern: (x: number, y: number, size: number) => number,
  ink: string,
): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.fillStyle = ink;
  for (let y = 0; y < canvas.height; y++) {
    for (let x = 0; x < canvas.width; x++) {
      context.globalAlpha = pattern(x, y, 5 * DENSITY);
      context.fillRect(x, y, 1, 1);
    }
  }
}
