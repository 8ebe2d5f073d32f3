import { type Derivation, derivation } from '../math/formula.ts';
import type { Intersection, Ray, Shape, Verdict } from '../math/index.ts';
import { definitionOf, intersectWhole } from '../math/shapes.ts';
import type { AsTyped } from './as-typed.ts';
import type { Ended } from './ended.ts';
import { type ExactResult, exactResultOf } from './exact-result.ts';
import { exampleOf, type ShownExample } from './example.ts';
import type { ExploreDetails } from './explore-details.ts';
import type { GraphModel } from './graph-model.ts';
import { memoise } from './memoise.ts';
import { knownLines, shownLines } from './reveal.ts';
import type { NearTangency, SceneAndGraph } from './scene-and-graph.ts';
import type { SceneModel } from './scene-model.ts';
import { type AppState, type Ghost, rayOf, shapeOf } from './state.ts';
import { type HitWords, hitWords, type VerdictWords, verdictWords } from './verdict-words.ts';

/** Everything that the Explore page shows, computed from the state and nothing else. */
export interface ExploreModel {
  readonly state: AppState;
  /** Drawn in a transition to another state: no person has set this one. */
  readonly passing?: true;
  readonly shape: Shape;
  readonly title: string;
  readonly meaning: string;
  readonly ray: Ray;
  /** About the whole surface, without regard to its ends. */
  readonly found: Intersection;
  /** What the ends leave of it; null for a shape without ends. */
  readonly ended: Ended | null;
  /** The code for ends is not loaded yet, so that no result is shown. */
  readonly waiting: boolean;
  /** The exact class, where the chosen method gives another one. */
  readonly contradicted: Verdict | null;
  /** The result of exact arithmetic, shown beside the method's digits. */
  readonly exactly: ExactResult;
  /** Null until its code is loaded; until then lines are shown without numbers put in. */
  readonly digits: ExploreDetails['digits'] | null;
  /** The verdict for the numbers as typed, where it differs from that for the stored doubles. */
  readonly asTyped: AsTyped;
  readonly derivation: Derivation;
  /** The example that is shown, as it is or changed. */
  readonly example: ShownExample | null;
  readonly verdict: VerdictWords;
  /** Set if no neighbouring doubles are nearer to tangency; null otherwise. */
  readonly near: NearTangency | null;
  readonly hits: readonly HitWords[];
  /** Values of the ghost by name: A, B, C, D, t1 …; empty without one. */
  readonly before: Readonly<Record<string, number | null>>;
  /** Null until ExploreDetails is loaded, and so is `scene`. */
  readonly graph: GraphModel | null;
  readonly scene: SceneModel | null;
  /** Which lines of the result are shown; some are hidden while a result is to be predicted. */
  readonly shown: ReturnType<typeof shownLines>;
}

/** The model once ExploreDetails is loaded: it has a graph and a scene. */
export type FullModel = ExploreModel & Pick<SceneAndGraph, 'graph' | 'scene'>;

export const isFull = (model: ExploreModel): model is FullModel => model.scene !== null;

const NOTHING_BEFORE: ExploreModel['before'] = {};
const NOT_COMPARED: AsTyped = { differs: null, notes: [] };

/**
 * A function from states to models, with a cache of its own: parts that did not change keep their
 * identity from call to call. While `loaded` returns null the model has no graph, no scene, and no
 * words on typed numbers and near tangency.
 */
export function createDerive(loaded: () => ExploreDetails): (state: AppState) => FullModel;
export function createDerive(
  loaded?: () => ExploreDetails | null,
): (state: AppState) => ExploreModel;
export function createDerive(
  loaded: () => ExploreDetails | null = () => null,
): (state: AppState) => ExploreModel {
  const ray = memoise((E: AppState['E'], d: AppState['d'], unit: boolean) =>
    rayOf({ E, d, unit } as AppState),
  );
  const solve = memoise((shape: Shape, r: Ray, method: string) => intersectWhole(shape, r, method));
  const check = memoise(exactResultOf);
  const typed = memoise(
    (
      details: ExploreDetails | null,
      texts: AppState['typed'],
      shape: Shape,
      E: AppState['E'],
      d: AppState['d'],
      unit: boolean,
      ray: Ray,
      found: Intersection,
    ) => details?.asTyped({ texts, shape, E, d, unit }, ray, found) ?? NOT_COMPARED,
  );
  const ends = memoise(
    (
      details: ExploreDetails | null,
      shape: Shape,
      ray: Ray,
      found: Intersection,
      { found: exactly }: ExactResult,
      between: AppState['between'],
      caps: boolean,
    ) => details?.endedOf(shape, ray, found, exactly, between, caps) ?? null,
  );
  const steps = memoise(derivation);
  let sceneAndGraph: ReturnType<ExploreDetails['createSceneAndGraph']> | undefined;
  const ghostResultOf = memoise((ghost: Ghost | null) => (ghost ? ghostResult(ghost) : null));
  return (state) => {
    const details = loaded();
    const shape = shapeOf(state);
    const definition = definitionOf(shape);
    const { meaning } = definition;
    const title = definition.named(shape).name;
    const r = ray(state.E, state.d, state.unit);
    const found = solve(shape, r, state.method);
    const exactly = check(shape, r);
    const exactClass = exactly.found.class;
    const ghost = ghostResultOf(state.ghost);
    const derived = steps(shape, r, found);
    const ended = ends(details, shape, r, found, exactly, state.between, state.caps);
    const waiting = details === null && state.between !== null && found.details.family === 'curved';
    const lines = shownLines({ derivation: derived }, state.revealed);
    const shown = waiting ? { ...lines, verdict: false, hits: false } : lines;
    const whole = verdictWords(found, shape, r);
    sceneAndGraph ??= details?.createSceneAndGraph();
    const seen = sceneAndGraph?.({
      state,
      shape,
      title,
      ray: r,
      found,
      exactly,
      ended,
      shown: shown.hits,
      ghost,
      verdict: whole,
    });
    const { verdict, ...others } = seen ?? { verdict: whole, near: null, graph: null, scene: null };
    return {
      state,
      shape,
      title,
      meaning: meaning(shape),
      ray: r,
      found,
      ended,
      waiting,
      contradicted: exactClass === found.class ? null : exactClass,
      exactly,
      digits: details?.digits ?? null,
      asTyped: typed(details, state.typed, shape, state.E, state.d, state.unit, r, exactly.found),
      derivation: knownLines(derived, shown.steps),
      example: exampleOf(state),
      hits: hitWords(found, ended),
      before: ghost?.before ?? NOTHING_BEFORE,
      shown,
      verdict,
      ...others,
    };
  };
}

/** What of a ghost is compared: the values of its derivation by id, and its roots. */
function ghostResult({ shape, ray }: Ghost) {
  const found = intersectWhole(shape, ray);
  const values = derivation(shape, ray, found).steps.map(({ id, value }) => [id, value]);
  const roots = found.hits.map(({ t }, i) => [`t${i + 1}`, t]);
  return {
    ray,
    found,
    before: Object.fromEntries([...values, ...roots]) as ExploreModel['before'],
  };
}
