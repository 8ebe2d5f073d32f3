import type { AppState } from '../../state/state.ts';
import type { View } from '../../state/view.ts';
import { lateScene } from '../late-scene.ts';
import type { PageContext } from '../page.ts';
import type { Memory } from './memory.ts';
import type { Wanted } from './question-scene.ts';
import { createPicture } from './question-scene.ts';
import type { CheckSettings } from './settings.ts';

/** What every part of the page is created with. */
export interface PartContext extends PageContext {
  readonly memory: Memory;
  /** Writes settings into the link. */
  readonly set: (wanted: Partial<CheckSettings>) => void;
}

/**
 * One of the two that share the left side: words above the picture and below it, and what the
 * picture shows.
 */
export interface LeftPart {
  render(head: HTMLElement, body: HTMLElement, state: AppState, settings: CheckSettings): Shown;
}

export type Shown = Omit<Wanted, 'view'>;

export function element(className: string, into: Element): HTMLElement {
  const made = document.createElement('div');
  made.className = className;
  into.append(made);
  return made;
}

/** As 'iso', from farther away: a drawn E may lie low in front, where 'iso' cuts the stage off. */
const ROOMY: View = { azimuth: 16, elevation: 14, zoom: 0.72 };

/**
 * A picture that can be turned; its view is nobody else's. Its code and canvas come with the first
 * thing to show.
 */
export function turnablePicture(
  host: HTMLElement,
  changed: () => void,
): { render(shown: Shown): void } {
  const picture = createPicture();
  let view: View = ROOMY;
  let scene: ReturnType<typeof lateScene> | null = null;
  return {
    render(shown) {
      scene ??= lateScene(element('scene-host', host), (action) => {
        if (action.type !== 'view') return;
        view = action.view;
        changed();
      });
      scene.render(picture({ ...shown, view }));
    },
  };
}
