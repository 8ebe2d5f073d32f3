import type { Vec3 } from '../vec3.ts';
import type { Figure, Patch, PatchEnd, Stage } from './drawing.ts';
import { multiplesWithin, roundStep } from './steps.ts';

/**
 * (x−Cx)² + (z−Cz)² = a(y−Cy)² + r², in doubles, for the picture only. r is never squared: the
 * square of a very long or very short length is not a double.
 */
interface Revolution {
  readonly center: Vec3;
  readonly a: number;
  readonly r: number;
}

/**
 * The drawn part of a surface of revolution: between the stage's heights, and not wider than the
 * stage.
 */
export function drawRevolution(surface: Revolution, symbol: string, stage: Stage): Figure {
  const pieces = profile(surface, stage).map((piece) => patchOf(surface, piece, stage));
  return aboutAxis(pieces, surface.center, symbol, stage);
}

/** The patches with the axis and the marked point of a surface of revolution. */
export function aboutAxis(
  patches: readonly Patch[],
  center: Vec3,
  symbol: string,
  stage: Stage,
): Figure {
  return {
    patches,
    lines: [
      { from: [center[0], stage.low, center[2]], to: [center[0], overshoot(stage), center[2]] },
    ],
    marks: [{ symbol, at: axisPoint(center, stage) }],
    normals: [],
  };
}

/** Where the drawn axis ends: above the stage by 4 % of its height. */
const overshoot = ({ low, high }: Stage): number => high + (high - low) * 0.04;

/**
 * A cylinder's centre has no height of its own that matters: its mark is kept where it can be seen.
 */
export function axisPoint(center: Vec3, { low, high }: Stage): Vec3 {
  return [center[0], Math.min(Math.max(center[1], low), high), center[2]];
}

/** Heights between which a surface is drawn, and how it ends there. */
export interface Piece {
  readonly from: number;
  readonly to: number;
  readonly start: PatchEnd;
  readonly end: PatchEnd;
}

/**
 * The heights at which the surface has a positive radius, cut to the stage; radius² is a parabola
 * in the height.
 */
function profile({ center, a, r }: Revolution, stage: Stage): Piece[] {
  const { low, high } = stage;
  const y = center[1];
  const widest = stage.radius * 1.15;
  if (a === 0) return r > 0 ? [{ from: low, to: high, start: 'rim', end: 'goes-on' }] : [];
  if (a < 0) return r > 0 ? ellipsoid(y, r / Math.sqrt(-a), stage) : [];
  const reach = leg(widest, r) / Math.sqrt(a);
  const from = Math.max(low, y - reach);
  const to = Math.min(high, y + reach);
  if (r > 0) return from < to ? [{ from, to, start: 'rim', end: 'goes-on' }] : [];
  return nappes(y, from, to);
}

/** √(c² − b²), the other leg of a right triangle; 0 for b > c. */
function leg(c: number, b: number): number {
  return c > b ? Math.sqrt(c - b) * Math.sqrt(c + b) : 0;
}

/**
 * Whole where it is no larger than the stage: cut at the ground it would seem to have a hole. From
 * there to twice that size the cuts come in gradually, as `a` goes to 0 and it becomes a cylinder.
 */
function ellipsoid(y: number, half: number, { center, radius, low, high }: Stage): Piece[] {
  const away = Math.abs(y - center[1]) + half;
  const whole = Math.min(Math.max(2 - away / radius, 0), 1);
  const cut = (height: number, pole: number): number => height + whole * (pole - height);
  const from = Math.max(Math.min(low, cut(low, y - half)), y - half);
  const to = Math.min(Math.max(high, cut(high, y + half)), y + half);
  if (!(from < to)) return [];
  return [
    {
      from,
      to,
      start: from > y - half ? 'rim' : 'point',
      end: to < y + half ? 'goes-on' : 'point',
    },
  ];
}

function nappes(y: number, from: number, to: number): Piece[] {
  const lower: Piece = {
    from,
    to: Math.min(y, to),
    start: 'rim',
    end: to < y ? 'goes-on' : 'point',
  };
  const upper: Piece = {
    from: Math.max(y, from),
    to,
    start: from > y ? 'rim' : 'point',
    end: 'goes-on',
  };
  return [lower, upper].filter((piece) => piece.from < piece.to);
}

function patchOf({ center, a, r: waist }: Revolution, piece: Piece, stage: Stage): Patch {
  const cy = center[1];
  const root = Math.sqrt(Math.abs(a));
  const radius = (y: number): number => {
    const h = root * Math.abs(y - cy);
    return a < 0 ? leg(waist, h) : Math.hypot(h, waist);
  };
  const patch = revolvedPatch(center, radius, (y) => -a * (y - cy), piece, heights(piece), stage);
  const { at } = heights(piece);
  return {
    ...patch,
    normal(u, v) {
      // At a cone's vertex the gradient is zero, but each generator still has a side to show.
      if (waist !== 0 || radius(at(v)) !== 0) return patch.normal(u, v);
      const angle = 2 * Math.PI * u;
      const sign = piece.end === 'point' ? 1 : -1;
      return [Math.sin(angle), sign * root, Math.cos(angle)];
    },
    stepsV: waist === 0 || a === 0 ? 1 : 32,
  };
}

/** A surface about a vertical axis: its radius and the y of its normal, by height. */
export function revolvedPatch(
  [cx, , cz]: Vec3,
  radius: (y: number) => number,
  normalY: (y: number) => number,
  piece: Piece,
  height: Heights,
  stage: Stage,
): Patch {
  const rings = multiplesWithin(piece.from, piece.to, roundStep(stage.radius / 5));
  return {
    at(u, v) {
      const y = height.at(v);
      const angle = 2 * Math.PI * u;
      const r = radius(y);
      return [cx + r * Math.sin(angle), y, cz + r * Math.cos(angle)];
    },
    normal(u, v) {
      const y = height.at(v);
      const angle = 2 * Math.PI * u;
      const r = radius(y);
      return [r * Math.sin(angle), normalY(y), r * Math.cos(angle)];
    },
    closed: true,
    rings: rings.map(height.inverse),
    start: piece.start,
    end: piece.end,
    sides: 'joins',
    stepsV: 32,
  };
}

/** v in [0, 1] to a height and back. */
export interface Heights {
  at(v: number): number;
  inverse(y: number): number;
}

/**
 * v to height and back. Towards a rounded end the heights close up, so that the end is round in the
 * picture too.
 */
function heights({ from, to, start, end }: Piece): Heights {
  const middle = (from + to) / 2;
  const half = (to - from) / 2;
  if (start !== 'point' || end !== 'point') {
    return { at: (v) => from + (to - from) * v, inverse: (y) => (y - from) / (to - from) };
  }
  return {
    at: (v) => middle - half * Math.cos(Math.PI * v),
    inverse: (y) => Math.acos((middle - y) / half) / Math.PI,
  };
}
