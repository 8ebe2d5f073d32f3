import { roundStep } from '../math/drawing.ts';
import type { Ray, Shape } from '../math/index.ts';
import { unitVector } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import { pointAt } from './graph.ts';
import type { GraphModel } from './graph-model.ts';
import type { ReachHandle } from './handles.ts';
import { clipToStage, ticksOf } from './scene.ts';
import type { SceneModel } from './scene-model.ts';
import { isDrawn, stageAround } from './stage.ts';
import type { AppState } from './state.ts';
import type { PlacedStretch } from './stretches.ts';

/** t of the mark before a person has moved it: the tip of d. */
const START = 1;

/** Where the mark is that says where the first hit is expected; null where that is not asked. */
export const markOf = ({ ask, bead }: Pick<AppState, 'ask' | 'bead'>): number | null =>
  ask === 'where' ? (bead ?? START) : null;

interface Interval {
  readonly from: number;
  readonly to: number;
}

/** The interval of t that is drawn of a line outside of the stage. */
const ELSEWHERE: Interval = { from: -1, to: 4 };

/**
 * The stretch of t that is drawn while the results are hidden: the line within the part of the
 * world that E and the shape take, wherever it meets the shape.
 */
export const hiddenReach = (shape: Shape, ray: Ray): Interval =>
  clipToStage(ray, stageAround(shape, [ray.origin]), { from: -Infinity, to: Infinity }) ??
  ELSEWHERE;

const stretchesOf = ({ from, to }: Interval): readonly PlacedStretch[] =>
  [
    { from, to: Math.min(to, 0), stretch: 'behind', place: 'behind' } as const,
    { from: Math.max(from, 0), to, stretch: 'before', place: null } as const,
  ].filter((part) => part.from < part.to);

/** The scene with ray and shape, and nothing that shows where they meet. */
export function withoutResults(scene: SceneModel, state: AppState): SceneModel {
  const { ray, stage } = scene;
  const reach = clipToStage(ray, stage, { from: -Infinity, to: Infinity });
  // At rest the bead lies between the roots; a bead that was put somewhere is the prediction.
  const t = markOf(state);
  const point = t === null ? null : pointAt(ray, t);
  const handles = scene.handles.map((handle) => ({ ...handle, tangency: null }));
  return {
    ...scene,
    ray: {
      ...ray,
      segments: reach ? stretchesOf(reach) : [],
      ticks: reach ? ticksOf(reach) : [],
    },
    hits: [],
    // The ghost may be the same ray, with its hits.
    ghost: null,
    handles: t !== null && reach ? [...handles, markHandle(ray, t, reach)] : handles,
    bead:
      t !== null && point?.every(Number.isFinite)
        ? { t, point, drawn: isDrawn(point, stage) }
        : null,
    mark: t === null ? null : { title: 'your mark', isOpen: true, gap: null },
    notes: scene.ray.originDrawn ? [] : scene.notes.slice(0, 1),
    description: `${scene.description.split(':')[0]}. The result is hidden: predict it first.`,
  };
}

/** Number of arrow key presses from one end of the ray to the other, about. */
const KEYS = 100;
export const markStep = ({ from, to }: Interval): number => roundStep((to - from) / KEYS);

/** The handle that moves the mark along the ray. */
function markHandle({ origin, direction }: Ray, t: number, reach: Interval): ReachHandle {
  const length = Math.hypot(...direction);
  const start = Math.min(reach.from, t);
  return {
    type: 'reach',
    symbol: 't',
    label: 't, your mark on the ray',
    text: display(t),
    step: markStep(reach),
    isLength: false,
    grip: {
      type: 'reach',
      param: 't',
      from: pointAt({ origin, direction }, start),
      direction: { along: unitVector(direction) },
      reach: (t - start) * length,
      isLength: false,
      value: (far) => start + far / length,
    },
    value: t,
    refusal: () => null,
    action: (value) => ({
      type: 'bead',
      t: typeof value === 'function' ? (now) => value(now ?? START) as number : (value as number),
    }),
    tangency: null,
  };
}

/** The interval with its ends rounded inwards to multiples of the mark's step. */
function shortened(reach: Interval): Interval {
  const step = markStep(reach);
  const at = (steps: number): number => Number((steps * step).toPrecision(12)) + 0;
  return { from: at(Math.ceil(reach.from / step)), to: at(Math.floor(reach.to / step)) };
}

/** The graph's t axis without f, on which the mark can be moved too. */
export function withoutRoots(
  graph: GraphModel,
  { shape, ray, state }: { readonly shape: Shape; readonly ray: Ray; readonly state: AppState },
): GraphModel {
  const t = markOf(state);
  const at = t ?? START;
  const reach = shortened(hiddenReach(shape, ray));
  return {
    ...graph,
    ...{ A: Number.NaN, B: Number.NaN, C: Number.NaN, ...reach, low: -1, high: 1, roots: [] },
    caps: [],
    stretches: stretchesOf(reach),
    bead: { t: at, f: Number.NaN, point: pointAt(ray, at) },
    ...{ ghost: null, contained: false, concealed: true, note: null },
    mark: t === null ? null : { title: 'your mark', isOpen: true, gap: null },
    description: 'The graph of f is hidden: it tells where f is zero.',
  };
}
