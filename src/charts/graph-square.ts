import { svg, type TemplateResult } from 'lit';
import type { GraphModel } from '../state/graph-model.ts';
import { coordinate } from '../text/coordinate.ts';
import { display } from '../text/format.ts';
import { halo } from './graph-roots.ts';
import type { Scales } from './graph-scales.ts';

/** Distance of a label from its mark, in caption em. */
const AWAY = 1.5;
/** Distance of a label from the axis, in caption em, with room for the roots' labels. */
const CLEAR = 2.9;

/**
 * The completed square: where f turns, at −B/2A, and how high it is there, −D/4A; with roots the
 * half width √D/|2A| to both sides.
 */
export function square({ square }: GraphModel, { frame, x, y }: Scales): TemplateResult | string {
  if (!square) return '';
  const { left, right, top, bottom, em, mark } = frame;
  const [at, turn, zero] = [x(square.t), y(square.f), y(0)].map(coordinate) as [
    number,
    number,
    number,
  ];
  const isInside = at >= left && at <= right && turn >= top && turn <= bottom;
  if (!isInside) return '';
  // On the side of the axis that the curve leaves free.
  const up = turn >= zero ? -1 : 1;
  const label = Math.min(Math.max(zero + up * 4.2 * em, top + em), bottom - em);
  const widths = zero + up * 2.2 * em;
  const half = Number.isFinite(square.half) ? coordinate(x(square.t + square.half) - at) : 0;
  const beside = widths + (up < 0 ? -0.5 : 1.2) * em;
  const hasHalf = half > 4;
  // If the vertex is near the axis, its label is kept clear of the roots' labels.
  const under = Math.max(-up * (turn - zero) + AWAY * em, CLEAR * em);
  const height = Math.min(Math.max(zero - up * under, top + 0.65 * em), bottom - 0.65 * em);
  const bracket = `M${at - half},${coordinate(widths)}h${2 * half}m0,-4v8m${-2 * half},-8v8`;
  const text = (px: number, py: number, words: string) =>
    svg`<text class="graph-tick graph-word" text-anchor="middle" x=${px} y=${coordinate(py)}
      >${words}</text>`;
  return svg`<g class="graph-square">
    <path class="graph-plumb" d=${`M${at},${turn}V${coordinate(hasHalf ? widths : label)}`}></path>
    <path class="graph-height" d=${`M${at},${zero}V${turn}m-4,0h8`}></path>
    ${
      hasHalf
        ? svg`<path class="graph-half" d=${bracket}></path>
          ${text(at, beside, `√D/|2A| = ${display(square.half)}`)}`
        : ''
    }
    <g transform="translate(${at},${turn})">${halo(5, mark)}<circle class="graph-vertex"
      r=${5 * mark}></circle></g>
    ${text(at, label + (up < 0 ? 0 : 0.8 * em), `−B/2A = ${display(square.t)}`)}
    ${text(at, height + 0.35 * em, `−D/4A = ${display(square.f)}`)}
  </g>`;
}
