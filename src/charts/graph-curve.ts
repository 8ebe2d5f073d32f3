import type { GraphModel } from '../state/graph-model.ts';
import { coordinate } from '../text/coordinate.ts';
import type { Frame } from './graph-frame.ts';

/**
 * v(u) = a u² + b u + c: the graph in units of the plot, u from left (0) to right (1), v from
 * bottom (0) to top (1).
 */
export interface Parabola {
  readonly a: number;
  readonly b: number;
  readonly c: number;
  /** v of f = 0. */
  readonly zero: number;
}

interface Piece {
  readonly from: number;
  readonly to: number;
  readonly where: 'drawn' | 'above' | 'below';
}

/** Range of v that is drawn, so that coordinates stay small; a clip path cuts at 0 and 1. */
const [LOWEST, HIGHEST] = [-1, 2];
/** Bisection steps until u is exact to the last bit. */
const HALVINGS = 54;

/** The graph in units of the plot; null if its numbers overflow. */
export function parabolaOf(model: GraphModel): Parabola | null {
  const { A, B, C, from, low, roots } = model;
  const s = model.to - from;
  const h = model.high - low;
  const zero = -low / h;
  const a = A * s * (s / h);
  const [u1, u2] = [roots[0], roots[1] ?? doubled(roots[0])].map((r) => r && (r.t - from) / s);
  const made =
    A !== 0 && u1 !== undefined && u2 !== undefined
      ? // By its roots: far from 0 the coefficients cancel, and the curve would miss its own marks.
        { a, b: -a * (u1 + u2), c: a * u1 * u2 + zero, zero }
      : { a, b: (2 * A * from + B) * (s / h), c: ((A * from + B) * from + C) / h + zero, zero };
  return Object.values(made).every(Number.isFinite) ? made : null;
}

function doubled(root: GraphModel['roots'][number] | undefined) {
  return root?.double ? root : undefined;
}

export function heightAt({ a, b, c }: Parabola, u: number): number {
  return (a * u + b) * u + c;
}

/** The graph as SVG path data: exact, since a quadratic Bézier curve is a parabola. */
export function curvePath(parabola: Parabola, frame: Frame): string {
  return pieces(parabola)
    .filter((piece) => piece.where === 'drawn')
    .map((piece) => `M${start(parabola, piece, frame)}${arc(parabola, piece, frame)}`)
    .join('');
}

/** The area between the graph and f = 0; a clip path shows only the part where f < 0. */
export function areaPath(parabola: Parabola, frame: Frame): string {
  const zero = place(frame, 0, Math.min(Math.max(parabola.zero, LOWEST), HIGHEST)).y;
  return pieces(parabola)
    .filter((piece) => piece.where !== 'above')
    .map((piece) => {
      const edge =
        piece.where === 'drawn'
          ? start(parabola, piece, frame) + arc(parabola, piece, frame)
          : `${point(frame, piece.from, LOWEST)}L${point(frame, piece.to, LOWEST)}`;
      const [x, y] = [coordinate(place(frame, piece.from, 0).x), coordinate(zero)];
      return `M${x},${y}L${edge}V${y}Z`;
    })
    .join('');
}

function start(parabola: Parabola, { from }: Piece, frame: Frame): string {
  return point(frame, from, heightAt(parabola, from));
}

/** Path of a piece; its control point is the intersection of the end tangents, midway in u. */
function arc(parabola: Parabola, { from, to }: Piece, frame: Frame): string {
  const end = point(frame, to, heightAt(parabola, to));
  if (parabola.a === 0) return `L${end}`;
  const slope = 2 * parabola.a * from + parabola.b;
  const control = heightAt(parabola, from) + (slope * (to - from)) / 2;
  return `Q${point(frame, (from + to) / 2, control)} ${end}`;
}

function pieces(parabola: Parabola): Piece[] {
  const turn = parabola.a === 0 ? 0 : -parabola.b / (2 * parabola.a);
  const ends = turn > 0 && turn < 1 ? [0, turn, 1] : [0, 1];
  const cuts = ends.flatMap((to, i) =>
    i === 0 ? [to] : [...crossings(parabola, ends[i - 1] ?? 0, to), to],
  );
  const all = cuts.slice(1).map((to, i) => piece(parabola, cuts[i] ?? 0, to));
  const [first, second] = all;
  // One curve instead of two halves that meet at the vertex.
  const isWhole = all.length === 2 && first?.where === 'drawn' && second?.where === 'drawn';
  return isWhole ? [{ from: 0, to: 1, where: 'drawn' }] : all;
}

function piece(parabola: Parabola, from: number, to: number): Piece {
  const middle = heightAt(parabola, (from + to) / 2);
  return { from, to, where: middle > HIGHEST ? 'above' : middle < LOWEST ? 'below' : 'drawn' };
}

/** The u at which a monotone piece crosses `LOWEST` and `HIGHEST`, by bisection. */
function crossings(parabola: Parabola, from: number, to: number): number[] {
  const found = [LOWEST, HIGHEST].flatMap((level) => {
    const side = (u: number) => heightAt(parabola, u) > level;
    if (side(from) === side(to)) return [];
    let [low, high] = [from, to];
    for (let i = 0; i < HALVINGS; i++) {
      const middle = (low + high) / 2;
      if (side(middle) === side(from)) low = middle;
      else high = middle;
    }
    return [low];
  });
  return found.sort((p, q) => p - q);
}

function place({ left, right, top, floor }: Frame, u: number, v: number) {
  return { x: left + u * (right - left), y: floor + v * (top - floor) };
}

function point(frame: Frame, u: number, v: number): string {
  const { x, y } = place(frame, u, v);
  return `${coordinate(x)},${coordinate(y)}`;
}
