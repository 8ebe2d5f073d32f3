import type { Shape, Vec3 } from '../../math/index.ts';
import { type AppState, shapeOf } from '../../state/state.ts';

const TRAVEL_MS = 400;

/** Interpolates numbers and arrays; other values are those of b. */
function between<T>(a: T, b: T, share: number): T {
  if (typeof a === 'number' && typeof b === 'number') return (a + (b - a) * share) as T;
  if (!Array.isArray(a) || !Array.isArray(b)) return b;
  return b.map((x, i) => between(a[i], x, share)) as T;
}

function shapeBetween(a: Shape, b: Shape, share: number): Shape {
  const from = a as unknown as Readonly<Record<string, unknown>>;
  const pairs = Object.entries(b).map(([key, x]) => [key, between(from[key], x, share)]);
  return Object.fromEntries(pairs) as Shape;
}

/** Interpolates the states of two steps with the same shape. */
function stateBetween(a: AppState, b: AppState, share: number): AppState {
  const shape = shapeBetween(shapeOf(a), shapeOf(b), share);
  const d: Vec3 = between(a.d, b.d, share);
  // Halfway between opposite directions d would be 0.
  const has = d.some((x) => x !== 0);
  return {
    ...b,
    shapes: { ...b.shapes, [b.kind]: shape },
    E: between(a.E, b.E, share),
    d: has ? d : b.d,
    typed: {},
  };
}

const numbersOf = ({ E, d, kind, shapes }: AppState): string =>
  JSON.stringify([E, d, kind, shapes[kind]]);

/**
 * Draws a transition of ray and shape from one step to the next. `ask` asks for the next frame.
 * With reduced motion there is no transition.
 */
export function createTravel(ask: () => void) {
  let from: AppState | null = null;
  let begun = 0;
  return {
    /** Starts a transition from the state that was drawn last. */
    start(last: AppState | null, next: AppState): void {
      const still = matchMedia('(prefers-reduced-motion: reduce)').matches;
      const fits = last?.page === 'explore' && next.page === 'explore' && last.kind === next.kind;
      from = fits && !still && numbersOf(last) !== numbersOf(next) ? last : null;
      begun = performance.now();
    },
    /** The state to draw now. */
    now(state: AppState): AppState {
      if (!from) return state;
      const share = (performance.now() - begun) / TRAVEL_MS;
      if (share >= 1) {
        from = null;
        return state;
      }
      ask();
      const eased = share * share * (3 - 2 * share);
      return stateBetween(from, state, eased);
    },
    get underWay(): boolean {
      return from !== null;
    },
  };
}
