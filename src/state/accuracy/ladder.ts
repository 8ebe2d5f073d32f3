import { whereLost } from '../../lab/explain.ts';
import { type Losses, lossesOf } from '../../lab/losses.ts';
import { type ThisRay, thisRay } from '../../lab/this-ray.ts';
import { METHODS } from '../../math/index.ts';
import { findMethod } from '../../math/shapes.ts';
import { type AppState, rayOf, shapeOf } from '../state.ts';
import { rayWords } from './ray-words.ts';

export interface RayModel extends ThisRay {
  readonly words: string;
  readonly where: ReadonlyMap<string, string>;
  readonly losses: Losses;
  readonly chosenTitle: string;
}

/** Caches the last result, since a page is drawn more often than its ray changes. */
export function createRayModel(): (state: AppState) => RayModel {
  let last: { key: readonly unknown[]; model: RayModel } | null = null;
  return (state) => {
    const key = [shapeOf(state), state.E, state.d, state.unit, state.method];
    if (last?.key.every((part, i) => Object.is(part, key[i]))) return last.model;
    const model = modelOf(state);
    last = { key, model };
    return model;
  };
}

function modelOf(state: AppState): RayModel {
  const shape = shapeOf(state);
  const ray = rayOf(state);
  const found = thisRay(shape, ray);
  const all = new Map(METHODS.map((method) => [method.id, lossesOf(method, shape, ray)] as const));
  const none: Losses = { steps: [], worst: null };
  return {
    ...found,
    words: rayWords(shape, ray, found.reference),
    where: new Map(
      found.rows.map((row) => [row.method.id, whereLost(row, all.get(row.method.id) ?? none)]),
    ),
    losses: all.get(state.method) ?? none,
    chosenTitle: findMethod(state.method)?.title ?? state.method,
  };
}
