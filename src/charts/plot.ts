import { svg, type TemplateResult } from 'lit';
import { coordinate } from '../text/coordinate.ts';
import { LETTER, type Metrics } from './graph-frame.ts';
import type { Box, LabelRequest, PlacedLabel } from './mark-labels.ts';
import './graph.css';
import './plot.css';

/** The area of a plot in px; margins depend on the type size. */
export interface Field extends Metrics {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

export interface PlotTick {
  readonly at: number;
  readonly label: string;
}

/** @param names width in em for names at the right. @param scales rows of ticks below. */
export function fieldOf(metrics: Metrics, names = 0, scales = 1): Field {
  const { width, height, em } = metrics;
  return {
    ...metrics,
    left: Math.round(3.4 * em),
    right: Math.round(width - 1 * em - names * em),
    top: Math.round(2.6 * em),
    bottom: Math.round(height - (2.3 + 1.3 * scales) * em),
  };
}

/** Estimated size of a label in px, from its number of letters. */
export const labelSize = (text: string, em: number): Pick<LabelRequest, 'width' | 'height'> => ({
  width: text.length * LETTER * em + 4,
  height: 1.3 * em,
});

export const fieldBox = ({ left, right, top, bottom, em }: Field): Box => ({
  left: left + 2,
  top: top - 1.4 * em,
  width: right - left - 2,
  height: bottom - top + 1.4 * em - 4,
});

export const px = (x: number): string => coordinate(x).toFixed(1);

/** Lines at the y ticks, and the axis at the bottom with its ticks and title. */
export function axes(
  field: Field,
  x: {
    readonly ticks: readonly PlotTick[];
    readonly title: string;
    /** Ticks at which grid lines are drawn, if not at all ticks. */
    readonly grid?: readonly PlotTick[];
  },
  y: { readonly ticks: readonly PlotTick[]; readonly title: string },
): TemplateResult {
  const { left, right, top, bottom, em } = field;
  return svg`<g class="plot-axes">
    ${(x.grid ?? x.ticks).map(
      ({ at }) =>
        svg`<line class="plot-grid" x1=${px(at)} x2=${px(at)} y1=${top} y2=${bottom}></line>`,
    )}
    ${y.ticks.map(
      ({
        at,
        label,
      }) => svg`<line class="plot-grid" x1=${left} x2=${right} y1=${px(at)} y2=${px(at)}></line>
      <text class="plot-tick" text-anchor="end" x=${px(left - 0.7 * em)}
        y=${px(at + 0.35 * em)}>${label}</text>`,
    )}
    <line class="plot-axis" x1=${left} x2=${right} y1=${bottom} y2=${bottom}></line>
    ${x.ticks.map(
      ({ at, label }) => svg`<line class="plot-nick"
        x1=${px(at)} x2=${px(at)} y1=${bottom} y2=${bottom + 6}></line>
      <text class="plot-tick" text-anchor="middle" x=${px(at)}
        y=${px(bottom + 1.5 * em)}>${label}</text>`,
    )}
    <text class="plot-title" text-anchor="end" x=${right}
      y=${px(field.height - 0.6 * em)}>${x.title}</text>
    <text class="plot-title" x="0" y=${px(0.9 * em)}>${y.title}</text>
  </g>`;
}

/** A label, with a line to its mark if it is far from it. */
export function nameAt(
  text: string | TemplateResult,
  { left, top, width, height, led }: PlacedLabel,
  mark: { readonly x: number; readonly y: number },
  em: number,
  cls = '',
): TemplateResult {
  const nearX = Math.max(left, Math.min(mark.x, left + width));
  const nearY = Math.max(top, Math.min(mark.y, top + height));
  return svg`${
    led
      ? svg`<line class="plot-leader" x1=${px(mark.x)} y1=${px(mark.y)}
          x2=${px(nearX)} y2=${px(nearY)}></line>`
      : ''
  }
    <text class=${`plot-name ${cls}`} x=${px(left + 2)} y=${px(top + 0.98 * em)}>${text}</text>`;
}
