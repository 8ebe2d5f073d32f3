import type { Shape, Vec3 } from '../math/index.ts';
import { checkParam, findShape, type Param } from '../math/shapes.ts';
import { type AppState, paramValue, RAY_PARAMS, shapeOf } from '../state/state.ts';

/** A movement of ray and shape from a state that was drawn to another one of the same shape. */
interface Transition {
  /** Starts one, if both are of one shape on Explore; with reduced motion there is none. */
  start(from: AppState | null, to: AppState): void;
  end(): void;
  /** The state to draw now; `ask` is called as long as it is on its way. */
  at(to: AppState): AppState;
  readonly underWay: boolean;
}

/** `ask` asks for the next frame. */
export function createTransition(milliseconds: number, ask: () => void): Transition {
  let way: { readonly from: AppState; readonly began: number } | null = null;
  return {
    start(from, to) {
      const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
      const fits =
        from?.page === to.page && to.page === 'explore' && numbersOf(from) !== numbersOf(to);
      way = fits && !still && from.kind === to.kind ? { from, began: performance.now() } : null;
    },
    end() {
      way = null;
    },
    at(to) {
      const share = way ? (performance.now() - way.began) / milliseconds : 1;
      if (share >= 1) way = null;
      if (!way) return to;
      ask();
      return between(way.from, to, share * share * (3 - 2 * share));
    },
    get underWay() {
      return way !== null;
    },
  };
}

const numbersOf = (state: AppState): string => JSON.stringify([state.E, state.d, shapeOf(state)]);

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
