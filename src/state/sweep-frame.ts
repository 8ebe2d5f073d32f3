import type { Stage } from '../math/drawing.ts';
import { intersect, type Vec3 } from '../math/index.ts';
import { spanInFigure } from '../math/shapes.ts';
import { graphOf } from './graph.ts';
import type { GraphModel } from './graph-model.ts';
import type { FigureLine } from './scene-model.ts';
import { distance, isDrawn, stageOf, stageOver } from './stage.ts';
import { type AppState, rayOf, shapeOf } from './state.ts';
import { stretchesOf } from './stretches.ts';
import { type Sample, type Sweep, withNumber } from './sweep.ts';

/* The drawing of a number that plays: a trail of the roots, in a fixed stage and window. */

/** The stage and the window of the graph, which stay the same while a number plays. */
export interface SweepFrame {
  readonly stage: Stage;
  readonly window: Pick<GraphModel, 'from' | 'to' | 'low' | 'high'>;
}

/** Largest growth of stage and window, so that they contain the whole sweep. */
const ROOM = 2;
const EVERY = 8;

/** The frame that contains the whole sweep, as far as ROOM allows. */
export function sweepFrame(state: AppState, { label, samples }: Sweep): SweepFrame {
  // Every eighth sample is enough, since neighbours differ little.
  const all = samples
    .filter((_, i) => i % EVERY === 0 || i === samples.length - 1)
    .flatMap(({ value }) => {
      const there = withNumber(state, label, value);
      if (!there) return [];
      const [shape, ray] = [shapeOf(there), rayOf(there)];
      const found = intersect(shape, ray);
      return [{ stage: stageOf(shape, ray, found), graph: graphOf(found, shape, ray, null) }];
    });
  const [shape, ray] = [shapeOf(state), rayOf(state)];
  const found = intersect(shape, ray);
  const own = stageOf(shape, ray, found);
  const near = all
    .map(({ stage }) => stage)
    .filter(
      ({ radius, center }) => radius <= ROOM * own.radius && distance(center, own.center) === 0,
    );
  const graph = graphOf(found, shape, ray, null);
  const [span, rise] = [graph.to - graph.from, graph.high - graph.low];
  const most = (values: number[], limit: number): number =>
    Math.max(...values.map((value) => Math.min(value, limit)));
  const of = (pick: (one: GraphModel) => number) =>
    [graph, ...all.map((one) => one.graph)].map(pick);
  const spread = (ROOM - 1) / 2;
  return {
    stage: stageOver(own, near),
    window: {
      from: -most(
        of(({ from }) => -from),
        spread * span - graph.from,
      ),
      to: most(
        of(({ to }) => to),
        spread * span + graph.to,
      ),
      low: -most(
        of(({ low }) => -low),
        spread * rise - graph.low,
      ),
      high: most(
        of(({ high }) => high),
        spread * rise + graph.high,
      ),
    },
  };
}

/** Interpolates two frames; `share` 0 gives the first. */
export function frameBetween(a: SweepFrame, b: SweepFrame, share: number): SweepFrame {
  if (share >= 1) return b;
  const mix = <T extends object>(x: T, y: T): T =>
    Object.fromEntries(
      Object.entries(y).map(([key, value]) => {
        const before = x[key as keyof T];
        const isNumber = typeof value === 'number' && typeof before === 'number';
        return [key, isNumber ? before + share * (value - before) : value];
      }),
    ) as T;
  return { stage: mix(a.stage, b.stage), window: mix(a.window, b.window) };
}

/** The graph in another window, with the trail of its roots, and f where the class changes. */
export function graphIn(
  graph: GraphModel,
  { window }: Pick<SweepFrame, 'window'>,
  state: AppState,
  trail: GraphModel['trail'],
): GraphModel {
  const [shape, ray] = [shapeOf(state), rayOf(state)];
  const found = intersect(shape, ray, state.method);
  const span = found.class === 'contained' ? spanInFigure(shape, ray) : null;
  const stretches = stretchesOf(found, window, span);
  return { ...graph, ...window, stretches, ...(trail ? { trail } : {}) };
}

/** The samples that have been played. */
const seenOf = ({ samples }: Sweep, [from, to]: readonly [number, number]): readonly Sample[] =>
  samples.filter(({ value }) => value >= from && value <= to);

/** The trail of the graph: past roots, and f where the class changes. */
export function graphTrail(
  sweep: Sweep,
  seen: readonly [number, number],
  present: number,
): NonNullable<GraphModel['trail']> {
  const all = seenOf(sweep, seen);
  const turns = new Set(sweep.boundaries.map(({ value }) => value));
  return {
    roots: all.flatMap(({ value, hits }) =>
      hits.map(({ t }) => ({ t, above: (value - present) / (sweep.high - sweep.low) })),
    ),
    curves: all.filter(({ value }) => turns.has(value)).map(({ f: [A, B, C] }) => ({ A, B, C })),
  };
}

/** The paths of P1 and P2 within the drawn part of the world. */
export function sceneTrail(
  sweep: Sweep,
  seen: readonly [number, number],
  stage: Stage,
): readonly FigureLine[] {
  const drawn = branchesOf(seenOf(sweep, seen)).flatMap((branch) => piecesIn(branch, stage));
  return drawn.map((points) => ({ points, closed: false, ink: 'hit' }));
}

/** Unbroken paths, each of one hit. */
function branchesOf(samples: readonly Sample[]): Vec3[][] {
  const done: Vec3[][] = [];
  let open: Vec3[][] = [];
  let before: Sample | null = null;
  for (const sample of samples) {
    const points = sample.hits.map(({ point }) => point);
    if (before?.key === sample.key && before.verdict === sample.verdict) {
      points.forEach((point, i) => {
        open[i]?.push(point);
      });
    } else {
      // Both come together where D is 0; where A is 0 one of them is infinitely far off.
      for (const branch of joining(open, sample)) branch.push(nearestTo(branch.at(-1), points));
      const next = points.map((point) => [point]);
      const last = before?.hits.map(({ point }) => point) ?? [];
      if (before) {
        for (const branch of joining(next, before)) branch.unshift(nearestTo(branch[0], last));
      }
      done.push(...next);
      open = next;
    }
    before = sample;
  }
  return done;
}

/** The branches that end, or begin, in a point of this sample. */
function joining(branches: readonly Vec3[][], { zero, hits }: Sample): readonly Vec3[][] {
  const [only, ...more] = hits;
  if (zero === null || !only || more.length > 0) return [];
  if (zero === 'D = 0') return branches;
  const away = (branch: readonly Vec3[]): number =>
    Math.min(...branch.map((point) => distance(point, only.point)));
  return [...branches].sort((a, b) => away(a) - away(b)).slice(0, 1);
}

const nearestTo = (from: Vec3 | undefined, points: readonly Vec3[]): Vec3 =>
  [...points].sort((a, b) => distance(a, from ?? a) - distance(b, from ?? b))[0] ??
  from ?? [0, 0, 0];

function piecesIn(branch: readonly Vec3[], stage: Stage): Vec3[][] {
  const pieces: Vec3[][] = [[]];
  for (const point of branch) {
    const isSeen = point.every(Number.isFinite) && isDrawn(point, stage);
    if (isSeen) pieces.at(-1)?.push(point);
    else pieces.push([]);
  }
  return pieces.filter(({ length }) => length > 1);
}
