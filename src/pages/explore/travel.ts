import type { Shape, Vec3 } from '../../math/index.ts';
import { checkParam, findShape, type Param } from '../../math/shapes.ts';
import { closerLook } from '../../state/closer-look.ts';
import { createDerive, type FullModel } from '../../state/derive.ts';
import { type AppState, paramValue, RAY_PARAMS, shapeOf } from '../../state/state.ts';

const MILLISECONDS = 900;
/** Largest ratio of two stages' radii between which a transition is drawn. */
const APART = 20;

/**
 * Draws a transition from one example of a shape to the next by interpolating the numbers. The
 * state, and what is announced and saved, change at once; only the drawn model is interpolated. Any
 * input ends it. Meanwhile `host` has `data-moving`; `changed` asks for the next frame.
 */
export function createTravel(
  host: HTMLElement,
  changed: () => void,
): (model: FullModel) => FullModel {
  const derive = createDerive(() => closerLook);
  let last: FullModel | null = null;
  let shown: AppState | null = null;
  let way: { readonly from: AppState; readonly began: number } | null = null;
  const end = (): void => {
    if (way) changed();
    way = null;
  };
  for (const input of ['pointerdown', 'keydown', 'wheel', 'hashchange'])
    window.addEventListener(input, end, { capture: true, passive: true });
  return (model) => {
    const { state } = model;
    if (state !== last?.state) {
      const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
      const goes = !still && shown !== null && last !== null && isNext(last, model);
      way = goes && shown ? { from: shown, began: performance.now() } : null;
    }
    last = model;
    const share = way ? (performance.now() - way.began) / MILLISECONDS : 1;
    if (share >= 1) way = null;
    shown = way ? between(way.from, state, share * share * (3 - 2 * share)) : state;
    host.toggleAttribute('data-moving', way !== null);
    if (!way) return model;
    changed();
    return { ...derive(shown), example: model.example, passing: true };
  };
}

/** Whether another example of the same shape and a similar size was opened. */
function isNext(before: FullModel, { state, example, scene }: FullModel): boolean {
  const ratio = before.scene.stage.radius / scene.stage.radius;
  return (
    example?.changed === false &&
    state.example === example.entry.id &&
    example.entry !== before.example?.entry &&
    state.kind === before.state.kind &&
    ratio < APART &&
    ratio > 1 / APART
  );
}

/** Interpolates two states of one shape; what cannot be interpolated is that of the second. */
export function between(from: AppState, to: AppState, share: number): AppState {
  const mixed = (param: Param, a: unknown, b: unknown): unknown => {
    const one = (x: number, y: number): number => (x === y ? y : (1 - share) * x + share * y);
    const value =
      param.type === 'number'
        ? one(a as number, b as number)
        : param.type === 'vector'
          ? (b as Vec3).map((y, i) => one((a as Vec3)[i] ?? y, y))
          : b;
    try {
      checkParam(param, value);
      return value;
    } catch {
      return b;
    }
  };
  const [start, goal] = [shapeOf(from), shapeOf(to)];
  const params = (findShape(to.kind)?.params ?? []).map((param) => [
    param.key,
    mixed(param, paramValue(start, param.key), paramValue(goal, param.key)),
  ]);
  const shape = { ...goal, ...Object.fromEntries(params) } as Shape;
  return {
    ...to,
    E: mixed(RAY_PARAMS.E, from.E, to.E) as Vec3,
    d: mixed(RAY_PARAMS.d, from.d, to.d) as Vec3,
    shapes: { ...to.shapes, [to.kind]: shape },
    typed: {},
  };
}
