import type { EffectId } from '../../scene/effects/index.ts';
import type { Scene } from '../../scene/types.ts';
import type { Dispatch } from '../../state/actions.ts';
import { builtUp } from '../../state/picture/build-up.ts';
import { refusalOf } from '../../state/picture/edits.ts';
import { textOfScene } from '../../state/picture/scene-link.ts';
import {
  changed,
  forcedTexts,
  type PictureKey,
  type PictureSettings,
  pictureSettings,
  textsOf,
} from '../../state/picture/settings.ts';
import type { TraceSettings } from '../../tracer/types.ts';
import { MOST_BOUNCES } from '../../tracer/weight.ts';

type Values = Readonly<Partial<Record<PictureKey, string>>>;

/** Functions that dispatch the actions of the page's controls. */
export interface PictureActions {
  set(values: Values): void;
  /** Values that follow from those there are when the edit arrives. */
  edit(values: (now: PictureSettings) => Values): void;
  /** A scene that is refused changes nothing: the form that it comes from has said why. */
  scene(edit: (now: Scene) => Scene): void;
  force(id: EffectId, how: 'on' | 'off' | 'no'): void;
  /** Simulates one effect more, or one less, of those that the scene calls for. */
  buildUp(by: 1 | -1): void;
  /** Shows the picture with these settings, which leave something out, beside the whole one. */
  showBesideWhole(settings: TraceSettings): void;
  /** Chooses the right side of the comparison: 'method:…' or 'start:…'. */
  right(value: string): void;
}

export function pictureActions(dispatch: Dispatch): PictureActions {
  const set: PictureActions['set'] = (values) =>
    dispatch({ type: 'settings', values: changed(values) });
  const edit: PictureActions['edit'] = (values) =>
    dispatch({ type: 'settings', values: (now) => changed(values(pictureSettings(now))) });
  return {
    set,
    edit,
    scene: (change) =>
      edit(({ scene }) => {
        const next = change(scene);
        return refusalOf(next) === null ? { scene: textOfScene(next) } : {};
      }),
    force: (id, how) => edit(({ forced }) => forcedTexts(forced, id, how)),
    buildUp: (by) => edit(({ scene, forced }) => textsOf(builtUp(scene, forced, by))),
    showBesideWhole({ forced, bounces, method }) {
      dispatch({ type: 'method', id: method });
      set({
        ...textsOf(forced),
        bounces: String(bounces ?? MOST_BOUNCES),
        against: 'whole',
        show: 'errors',
      });
    },
    right(value) {
      const [what, ...rest] = value.split(':');
      if (what === 'method') dispatch({ type: 'method', id: rest.join(':') });
      if (what === 'start') set({ start: rest.join(':') });
    },
  };
}
