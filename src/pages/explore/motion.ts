import type { Dispatch } from '../../state/actions.ts';
import type { FullModel } from '../../state/derive.ts';
import { createExampleTransition } from './example-transition.ts';
import { createSweep } from './sweep.ts';

/** A function from the model to the model to draw: of a transition between examples, or a sweep. */
export function createMotion(
  host: HTMLElement,
  changed: () => void,
  dispatch: Dispatch,
  announce: (words: string) => void,
): (model: FullModel) => FullModel {
  const travel = createExampleTransition(host, changed);
  const sweep = createSweep(host, changed, dispatch, announce);
  return (model) => {
    const way = travel(model);
    const played = sweep(model);
    return played === model ? way : played;
  };
}
