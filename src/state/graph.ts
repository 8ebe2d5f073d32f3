import type { Intersection, Ray, Shape } from '../math/index.ts';
import { alongRay, spanInFigure } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import type { Ended } from './ended.ts';
import { CAP_NAMES } from './ends.ts';
import type { GraphModel } from './graph-model.ts';
import { graphWindowOf, restingBead } from './graph-window.ts';
import { hitsLeft, stretchesOf } from './stretches.ts';
import { type HitWords, hitSentences, hitWords } from './verdict-words.ts';

/** The graph of f over the window, with the stretches of the ray and the bead. */
export function graphOf(
  found: Intersection,
  shape: Shape,
  ray: Ray,
  bead: number | null,
  ghost: Intersection | null = null,
  ended: Ended | null = null,
): GraphModel {
  const span = found.class === 'contained' ? spanInFigure(shape, ray) : null;
  const caps = (ended?.capHits ?? []).map(({ hit: { t } }) => t);
  const window = graphWindowOf(found, span ? [span.from, span.to] : caps);
  const { A, B, C } = quadratic(found);
  const f = (t: number): number => (A * t + B) * t + C;
  const roots = hitWords(found, ended);
  const t = bead ?? restingBead(hitsLeft(found, ended), window);
  return {
    A,
    B,
    C,
    ...window,
    ...heights(f, window, A, B),
    roots: roots.map(({ index, t, role }) => ({
      index,
      t,
      role,
      double: found.class === 'tangent',
    })),
    caps: (ended?.capHits ?? []).map(({ end, hit, role }) => ({
      end,
      t: hit.t,
      // On the axis if f overflows.
      f: f(hit.t) || 0,
      role,
    })),
    stretches: stretchesOf(found, window, span, ended),
    bead: { t, ...alongRay(shape, ray, t) },
    ghost: ghost && { ...quadratic(ghost), roots: ghost.hits.map((hit) => hit.t) },
    contained: found.class === 'contained',
    concealed: false,
    description: [describe(found, roots), ...capWords(ended)].join(' '),
  };
}

function quadratic({ details }: Intersection): { A: number; B: number; C: number } {
  if (details.family === 'curved') return { A: details.A, B: details.B, C: details.C };
  return { A: 0, B: details.rate, C: details.offset };
}

export function pointAt({ origin, direction }: Ray, t: number): readonly [number, number, number] {
  const at = (i: 0 | 1 | 2): number => origin[i] + t * direction[i];
  return [at(0), at(1), at(2)];
}

/**
 * The interval of f(t) to show: its values at E, at the vertex and at the roots, with a margin so
 * that the t axis is never at the edge.
 */
function heights(
  f: (t: number) => number,
  { from, to }: { from: number; to: number },
  A: number,
  B: number,
): { low: number; high: number } {
  const turn = -B / (2 * A);
  const shown = [0, turn].filter((t) => t >= from && t <= to).map(f);
  const ends = A === 0 || from > 0 || to < 0 ? [f(from), f(to)] : [];
  const values = [0, ...shown, ...ends].filter(Number.isFinite);
  const most = Math.max(...values);
  const least = Math.min(...values);
  if (most === 0 && least === 0) return { low: -1, high: 1 };
  const high = Math.max(1.24 * most, -0.3 * least);
  return { low: Math.min(1.24 * least, -0.3 * high), high };
}

const capWords = (ended: Ended | null): string[] =>
  (ended?.capHits ?? []).map(
    ({ end, hit, text }) => `The ${CAP_NAMES[end]} at t = ${display(hit.t)}, ${text}.`,
  );

function describe(found: Intersection, roots: readonly HitWords[]): string {
  const { A, B, C } = quadratic(found);
  // A as a double may be 0 where A is not.
  const bend = found.details.family === 'curved' ? (found.details.signs.A ?? A) : 0;
  const kind =
    bend === 0
      ? 'a straight line'
      : bend > 0
        ? 'a parabola open upwards'
        : 'a parabola open downwards';
  const at = `f(0) = ${display(C)}`;
  if (found.class === 'contained') return 'f(t) is zero for every t.';
  if ([A, B, C].some(Number.isNaN)) return 'f(t) is not known: a number overflowed.';
  if (A === 0 && B === 0) return `f(t) is constant: ${at}.`;
  const where = roots.length === 0 ? 'it has no root' : hitSentences(roots).join('; ');
  return `f(t) is ${kind}, ${at}; ${where}.`;
}
