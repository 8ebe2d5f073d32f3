import { coordinate } from '../text/coordinate.ts';
import type { Layer, Part } from './layer.ts';
import type { ScreenPoint } from './projection.ts';

export type MarkKind =
  | 'E'
  | 'head'
  | 'first'
  | 'other'
  | 'rejected'
  | 'bead'
  | 'point'
  | 'end'
  | 'ghost';

/** A mark of fixed size at a point of the scene. */
export interface Mark {
  readonly key: string;
  readonly kind: MarkKind;
  /** Symbols with which it is highlighted; the first is its data-symbol. */
  readonly symbols: readonly string[];
  readonly spot: Pick<ScreenPoint, 'x' | 'y'>;
  /** Degrees clockwise on the screen. */
  readonly turn?: number;
  readonly size?: number;
}

/** Radius that a label keeps free around a mark. */
export const CLEAR: Record<MarkKind, number> = {
  E: 13,
  head: 13,
  first: 11,
  other: 11,
  rejected: 10,
  bead: 8,
  point: 8,
  end: 8,
  ghost: 7,
};

const disc = (r: number, name: string): Part => ['circle', { r, class: name }];
const path = (d: string, name: string): Part => ['path', { d, class: name }];
const CROSS = 'M-5.5 -5.5L5.5 5.5M-5.5 5.5L5.5 -5.5';

/** Shapes of the marks around (0, 0); 'scene-gap' is a ring in the background's colour. */
const TEMPLATES: Record<MarkKind, readonly Part[]> = {
  E: [disc(16, 'scene-halo'), disc(10, 'scene-gap'), disc(8, 'scene-fill')],
  // The tip is at (0, 0): R(1) = E + d is where the head ends.
  head: [
    ['circle', { r: 12, cx: -9, class: 'scene-halo' }],
    path('M0 0L-20 -9L-15 0L-20 9Z', 'scene-fill scene-edged'),
  ],
  first: [disc(9, 'scene-gap'), disc(7, 'scene-fill')],
  other: [disc(9.4, 'scene-gap'), disc(6, 'scene-ring')],
  rejected: [path(CROSS, 'scene-cross-gap'), path(CROSS, 'scene-cross')],
  bead: [disc(7.5, 'scene-gap'), disc(5, 'scene-ring')],
  point: [disc(5.5, 'scene-gap'), disc(3.5, 'scene-fill')],
  ghost: [disc(6, 'scene-gap'), disc(4, 'scene-ring')],
  end: [path('M5 0L-6 -4.6L-6 4.6Z', 'scene-fill')],
};

/** Draws each mark as a <g>, which is kept while its key is used. */
export function drawMarks(
  layer: Layer,
  marks: readonly Mark[],
  scale: number,
  lit: string | null,
): void {
  layer.begin();
  for (const { key, kind, symbols, spot, turn = 0, size = 1 } of marks) {
    const isLit = lit !== null && symbols.includes(lit);
    const emphasis = isLit ? 1.25 : 1;
    const place = `translate(${coordinate(spot.x)} ${coordinate(spot.y)})`;
    const rotate = turn ? ` rotate(${turn.toFixed(2)})` : '';
    layer.show(
      `${key} ${kind}`,
      'g',
      {
        class: `scene-mark scene-${kind}${isLit ? ' lit' : ''}`,
        'data-mark': key,
        ...(symbols[0] ? { 'data-symbol': symbols[0] } : {}),
        transform: `${place}${rotate} scale(${(scale * size * emphasis).toFixed(3)})`,
      },
      TEMPLATES[kind],
    );
  }
  layer.end();
}

/** An arrow from one point of the screen to another: a normal. */
export interface Arrow {
  readonly key: string;
  readonly symbols: readonly string[];
  readonly from: Pick<ScreenPoint, 'x' | 'y'>;
  readonly to: Pick<ScreenPoint, 'x' | 'y'>;
}

const HEAD = 12;
const HALF_HEAD = 4.6;
/** Length in px below which an arrow is drawn as a dot. */
const DOT = 3;

export function drawArrows(
  layer: Layer,
  arrows: readonly Arrow[],
  scale: number,
  lit: string | null,
): void {
  layer.begin();
  for (const { key, symbols, from, to } of arrows) {
    const isLit = lit !== null && symbols.includes(lit);
    const size = scale * (isLit ? 1.3 : 1);
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    const head = Math.min(HEAD * size, length);
    const half = (HALF_HEAD * head) / HEAD;
    const angle = (Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI;
    const [l, n] = [coordinate(length), coordinate(length - head)];
    const d =
      length < DOT ? 'M0 0h.01' : `M0 0H${n}M${l} 0L${n} ${coordinate(half)}V${coordinate(-half)}Z`;
    layer.show(key, 'path', {
      class: `scene-normal${isLit ? ' lit' : ''}`,
      'data-symbol': symbols[0] ?? key,
      d,
      'stroke-width': 2.6 * size,
      transform:
        `translate(${coordinate(from.x)} ${coordinate(from.y)}) ` + `rotate(${angle.toFixed(2)})`,
    });
  }
  layer.end();
}
