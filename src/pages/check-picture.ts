import type { Answers, Input } from '../check/types.ts';
import { float64 } from '../math/arithmetic/float64.ts';
import { POINT } from '../math/formula/common.ts';
import { evaluateTriple, withScalars } from '../math/formula/evaluate.ts';
import { valuesOf } from '../math/methods/tree-method.ts';
import type { Vec3 } from '../math/vec3.ts';
import { createDerive } from '../state/derive.ts';
import type { GhostModel, SceneModel } from '../state/scene-model.ts';
import { isDrawn } from '../state/stage.ts';
import { type AppState, INITIAL } from '../state/state.ts';
import { encode } from '../state/url.ts';
import type { View } from '../state/view.ts';

/** The state of Explore that shows this input. */
export function stateOf({ shape, ray }: Input): AppState {
  return {
    ...INITIAL,
    kind: shape.kind,
    shapes: { ...INITIAL.shapes, [shape.kind]: shape },
    E: ray.origin,
    d: ray.direction,
  };
}

/** Null where Explore could not show it: it is no valid input. */
export function exploreLink(input: Input): string | null {
  const numbers = [
    ...input.ray.origin,
    ...input.ray.direction,
    ...Object.values(input.shape).flat(),
  ];
  const finite = numbers.every((x) => typeof x !== 'number' || Number.isFinite(x));
  return finite ? encode(stateOf(input)) : null;
}

export interface Wanted {
  readonly input: Input;
  /** Hits, normals and bead; false while a prediction is open. */
  readonly results: boolean;
  /** A student's own values, drawn beside the truth as a ghost. */
  readonly answers: Answers | null;
  readonly view: View;
}

/** A derive with a memory of its own for one picture. */
export function createPicture(): (wanted: Wanted) => SceneModel {
  const derive = createDerive();
  let last: Input | null = null;
  let state = INITIAL;
  return ({ input, results, answers, view }) => {
    if (input !== last) state = stateOf(input);
    last = input;
    const { scene } = derive({ ...state, view, revealed: results ? null : 0 });
    return {
      ...scene,
      handles: [],
      ghost: results && answers ? ghostOf(input, answers, scene) : null,
    };
  };
}

/** Where the student's t's and points lie, or how the student's normal points. Null where the answer has no place. */
function ghostOf(input: Input, answers: Answers, scene: SceneModel): GhostModel | null {
  const { stage, ray, hits } = scene;
  const normal = ['N', 'N1'].map((id) => answers[id]).find((v) => typeof v === 'object');
  const [hit] = hits.filter(({ role }) => role === 'first');
  if (normal && hit) return arrow(hit.point, normal, stage.radius);
  const points = pointsOf(input, answers).filter((p) => p.every(Number.isFinite));
  const [first] = ray.segments;
  const last = ray.segments.at(-1);
  if (points.length === 0 || !first || !last) return null;
  return {
    title: 'yours',
    origin: ray.origin,
    direction: ray.direction,
    from: first.from,
    to: last.to,
    hits: points.filter((p) => isDrawn(p, stage)),
    beside: points.find((p) => isDrawn(p, stage)) ?? null,
  };
}

function arrow(from: Vec3, [x, y, z]: Vec3, radius: number): GhostModel | null {
  const length = Math.hypot(x, y, z);
  if (!(length > 0) || !Number.isFinite(length)) return null;
  const k = (0.3 * radius) / length;
  const to: Vec3 = [from[0] + k * x, from[1] + k * y, from[2] + k * z];
  return {
    title: 'yours',
    origin: from,
    direction: [k * x, k * y, k * z],
    from: 0,
    to: 1,
    hits: [to],
    beside: to,
  };
}

function pointsOf(input: Input, answers: Answers): Vec3[] {
  const values = valuesOf(input.shape, input.ray, float64);
  const at = (t: number): Vec3 => evaluateTriple(POINT, float64, withScalars(values, { t }));
  const ts = ['t', 't1', 't2'].flatMap((id) => {
    const t = answers[id];
    return typeof t === 'number' ? [at(t)] : [];
  });
  const points = ['P', 'P1', 'P2'].flatMap((id) => {
    const p = answers[id];
    return typeof p === 'object' ? [p] : [];
  });
  return [...ts, ...points];
}
