import { svg, type TemplateResult } from 'lit';
import type { GraphModel } from '../state/graph-model.ts';
import { coordinate } from '../text/coordinate.ts';
import { clamp } from './axis-steps.ts';
import { LETTER } from './graph-frame.ts';
import type { Scales } from './graph-scales.ts';

/** Of the words over the axis, of the bracket under it, and of the words under that, in em. */
const [ABOVE, UNDER, BELOW] = [1.2, 1.6, 2.9];

/** What stands beside the mark of a prediction, and how far it is from the hit. */
export function mark({ mark, bead }: GraphModel, { frame, x, y }: Scales): TemplateResult | string {
  if (!mark) return '';
  const { left, right, top, bottom, em } = frame;
  const zero = clamp(y(0), top + 2 * em, bottom - (BELOW + 0.6) * em);
  const inPlot = (t: number): number => coordinate(clamp(x(t), left, right));
  /** Centred over a place, but within the graph. */
  const text = (at: number, height: number, words: string) => {
    const half = (words.length * LETTER * em) / 2;
    const middle = clamp(at, left + half, Math.max(right - half, left + half));
    return svg`<text class="graph-tick graph-word" text-anchor="middle" x=${coordinate(middle)}
      y=${coordinate(height)}>${words}</text>`;
  };
  const title = text(inPlot(bead.t), zero - ABOVE * em, mark.title);
  if (!mark.gap) return title;
  const [from, to] = [inPlot(mark.gap.from), inPlot(mark.gap.to)];
  const height = coordinate(zero + UNDER * em);
  return svg`${title}<g class="graph-gap">
    <path class="graph-height"
      d=${`M${from},${height - 4}v8M${from},${height}H${to}m0,-4v8`}></path>
    ${text((from + to) / 2, zero + BELOW * em, mark.gap.text)}
  </g>`;
}
