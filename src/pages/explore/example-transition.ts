import { createDerive, type FullModel } from '../../state/derive.ts';
import { exploreDetails } from '../../state/explore-details.ts';
import type { AppState } from '../../state/state.ts';
import { createTransition } from '../transition.ts';

const MILLISECONDS = 900;
/** Largest ratio of two stages' radii between which a transition is drawn. */
const APART = 20;

/**
 * Draws a transition from one example of a shape to the next by interpolating the numbers. The
 * state, and what is announced and saved, change at once; only the drawn model is interpolated. Any
 * input ends it. Meanwhile `host` has `data-moving`; `changed` asks for the next frame.
 */
export function createExampleTransition(
  host: HTMLElement,
  changed: () => void,
): (model: FullModel) => FullModel {
  const derive = createDerive(() => exploreDetails);
  let last: FullModel | null = null;
  let shown: AppState | null = null;
  const way = createTransition(MILLISECONDS, changed);
  const end = (): void => {
    if (way.underWay) changed();
    way.end();
  };
  for (const input of ['pointerdown', 'keydown', 'wheel', 'hashchange'])
    window.addEventListener(input, end, { capture: true, passive: true });
  return (model) => {
    const { state } = model;
    if (state !== last?.state) {
      if (last && isNext(last, model)) way.start(shown, state);
      else way.end();
    }
    last = model;
    shown = way.at(state);
    host.toggleAttribute('data-moving', way.underWay);
    return way.underWay ? { ...derive(shown), example: model.example, passing: true } : model;
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
