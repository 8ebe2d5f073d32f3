import { type Drawing, multiplesWithin, roundStep, type Stage } from '../math/drawing.ts';
import type { Intersection, Ray, Vec3 } from '../math/index.ts';
import { withArticle } from '../text/article.ts';
import { display, displayTriple } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import type { View } from './camera-view.ts';
import type { Ended } from './ended.ts';
import { CAP_NAMES } from './ends.ts';
import { pointAt } from './graph.ts';
import type { GraphModel } from './graph-model.ts';
import { rootsOf, windowOf } from './graph-window.ts';
import type { Handle } from './handles.ts';
import type { GhostModel, HitMark, RaySegment, SceneModel } from './scene-model.ts';
import { distance, isDrawn } from './stage.ts';
import { hitSentences, hitWords } from './verdict-words.ts';

interface Parts {
  /** What the shape is, and the case in words. */
  readonly title: string;
  readonly verdict: string;
  readonly ray: Ray;
  readonly found: Intersection;
  readonly ended: Ended | null;
  readonly stage: Stage;
  readonly drawing: Drawing;
  readonly graph: GraphModel;
  readonly view: View;
  readonly handles: readonly Handle[];
  readonly ghost: { readonly ray: Ray; readonly found: Intersection } | null;
}

export function sceneOf(parts: Parts): SceneModel {
  const { title, verdict, ray, found, ended, stage, drawing, graph, view, handles, ghost } = parts;
  const all = [...hitMarks(found, ended, stage), ...capMarks(ended, stage)];
  // In a float method t may be finite and the point overflow.
  const hits = all.filter(({ point }) => !point.some(Number.isNaN));
  const reach = clipToStage(ray, stage, drawnOver(found, graph));
  const originDrawn = isDrawn(ray.origin, stage);
  const point: Vec3 = graph.bead.point;
  return {
    shapeTitle: title,
    stage,
    drawing,
    ray: {
      origin: ray.origin,
      direction: ray.direction,
      segments: reach ? segmentsOf(graph, reach) : [],
      ticks: reach ? ticksOf(reach) : [],
      originDrawn,
    },
    hits,
    ghost: ghost && ghostOf(ghost.ray, ghost.found, stage),
    bead: point.every(Number.isFinite)
      ? { t: graph.bead.t, point, drawn: isDrawn(point, stage) }
      : null,
    handles,
    view,
    notes: notesOf(ray, all, originDrawn),
    description: describe(title, verdict, ray, found, ended),
  };
}

/**
 * The marks of the hits. A point that a float method knows to be outside the figure, but whose
 * coordinates overflow, has none.
 */
function hitMarks(found: Intersection, ended: Ended | null, stage: Stage): HitMark[] {
  const { details, hits } = found;
  return hitWords(found, ended)
    .map(({ index, role, t }, i) => {
      const hit = role === 'outside' && details.family === 'flat' ? details.plane : hits[i];
      const point = hit?.point ?? [0, 0, 0];
      const drawn = point.every(Number.isFinite) && isDrawn(point, stage);
      const isHit = role !== 'outside' && role !== 'cut';
      const normal = hit && !hit.singular && isHit ? hit.normal : null;
      const words = role === 'cut' ? { words: `t${subscript(index)} cut off` } : {};
      return { index, role, t, point, normal, drawn, ...words };
    })
    .filter(({ point }) => !point.some(Number.isNaN));
}

/** Subscripts of what lights up with a cap's line. */
const CAP_INDEX = { low: 3, high: 4 } as const;

const capMarks = (ended: Ended | null, stage: Stage): HitMark[] =>
  (ended?.capHits ?? []).map(({ end, hit: { t, point, normal }, role }) => ({
    index: CAP_INDEX[end],
    words: CAP_NAMES[end],
    ...{ role, t, point, normal, drawn: point.every(Number.isFinite) && isDrawn(point, stage) },
  }));

/**
 * The interval of t, within the window and a margin, where the ray is inside the stage, or null.
 */
