import { html, nothing, svg, type TemplateResult } from 'lit';
import { askedOf } from '../check/asked.ts';
import type { Posed } from '../check/compose.ts';
import type { Pixel } from '../check/exercises/define.ts';
import { shownOf, stepOf, turnOf } from '../check/exercises/graph.ts';
import './check-drawing.css';

/** What stands beside a question in place of the scene, on the page and on paper. */
export function questionDrawing(posed: Posed, id: string): TemplateResult | typeof nothing {
  const { exercise, draft } = posed;
  const { described } = askedOf(posed);
  if (exercise.picture === 'graph') return framed(graphOf(turnOf(draft)), described, id);
  if (exercise.picture === 'pixels' && draft.pixel) {
    return framed(pixelsOf(draft.pixel), described, id);
  }
  return nothing;
}

interface Picture {
  readonly width: number;
  readonly height: number;
  readonly content: unknown;
}

const framed = ({ width, height, content }: Picture, words: string, id: string): TemplateResult =>
  html`<svg class="question-drawing" role="img" aria-labelledby=${`${id}-drawing`}
    viewBox=${`0 0 ${width} ${height}`} width=${width} height=${height}>
    <title id=${`${id}-drawing`}>${words}</title>${content}</svg>`;

/** Side of a unit of t in pixels; one of f is smaller where more of them are shown. */
const CELL = 40;
const GRAPH_HEIGHT = 280;
const MARGIN = { left: 40, right: 26, top: 14, bottom: 30 };

function graphOf(turn: ReturnType<typeof turnOf>): Picture {
  const { t, F, A } = turn;
  const [from, to] = [Math.floor(t) - 3, Math.ceil(t) + 3];
  const f = (x: number): number => F + A * (x - t) ** 2;
  const [least, most] = shownOf(turn);
  const step = stepOf(turn) ?? 1;
  const [low, high] = [Math.floor(least / step) * step, Math.ceil(most / step) * step];
  const width = MARGIN.left + (to - from) * CELL + MARGIN.right;
  const scale = (GRAPH_HEIGHT - MARGIN.top - MARGIN.bottom) / (high - low);
  const x = (at: number): number => MARGIN.left + (at - from) * CELL;
  const y = (at: number): number => MARGIN.top + (high - at) * scale;
  const whole = (a: number, b: number, by: number): number[] =>
    Array.from({ length: Math.round((b - a) / by) + 1 }, (_, k) => a + k * by);
  // To the border of the drawing, where the parabola leaves it.
  const reach = Math.min(3.5, Math.sqrt(Math.abs(((A > 0 ? high : low) - F) / A)));
  const points = Array.from({ length: 81 }, (_, k) => {
    const at = Math.min(to, Math.max(from, t + ((k - 40) / 40) * reach));
    return `${x(at).toFixed(2)},${y(f(at)).toFixed(2)}`;
  });
  const halves = whole(low, high, step / 2);
  return {
    width,
    height: GRAPH_HEIGHT,
    content: svg`<g class="lines">
      ${whole(from, to, 0.5).map(
        (at) => svg`<line class=${Number.isInteger(at) ? 'whole' : 'half'}
          x1=${x(at)} x2=${x(at)} y1=${y(high)} y2=${y(low)} />`,
      )}
      ${halves.map(
        (at) => svg`<line class=${Number.isInteger(at / step) ? 'whole' : 'half'}
          x1=${x(from)} x2=${x(to)} y1=${y(at)} y2=${y(at)} />`,
      )}</g>
      <line class="axis" x1=${x(from)} x2=${x(to)} y1=${y(0)} y2=${y(0)} />
      ${
        from <= 0 && to >= 0
          ? svg`<line class="axis" x1=${x(0)} x2=${x(0)} y1=${y(high)} y2=${y(low)} />`
          : ''
      }
      <polyline class="curve" points=${points.join(' ')} />
      <circle class="turn" cx=${x(t)} cy=${y(F)} r="4" />
      <g class="numbers">
      ${whole(from, to, 1).map(
        (at) =>
          svg`<text x=${x(at)} y=${GRAPH_HEIGHT - 12} text-anchor="middle">${minus(at)}</text>`,
      )}
      ${whole(low, high, step).map(
        (at) =>
          svg`<text x=${MARGIN.left - 6} y=${y(at) + 4} text-anchor="end">${minus(at)}</text>`,
      )}
      <text class="name" x=${x(to) + 14} y=${GRAPH_HEIGHT - 12}>t</text>
      <text class="name" x="4" y=${MARGIN.top + 4}>f</text></g>`,
  };
}

const minus = (x: number): string => (x < 0 ? `−${-x}` : String(x));

const PIXEL = 30;

function pixelsOf({ column, row, columns, rows }: Pixel): Picture {
  const edge = 26;
  const cells = Array.from({ length: rows }, (_, j) =>
    Array.from({ length: columns }, (__, i) => ({ i, j, is: i === column && j === row })),
  ).flat();
  return {
    width: edge + columns * PIXEL + 2,
    height: edge + rows * PIXEL + 2,
    content: svg`<g class="pixels">
      ${[...cells]
        .sort((a, b) => Number(a.is) - Number(b.is))
        .map(
          ({ i, j, is }) => svg`<rect class=${is ? 'chosen' : ''} x=${edge + i * PIXEL}
          y=${edge + j * PIXEL} width=${PIXEL} height=${PIXEL} />`,
        )}
      <circle class="turn" cx=${edge + (column + 0.5) * PIXEL}
        cy=${edge + (row + 0.5) * PIXEL} r="3" />
      </g><g class="numbers">
      ${Array.from(
        { length: columns },
        (_, i) => svg`<text x=${edge + (i + 0.5) * PIXEL} y=${edge - 8}
          text-anchor="middle">${i}</text>`,
      )}
      ${Array.from(
        { length: rows },
        (_, j) => svg`<text x=${edge - 8} y=${edge + (j + 0.5) * PIXEL + 4}
          text-anchor="end">${j}</text>`,
      )}</g>`,
  };
}
