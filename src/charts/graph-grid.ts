import { svg, type TemplateResult } from 'lit';
import { coordinate } from '../text/coordinate.ts';
import { superscript } from '../text/scripts.ts';
import { clamp } from './axis-steps.ts';
import { type Frame, LETTER } from './graph-frame.ts';
import type { Scales, Tick } from './graph-scales.ts';

/** Distance in em from the plot to the labels at its left, and to those below it. */
const [ASIDE, UNDER] = [0.65, 1.4];
/** Length of a tick below the plot, in em. */
const NICK = 0.35;

/** The layer below the graph: t < 0, the grid of f, the line t = 0, labels of both axes. */
export function grid(scales: Scales, id: string): TemplateResult {
  const { frame, x } = scales;
  const { left, right, top, bottom } = frame;
  const zero = coordinate(clamp(x(0), left, right));
  const showsZero = x(0) >= left && x(0) <= right;
  const nick = coordinate(NICK * frame.em);
  return svg`
    <rect fill="url(#${id}-hatch)" x=${left} y=${top} width=${coordinate(zero - left)}
      height=${bottom - top}></rect>
    <path class="graph-grid"
      d=${scales.fTicks.map(({ at }) => `M${left},${coordinate(at)}H${right}`).join('')}></path>
    <path class="graph-nick"
      d=${scales.tTicks.map(({ at }) => `M${coordinate(at)},${bottom}v${nick}`).join('')}></path>
    ${scales.fTicks.map((tick) => fTick(tick, frame))}
    ${scales.tTicks.map((tick) => tTick(tick, frame))}
    ${names(scales)}
    ${
      showsZero
        ? svg`<line class="graph-zero" data-symbol="E" x1=${zero} x2=${zero}
            y1=${top} y2=${bottom}></line>`
        : ''
    }`;
}

function fTick({ at, label }: Tick, { left, top, em }: Frame): TemplateResult | string {
  const y = coordinate(at);
  // The highest label would touch the name of the axis.
  return y < top + 0.5 * em
    ? ''
    : svg`<text class="graph-tick" text-anchor="end" x=${coordinate(left - ASIDE * em)}
      y=${coordinate(y + 0.35 * em)}>${label}</text>`;
}

function tTick({ at, label }: Tick, { width, bottom, em }: Frame): TemplateResult | string {
  const x = coordinate(at);
  const half = (label.length * LETTER * em) / 2;
  // A label at an end must neither cover the name t nor leave the graph.
  return at - half > 2 * em && at + half < width
    ? svg`<text class="graph-tick" text-anchor="middle" x=${x}
      y=${coordinate(bottom + UNDER * em)}>${label}</text>`
    : '';
}

/** The names of the axes, and the power of ten that was taken out of the labels of f. */
function names({ frame: { left, top, bottom, em }, power }: Scales): TemplateResult {
  const common =
    power === 0
      ? ''
      : svg`<text class="graph-tick graph-power" text-anchor="end" x=${coordinate(left - 0.2 * em)}
        y=${coordinate(bottom - 0.1 * em)}>×10${superscript(power)}</text>`;
  return svg`${common}
    <text class="graph-var" x=${coordinate(1.2 * em)} y=${coordinate(bottom + UNDER * em)}>𝑡</text>
    <text class="graph-var" text-anchor="end" x=${coordinate(left - ASIDE * em)}
      y=${coordinate(top - 0.45 * em)}>𝑓(𝑡)</text>`;
}

/** Patterns and clips that the layers refer to. */
export function definitions(scales: Scales, id: string): TemplateResult {
  const { left, right, top, bottom } = scales.frame;
  const y = coordinate(clamp(scales.y(0), top, bottom));
  const width = right - left;
  return svg`<defs>
    <pattern id="${id}-hatch" width="7" height="7" patternUnits="userSpaceOnUse"
      patternTransform="rotate(45)">
      <line class="graph-hatch" x1="0.5" x2="0.5" y1="0" y2="7"></line>
    </pattern>
    <clipPath id="${id}-plot"><rect x=${left} y=${top} width=${width}
      height=${bottom - top}></rect></clipPath>
    <clipPath id="${id}-below"><rect x=${left} y=${y} width=${width}
      height=${bottom - y}></rect></clipPath>
  </defs>`;
}