export function clipToStage(
  { origin, direction }: Ray,
  { center, radius }: Stage,
  window: { readonly from: number; readonly to: number },
): { from: number; to: number } | null {
  const length = Math.hypot(...direction);
  if (!(length > 0) || !Number.isFinite(length)) return null;
  const unit = direction.map((x) => x / length);
  const along = unit.reduce((sum, u, i) => sum + u * ((center[i] ?? 0) - (origin[i] ?? 0)), 0);
  const nearest = pointAt({ origin, direction: unit as unknown as Vec3 }, along);
  const off = distance(nearest, center);
  const ball = 1.5 * radius;
  if (!(off < ball)) return null;
  const half = Math.sqrt((ball - off) * (ball + off));
  const from = Math.max((along - half) / length, window.from);
  const to = Math.min((along + half) / length, window.to);
  return Number.isFinite(from) && Number.isFinite(to) && from < to ? { from, to } : null;
}

/**
 * The interval of t that the scene draws: the graph's, extended to the tip of d and every root.
 * Without a root it is the whole line, so that one sees how it passes the shape.
 */
function drawnOver(found: Intersection, graph: GraphModel): { from: number; to: number } {
  if (rootsOf(found).length === 0) return { from: -Infinity, to: Infinity };
  const whole = windowOf(found);
  return { from: Math.min(whole.from, graph.from), to: Math.max(whole.to, graph.to) };
}

function ghostOf(ray: Ray, found: Intersection, stage: Stage): GhostModel | null {
  const reach = clipToStage(ray, stage, windowOf(found));
  if (!reach) return null;
  const hits = found.hits.map(({ point }) => point).filter((p) => isDrawn(p, stage));
  return {
    title: 'before',
    origin: ray.origin,
    direction: ray.direction,
    ...reach,
    hits,
    beside: null,
  };
}

/** The graph's stretches, with the first and the last extended as far as the line is drawn. */
function segmentsOf({ stretches }: GraphModel, reach: { from: number; to: number }): RaySegment[] {
  return stretches
    .map(({ from, to, stretch }, i) => ({
      from: i === 0 ? reach.from : Math.max(from, reach.from),
      to: i === stretches.length - 1 ? reach.to : Math.min(to, reach.to),
      stretch,
    }))
    .filter(({ from, to }) => from < to);
}

export function ticksOf({ from, to }: { from: number; to: number }): number[] {
  const step = roundStep((to - from) / 5);
  return multiplesWithin(from, to, step).filter((t) => t !== 0);
}

function notesOf(ray: Ray, hits: readonly HitMark[], originDrawn: boolean): string[] {
  const outside = hits
    .filter(({ drawn }) => !drawn)
    .map(({ index, role, words, point }) => {
      const name = words && role !== 'cut' ? `The hit on the ${words}` : `P${subscript(index)}`;
      if (point.some(Number.isNaN)) return `${name} overflowed on the way: its place is not known`;
      return point.every(Number.isFinite)
        ? `${name} ${displayTriple(point, 3)} lies outside the drawn part`
        : `${name} lies beyond the doubles`;
    });
  const E = `E ${displayTriple(ray.origin, 3)} lies outside the drawn part`;
  return originDrawn ? outside : [E, ...outside];
}

function describe(
  title: string,
  verdict: string,
  { origin, direction }: Ray,
  found: Intersection,
  ended: Ended | null,
): string {
  const roots = hitSentences(hitWords(found, ended)).map((sentence, i) => {
    const hit = found.hits[i];
    return `${sentence}${hit ? `, at ${displayTriple(hit.point, 3)}` : ''}.`;
  });
  const caps = (ended?.capHits ?? []).map(
    ({ end, hit: { t, point }, text }) =>
      `On the ${CAP_NAMES[end]} at t = ${display(t)}, ${text}, at ${displayTriple(point, 3)}.`,
  );
  const hits = [...roots, ...caps];
  const from = `A ray from E ${displayTriple(origin)} in direction d ${displayTriple(direction)}`;
  return [`${from} and ${withArticle(title)}: ${verdict}.`, ...hits].join(' ');
}
