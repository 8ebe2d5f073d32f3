import { svg, type TemplateResult } from 'lit';
import { type Priced, steps } from '../lab/pareto.ts';
import type { FrontierMark } from '../state/accuracy/frontier.ts';
import type { Box } from './mark-labels.ts';
import { type Field, px } from './plot.ts';

/** The step line as thin boxes, which labels must not cover. */
export function lineBoxes(front: readonly Priced[], { right, bottom }: Field): Box[] {
  const [first] = front;
  const last = front.at(-1);
  if (!first || !last) return [];
  const corners = [[first.cost, bottom] as const, ...steps(front), [right, last.worth] as const];
  return corners.slice(1).map(([x, y], i) => {
    const [fromX, fromY] = corners[i] ?? [x, y];
    return {
      left: Math.min(x, fromX) - 1,
      top: Math.min(y, fromY) - 1,
      width: Math.abs(x - fromX) + 2,
      height: Math.abs(y - fromY) + 2,
    };
  });
}

/** The step line in px: up to the first worth, along the steps, on to the right edge. */
export function stepLine(front: readonly Priced[], { right, bottom }: Field): TemplateResult {
  const [first] = front;
  const last = front.at(-1);
  if (!first || !last) return svg``;
  const corners = steps(front).map(([x, y]) => `L${px(x)},${px(y)}`);
  const line = `M${px(first.cost)},${bottom}${corners.join('')}L${right},${px(last.worth)}`;
  return svg`<path class="plot-reach" d=${`${line}L${right},${bottom}Z`}></path>
    <path class="plot-step" d=${line}></path>`;
}

/** A method's mark: filled on the frontier, with a ring where it is chosen. */
export function markOf(
  mark: FrontierMark,
  x: number,
  y: number,
  isBest: boolean,
  chosen: boolean,
  scale: number,
  choose: (id: string) => void,
): TemplateResult {
  const key = (event: KeyboardEvent): void => {
    if (event.key !== 'Enter' && event.key !== ' ') return;
    event.preventDefault();
    choose(mark.id);
  };
  return svg`<g class="plot-mark" role="button" tabindex="0" data-method=${mark.id}
      aria-pressed=${chosen} aria-label=${mark.words} transform="translate(${px(x)},${px(y)})"
      @click=${() => choose(mark.id)} @keydown=${key}>
    <circle class="plot-touch" r="14"></circle>
    ${chosen ? svg`<circle class="plot-ring" r=${11 * scale}></circle>` : ''}
    ${
      mark.isFaint
        ? svg`<line class="plot-reference" y1=${-12 * scale} y2=${12 * scale}></line>`
        : ''
    }
    <circle class=${mark.isFaint ? 'plot-dot faint' : isBest ? 'plot-dot full' : 'plot-dot'}
      r=${(chosen ? 6.5 : 5) * scale}></circle>
    <circle class="plot-focus" r=${(chosen ? 14 : 10) * scale}></circle>
  </g>`;
}
