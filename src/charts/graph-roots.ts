import { svg, type TemplateResult } from 'lit';
import { CAP_NAMES } from '../state/ends.ts';
import type { GraphModel } from '../state/graph-model.ts';
import { coordinate } from '../text/coordinate.ts';
import { clamp } from './axis-steps.ts';
import type { Scales } from './graph-scales.ts';

type Root = GraphModel['roots'][number];

interface LabelPosition {
  readonly side: 'start' | 'middle' | 'end';
  readonly dx: number;
  readonly below: boolean;
}

/** Width of "t₁", and the height it needs above and below the axis, in caption em. */
const [LABEL, ROOM_ABOVE, ROOM_BELOW] = [1.5, 2.2, 3.4];
/** Distance of two roots beside which "cut off" has room, in caption em. */
const CUT_LABELS = 12;
/** Width of the name of a cap, in caption em. */
const CAP_LABEL = 6;
/** Distance in px from a root to the side of its label. */
const AWAY = 9;

/**
 * Marks and labels of the roots: a filled disc, a ring, or a grey × for one that does not count.
 */
export function roots(model: GraphModel, scales: Scales): TemplateResult {
  const { frame, x } = scales;
  const y = coordinate(clamp(scales.y(0), frame.top, frame.bottom));
  const visible = model.roots.filter(({ t }) => x(t) >= frame.left && x(t) <= frame.right);
  // The first hit is drawn last, on top of a root that is a pixel apart.
  const ordered = [...visible].sort(
    (p, q) => Number(p.role === 'first') - Number(q.role === 'first'),
  );
  const isWide = gapOf(model, x) > CUT_LABELS * frame.em;
  return svg`${ordered.map(
    (root) => svg`<g class="graph-root graph-${root.role}" data-symbol="t${root.index}"
      transform="translate(${coordinate(x(root.t))},${y})">
      ${mark(root, frame.mark)}${label(root, place(root, model, scales), frame.em, isWide)}
    </g>`,
  )}`;
}

/** Marks where the ray goes through a cap, on the curve. */
export function caps(model: GraphModel, { frame, x, y }: Scales): TemplateResult {
  const visible = model.caps.filter(({ t }) => x(t) >= frame.left && x(t) <= frame.right);
  return svg`${visible.map(({ end, t, f, role }) => {
    const [px, py] = [x(t), clamp(y(f), frame.top, frame.bottom)];
    // Below the curve, on the side that it comes from.
    const falls = 2 * model.A * t + model.B < 0;
    const fits = falls
      ? px - CAP_LABEL * frame.em > frame.left
      : px + CAP_LABEL * frame.em < frame.width;
    const side = falls === fits ? 'end' : 'start';
    return svg`<g class="graph-root graph-${role}" data-symbol="t${end === 'low' ? 3 : 4}"
      transform="translate(${coordinate(px)},${coordinate(py)})">
      ${mark({ role }, frame.mark)}<text class="graph-name graph-double" text-anchor=${side}
        x=${side === 'start' ? AWAY : -AWAY} y=${coordinate(1.1 * frame.em)}>${
          CAP_NAMES[end]
        }</text>
    </g>`;
  })}`;
}

function mark({ role }: Pick<Root, 'role'>, scale: number): TemplateResult {
  if (role === 'first')
    return svg`${halo(7, scale)}<circle class="graph-disc" r=${7 * scale}></circle>`;
  if (role === 'other')
    return svg`${halo(7.2, scale)}<circle class="graph-ring" r=${6 * scale}></circle>`;
  const r = 4.6 * scale;
  const cross = `M${-r},${-r}L${r},${r}M${-r},${r}L${r},${-r}`;
  return svg`<path class="graph-cross-halo" d=${cross}></path><path class="graph-cross"
    d=${cross}></path>`;
}

/** Two px of background around a mark. */
export function halo(radius: number, scale: number): TemplateResult {
  return svg`<circle class="graph-halo" r=${radius * scale + 2}></circle>`;
}

function label(
  { index, double, role }: Root,
  { side, dx, below }: LabelPosition,
  em: number,
  isWide: boolean,
): TemplateResult {
  const up = side === 'middle' ? 1.05 * em : 0.65 * em;
  const dy = below ? up + 0.85 * em : -up;
  const beside = role === 'cut' && isWide ? 'cut off' : double ? 'double root' : '';
  return svg`<text class="graph-name" text-anchor=${side} x=${coordinate(dx)}
    y=${coordinate(dy)}>𝑡<tspan class="graph-index" dy="0.22em">${index}</tspan>${
      beside ? svg`<tspan class="graph-double" dx="0.4em" dy="-0.3em">${beside}</tspan>` : ''
    }</text>`;
}

/** Place of a root's label on the side that the curve leaves free. */
function place(root: Root, model: GraphModel, scales: Scales): LabelPosition {
  const { frame, x, y } = scales;
  const slope = slopeAt(root, model);
  const above = y(0) - frame.top > ROOM_ABOVE * frame.em;
  const below = frame.bottom - y(0) > ROOM_BELOW * frame.em;
  if (slope === 0) return { side: 'middle', dx: 0, below: !above || (model.A > 0 && below) };
  const gap = gapOf(model, x);
  const isCrowded = model.A > 0 && gap < 2 * LABEL * frame.em + AWAY * 2;
  // Two labels do not fit between close roots of a parabola that opens upwards.
  if (isCrowded && !below) return overBoth(slope, gap);
  const isBelow = !above || isCrowded;
  const side = flipped(slope < 0 === isBelow ? 'end' : 'start', x(root.t), scales);
  return { side, dx: side === 'start' ? AWAY : -AWAY, below: isBelow };
}

/** Place for "t₁ t₂" side by side over the middle of two close roots. */
function overBoth(slope: number, gap: number): LabelPosition {
  const isFirst = slope < 0;
  const middle = isFirst ? gap / 2 : -gap / 2;
  return { side: isFirst ? 'end' : 'start', dx: middle + (isFirst ? -3 : 3), below: false };
}

/** A number with the sign of f′ at the root. */
function slopeAt(root: Root, { A, B, roots }: GraphModel): number {
  if (root.double) return 0;
  if (A === 0 || roots.length < 2) return B;
  return root === roots[0] ? -A : A;
}

function gapOf({ roots: [first, second] }: GraphModel, x: Scales['x']): number {
  return first && second ? Math.abs(x(second.t) - x(first.t)) : Number.POSITIVE_INFINITY;
}

function flipped(side: 'start' | 'end', at: number, { frame }: Scales): 'start' | 'end' {
  const width = LABEL * frame.em + AWAY;
  if (side === 'start' && at + width > frame.width) return 'end';
  return side === 'end' && at - width < frame.left ? 'start' : side;
}
