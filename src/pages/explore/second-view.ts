import type { Action, Dispatch } from '../../state/actions.ts';
import type { SceneModel } from '../../state/scene-model.ts';
import { lazyScene, type Scene } from '../lazy-scene.ts';
import './second-view.css';

export interface SecondView {
  readonly on: boolean;
  toggle(): void;
  /** Beside the scene in this element. */
  render(stage: HTMLElement, model: SceneModel): void;
}

/** Windows that are wide enough for two views side by side. */
const WIDE = '(min-width: 900px)';
const NO_ROOM = 'a second view needs a window of 900 pixels or more';

/**
 * The same scene once more from above, or from the side if the scene itself is seen from above. Its
 * handles can be dragged too; its view cannot be turned.
 */
export function createSecondView(
  dispatch: Dispatch,
  changed: () => void,
  say: (words: string) => void,
): SecondView {
  const wide = matchMedia(WIDE);
  wide.addEventListener('change', changed);
  let on = false;
  let shown: { readonly host: HTMLElement; readonly scene: Scene } | null = null;
  const moves = (action: Action): void => {
    if (action.type !== 'view') dispatch(action);
  };
  return {
    get on() {
      return on && wide.matches;
    },
    toggle() {
      if (wide.matches) on = !on;
      say(!wide.matches ? NO_ROOM : on ? 'two views' : 'one view');
      changed();
    },
    render(stage, model) {
      const wanted = on && wide.matches;
      stage.toggleAttribute('data-two-views', wanted);
      if (!wanted || shown?.host.parentElement !== stage) {
        shown?.scene.dispose();
        shown?.host.remove();
        shown = null;
      }
      if (!wanted) return;
      if (!shown) {
        const host = document.createElement('div');
        host.className = 'scene-host second-view';
        stage.append(host);
        shown = { host, scene: lazyScene(host, moves) };
      }
      shown.scene.render({ ...model, view: model.view === 'top' ? 'front' : 'top' });
    },
  };
}
