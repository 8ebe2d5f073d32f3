import { type Derivation, derivation } from '../math/formula.ts';
import type { Intersection, Ray, Shape, Verdict } from '../math/index.ts';
import { definitionOf, intersectWhole } from '../math/shapes.ts';
import type { AsTyped } from './as-typed.ts';
import type { CloserLook } from './closer-look.ts';
import type { Ended } from './ended.ts';
import { type Exactly, exactlyOf } from './exactly.ts';
import { exampleOf, type ShownExample } from './example.ts';
import type { GraphModel } from './graph-model.ts';
import { memoise } from './memoise.ts';
import { knownLines, shownLines } from './reveal.ts';
import type { Near, SceneAndGraph } from './scene-and-graph.ts';
import type { SceneModel } from './scene-model.ts';
import { type AppState, type Ghost, rayOf, shapeOf } from './state.ts';
import { type HitWords, hitWords, type VerdictWords, verdictWords } from './words.ts';

/** Everything that the Explore page shows, computed from the state and nothing else. */
export interface ExploreModel {
  readonly state: AppState;
  /** Drawn on the way to another state, and brought about by nobody. */
  readonly passing?: true;
  readonly shape: Shape;
  readonly title: string;
  readonly meaning: string;
  readonly ray: Ray;
  /** About the whole surface, without regard to its ends. */
  readonly found: Intersection;
  /** What the ends leave of it; null for a shape without ends. */
  readonly ended: Ended | null;
  /** What the ends do is not known before its code is loaded: nothing is said of the result. */
  readonly waiting: boolean;
  /** The exact class, where the chosen method gives another one. */
  readonly contradicted: Verdict | null;
  /** What exact arithmetic says, for what stands beside the method's digits. */
  readonly exactly: Exactly;
  /** Null until its code is loaded; until then lines are shown without numbers put in. */
  readonly digits: CloserLook['digits'] | null;
  /** The verdict for the numbers as typed, where it differs from that for the stored doubles. */
  readonly asTyped: AsTyped;
  readonly derivation: Derivation;
  /** The example that is shown, as it is or changed. */
  readonly example: ShownExample | null;
  readonly verdict: VerdictWords;
  /** Set if no neighbouring doubles are nearer to tangency; null otherwise. */
  readonly near: Near | null;
  readonly hits: readonly HitWords[];
  /** Values of the ghost by name: A, B, C, D, t1 …; empty without one. */
  readonly before: Readonly<Record<string, number | null>>;
  /** Null until the code of a closer look is loaded. */
  readonly graph: GraphModel | null;
  readonly scene: SceneModel | null;
  /** Which lines of the result are shown; some are hidden while a result is to be predicted. */
  readonly shown: ReturnType<typeof shownLines>;
}

/** The same, where the code of a closer look is loaded. */
export type FullModel = ExploreModel & Pick<SceneAndGraph, 'graph' | 'scene'>;

export const isFull = (model: ExploreModel): model is FullModel => model.scene !== null;

const NOTHING_BEFORE: ExploreModel['before'] = {};
const NOT_COMPARED: AsTyped = { differs: null, notes: [] };

/**
 * A derive with a memory of its own, so that parts that did not change keep their identity from
 * call to call. `look` gives the code of a closer look, null as long as it is not loaded: then
 * there is no picture, and nothing is said of typed numbers and of near tangency.
 */
export function createDerive(look: () => CloserLook): (state: AppState) => FullModel;
export function createDerive(look?: () => CloserLook | null): (state: AppState) => ExploreModel;
export function createDerive(
  look: () => CloserLook | null = () => null,
): (state: AppState) => ExploreModel {
  const ray = memoise((E: AppState['E'], d: AppState['d'], unit: boolean) =>
    rayOf({ E, d, unit } as AppState),
  );
  const solve = memoise((shape: Shape, r: Ray, method: string) => intersectWhole(shape, r, method));
  const check = memoise(exactlyOf);
  const typed = memoise(
    (
      closer: CloserLook | null,
      texts: AppState['typed'],
      shape: Shape,
      E: AppState['E'],
      d: AppState['d'],
      unit: boolean,
      ray: Ray,
      found: Intersection,
    ) => closer?.asTyped({ texts, shape, E, d, unit }, ray, found) ?? NOT_COMPARED,
  );
  const ends = memoise(
    (
      closer: CloserLook | null,
      shape: Shape,
      ray: Ray,
      found: Intersection,
      { found: exactly }: Exactly,
      between: AppState['between'],
      caps: boolean,
    ) => closer?.endedOf(shape, ray, found, exactly, between, caps) ?? null,
  );
  const steps = memoise(derivation);
  let sceneAndGraph: ReturnType<CloserLook['createSceneAndGraph']> | undefined;
  const ghostly = memoise((ghost: Ghost | null) => (ghost ? keptOf(ghost) : null));
  return (state) => {
    const closer = look();
    const shape = shapeOf(state);
    const definition = definitionOf(shape);
    const { meaning } = definition;
    const title = definition.named(shape).name;
    const r = ray(state.E, state.d, state.unit);
    const found = solve(shape, r, state.method);
    const exactly = check(shape, r);
    const exactClass = exactly.found.class;
    const ghost = ghostly(state.ghost);
    const derived = steps(shape, r, found);
    const ended = ends(closer, shape, r, found, exactly, state.between, state.caps);
    const waiting = closer === null && state.between !== null && found.details.family === 'curved';
    const lines = shownLines({ derivation: derived }, state.revealed);
    const shown = waiting ? { ...lines, verdict: false, hits: false } : lines;
    const whole = verdictWords(found, shape, r);
    sceneAndGraph ??= closer?.createSceneAndGraph();
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
      digits: closer?.digits ?? null,
      asTyped: typed(closer, state.typed, shape, state.E, state.d, state.unit, r, exactly.found),
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
function keptOf({ shape, ray }: Ghost) {
  const found = intersectWhole(shape, ray);
  const values = derivation(shape, ray, found).steps.map(({ id, value }) => [id, value]);
  const roots = found.hits.map(({ t }, i) => [`t${i + 1}`, t]);
  return {
    ray,
    found,
    before: Object.fromEntries([...values, ...roots]) as ExploreModel['before'],
  };
}
