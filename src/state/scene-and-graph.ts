import type { Drawing, Stage } from '../math/drawing.ts';
import type { Intersection, Ray, Shape } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import { cutDrawing, endPoints } from './cut-drawing.ts';
import type { Ended } from './ended.ts';
import type { ExactResult } from './exact-result.ts';
import { graphOf } from './graph.ts';
import type { GraphModel } from './graph-model.ts';
import { handlesOf, heightHandles } from './handles.ts';
import { heightsText } from './heights.ts';
import { withoutResults, withoutRoots } from './hidden-results.ts';
import { memoise } from './memoise.ts';
import { type NearTangent, nearTangent } from './near-tangent.ts';
import { nearestTangent, type Tangent } from './nearest-tangent.ts';
import { sceneOf } from './scene.ts';
import type { SceneModel } from './scene-model.ts';
import { sameStage, stageAround, stageOf } from './stage.ts';
import type { AppState } from './state.ts';
import type { Piece } from './verdict-parts.ts';
import type { VerdictWords } from './verdict-words.ts';

/** How near the ray is to tangency, and a search for a ray that touches; null if there is none. */
export interface NearTangency extends NearTangent {
  readonly find: ((state: AppState) => Tangent | null) | null;
}

interface SceneAndGraphInput {
  readonly state: AppState;
  readonly shape: Shape;
  readonly title: string;
  readonly ray: Ray;
  readonly found: Intersection;
  readonly exactly: ExactResult;
  readonly ended: Ended | null;
  /** Whether the hits are shown. */
  readonly shown: boolean;
  readonly ghost: { readonly ray: Ray; readonly found: Intersection } | null;
  readonly verdict: VerdictWords;
}

export interface SceneAndGraph {
  readonly graph: GraphModel;
  readonly scene: SceneModel;
  /** Where the numbers cannot be set any nearer to tangency. */
  readonly near: NearTangency | null;
  /** The given verdict, or that of a ray as near to tangency as doubles allow, or with ends. */
  readonly verdict: VerdictWords;
}

/**
 * A function to the models of scene and graph, with a cache of its own. `fixed` returns the stage
 * to show; null for the stage that fits the ray.
 */
export function createSceneAndGraph(
  fixed: () => Stage | null = () => null,
): (given: SceneAndGraphInput) => SceneAndGraph {
  const graphFor = memoise(graphOf);
  // While the hits are hidden the stage must not depend on them: it would give their places away.
  const stage = keepWhile(
    sameStage,
    (shape: Shape, r: Ray, found: Intersection | null, between: AppState['between']) =>
      found
        ? stageOf(shape, r, found, between ? endPoints(shape, between) : [])
        : stageAround(shape, [r.origin, ...(between ? endPoints(shape, between) : [])]),
  );
  const drawing = memoise(
    (shape: Shape, s: Stage, between: AppState['between'], caps: boolean): Drawing => {
      const whole = definitionOf(shape).draw(shape, s);
      return between ? cutDrawing(whole, shape, s, between, caps) : whole;
    },
  );
  const handles = memoise(
    (
      shape: Shape,
      E: AppState['E'],
      d: AppState['d'],
      unit: boolean,
      ray: Ray,
      drawing: Drawing,
      lock: AppState['lock'],
      between: AppState['between'],
      s: Stage,
    ) => [
      ...handlesOf({ shape, E, d, unit, ray, drawing }).filter(
        ({ symbol }) => !lock.includes(symbol),
      ),
      ...(between && !lock.includes('between') ? heightHandles(shape, between, s) : []),
    ],
  );
  const nearly = memoise(
    (
      shape: Shape,
      ray: Ray,
      exactly: ExactResult,
      held: ReturnType<typeof handlesOf>,
      state: AppState,
    ): NearTangency | null => {
      const near = nearTangent(shape, ray, exactly, held);
      return near && { ...near, find: nearestTangent(state) && nearestTangent };
    },
  );
  return ({ state, shape, title, ray, found, exactly, ended, shown, ghost, verdict: words }) => {
    const graph = graphFor(found, shape, ray, state.bead, ghost?.found ?? null, ended);
    const between = ended ? state.between : null;
    const s = fixed() ?? stage(shape, ray, shown ? found : null, between);
    const picture = drawing(shape, s, between, state.caps);
    const { E, d, unit, lock } = state;
    const held = handles(shape, E, d, unit, ray, picture, lock, between, s);
    const near = nearly(shape, ray, exactly, held, state);
    const whole =
      near && exactly.found.class === found.class
        ? { ...words, pieces: [near.text], text: near.text }
        : words;
    const isKnown = ended && found.class !== 'undecided';
    const verdict = isKnown ? endedVerdict(whole, ended) : whole;
    const scene = sceneOf({
      title,
      verdict: verdict.text,
      ray,
      found,
      ended,
      stage: s,
      drawing: picture,
      handles: held,
      graph,
      view: state.view,
      ghost,
    });
    return {
      near,
      verdict,
      graph: shown ? graph : withoutRoots(graph, { shape, ray, state }),
      scene: shown ? scene : withoutResults(scene, state),
    };
  };
}

/** The words on the whole surface, and what its ends leave of them. */
function endedVerdict(words: VerdictWords, ended: Ended): VerdictWords {
  const how = ended.caps ? 'capped' : 'open';
  const tail = `; cut at ${heightsText(ended.between)}, ${how}: ${ended.text}`;
  const pieces: Piece[] = ['uncut, ', ...words.pieces, tail];
  return { ...words, pieces, text: `uncut, ${words.text}${tail}` };
}

/** Gives the previous result again while the new one equals it. */
function keepWhile<Args extends readonly unknown[], R>(
  same: (a: R, b: R) => boolean,
  f: (...args: Args) => R,
): (...args: Args) => R {
  let last: R | null = null;
  return (...args) => {
    const next = f(...args);
    if (last === null || !same(last, next)) last = next;
    return last;
  };
}
