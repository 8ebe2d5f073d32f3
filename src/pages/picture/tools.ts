import type { EffectId } from '../../scene/effects/index.ts';
import type { Scene } from '../../scene/types.ts';
import type { Dispatch } from '../../state/actions.ts';
import { textOfScene } from '../../state/picture/scene-link.ts';
import {
  changed,
  forcedTexts,
  type PictureKey,
  type PictureSettings,
} from '../../state/picture/settings.ts';

/** What a person does on the page, as actions. */
export interface PageTools {
  set(values: Readonly<Partial<Record<PictureKey, string>>>): void;
  scene(scene: Scene): void;
  force(picture: PictureSettings, id: EffectId, how: 'on' | 'off' | 'no'): void;
  /** The right side: 'method:…' or 'start:…'. */
  right(value: string): void;
}

export function pageTools(dispatch: Dispatch): PageTools {
  const set: PageTools['set'] = (values) => dispatch({ type: 'settings', values: changed(values) });
  return {
    set,
    scene: (scene) => set({ scene: textOfScene(scene) }),
    force: ({ forced }, id, how) => set(forcedTexts(forced, id, how)),
    right(value) {
      const [what, ...rest] = value.split(':');
      if (what === 'method') dispatch({ type: 'method', id: rest.join(':') });
      if (what === 'start') set({ start: rest.join(':') });
    },
  };
}
