import type { Drawing, Stage } from '../math/drawing.ts';
import { type Derivation, derivation } from '../math/formula.ts';
import { type Intersection, intersect, type Ray, type Shape, type Verdict } from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import type { AsTyped } from './as-typed.ts';
import type { CloserLook } from './closer-look.ts';
import { type Exactly, exactlyOf } from './exactly.ts';
import { exampleOf, type ShownExample } from './example.ts';
import { graphOf } from './graph.ts';
import type { GraphModel } from './graph-model.ts';
import type { Handle } from './handles.ts';
import type { NearTangent } from './near-tangent.ts';
import type { Tangent } from './nearest-tangent.ts';
import { shownLines, withoutResults } from './reveal.ts';
import { sceneOf } from './scene.ts';
import type { SceneModel } from './scene-model.ts';
import { sameStage, stageAround, stageOf } from './stage.ts';
import { type AppState, type Ghost, rayOf, shapeOf } from './state.ts';
import { type HitWords, hitWords, type VerdictWords, verdictWords } from './words.ts';

/** Everything that the Explore page shows, computed from the state and nothing else. */
export interface ExploreModel {
  readonly state: AppState;
  readonly shape: Shape;
  readonly title: string;
  readonly meaning: string;
  readonly ray: Ray;
  readonly found: Intersection;
  /** The exact class, where the chosen method gives another one. */
  readonly contradicted: Verdict | null;
  /** What exact arithmetic says, for what stands beside the method's digits. */
  readonly exactly: Exactly;
  /** Null until it is loaded: then lines stand without their numbers put in. */
  readonly digits: CloserLook['digits'] | null;
  /** Where the numbers as typed give another case than the doubles that store them. */
  readonly asTyped: AsTyped;
  readonly derivation: Derivation;
  /** The example that is shown, as it is or changed. */
  readonly example: ShownExample | null;
  readonly verdict: VerdictWords;
  /** Where the numbers cannot be set any nearer to tangency. */
  readonly near: Near | null;
  readonly hits: readonly HitWords[];
  /** Of the kept ray: A, B, C, D, t1 …; empty without one. */
  readonly before: Readonly<Record<string, number | null>>;
  readonly graph: GraphModel;
  readonly scene: SceneModel;
  /** Which lines of the result are shown, for predicting first. */
  readonly shown: ReturnType<typeof shownLines>;
}

/** Keeps the result of the last call while every argument is the same by reference. */
function remember<Args extends readonly unknown[], R>(
  f: (...args: Args) => R,
): (...args: Args) => R {
  let last: { args: Args; result: R } | null = null;
  return (...args) => {
    if (last?.args.every((arg, i) => Object.is(arg, args[i]))) return last.result;
    last = { args, result: f(...args) };
    return last.result;
  };
}

/** How near the ray is to tangency, and what finds a ray that touches, where there is one. */
interface Near extends NearTangent {
  readonly find: ((state: AppState) => Tangent | null) | null;
}

const NOTHING_BEFORE: ExploreModel['before'] = {};
const NOT_COMPARED: AsTyped = { differs: null, notes: [] };

/**
 * A derive with a memory of its own, so that parts that did not change keep their identity from
 * call to call. `look` gives the code of a closer look, null as long as it is not loaded: then
 * nothing is said of typed numbers and of near tangency, and nothing can be dragged.
 */
export function createDerive(
  look: () => CloserLook | null = () => null,
): (state: AppState) => ExploreModel {
  const ray = remember((E: AppState['E'], d: AppState['d'], unit: boolean) =>
    rayOf({ E, d, unit } as AppState),
  );
  const solve = remember((shape: Shape, r: Ray, method: string) => intersect(shape, r, method));
  const check = remember(exactlyOf);
  const typed = remember(
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
  const steps = remember(derivation);
  const graphFor = remember(graphOf);
  // While the hits are hidden their places may not be read off the part of the world that is shown.
  const stage = keepWhile(sameStage, (shape: Shape, r: Ray, found: Intersection | null) =>
    found ? stageOf(shape, r, found) : stageAround(shape, [r.origin]),
  );
  const drawing = remember((shape: Shape, s: Stage): Drawing => definitionOf(shape).draw(shape, s));
  const handles = remember(
    (
      closer: CloserLook | null,
      shape: Shape,
      E: AppState['E'],
      d: AppState['d'],
      unit: boolean,
      ray: Ray,
      drawing: Drawing,
    ): readonly Handle[] => closer?.handlesOf({ shape, E, d, unit, ray, drawing }) ?? [],
  );
  const nearly = remember(
    (
      closer: CloserLook | null,
      shape: Shape,
      ray: Ray,
      exactly: Exactly,
      held: readonly Handle[],
      state: AppState,
    ): Near | null => {
      const near = closer?.nearTangent(shape, ray, exactly, held);
      if (!closer || !near) return null;
      return { ...near, find: closer.nearestTangent(state) && closer.nearestTangent };
    },
  );
  const ghostly = remember((ghost: Ghost | null) => (ghost ? keptOf(ghost) : null));
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
    const graph = graphFor(found, shape, r, state.bead, ghost?.found ?? null);
    const derived = steps(shape, r, found);
    const shown = shownLines({ derivation: derived }, state.revealed);
    const s = stage(shape, r, shown.hits ? found : null);
    const picture = drawing(shape, s);
    const held = handles(closer, shape, state.E, state.d, state.unit, r, picture);
    const near = nearly(closer, shape, r, exactly, held, state);
    const words = verdictWords(found, shape, r);
    const verdict =
      near && exactClass === found.class
        ? { ...words, pieces: [near.text], text: near.text }
        : words;
    const scene = sceneOf({
      title,
      verdict: verdict.text,
      ray: r,
      found,
      stage: s,
      drawing: picture,
      handles: held,
      graph: graph,
      view: state.view,
      ghost,
    });
    return {
      state,
      shape,
      title,
      meaning: meaning(shape),
      ray: r,
      found,
      contradicted: exactClass === found.class ? null : exactClass,
      exactly,
      digits: closer?.digits ?? null,
      asTyped: typed(closer, state.typed, shape, state.E, state.d, state.unit, r, exactly.found),
      derivation: derived,
      example: exampleOf(state),
      verdict,
      near,
      hits: hitWords(found),
      before: ghost?.before ?? NOTHING_BEFORE,
      graph: shown.hits ? graph : { ...graph, ghost: null, concealed: true },
      scene: shown.hits ? scene : withoutResults(scene, state),
      shown,
    };
  };
}

/** A kept ray with what is compared: its lines' values by their ids, and its roots. */
function keptOf({ shape, ray }: Ghost) {
  const found = intersect(shape, ray);
  const values = derivation(shape, ray, found).steps.map(({ id, value }) => [id, value]);
  const roots = found.hits.map(({ t }, i) => [`t${i + 1}`, t]);
  return {
    ray,
    found,
    before: Object.fromEntries([...values, ...roots]) as ExploreModel['before'],
  };
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
