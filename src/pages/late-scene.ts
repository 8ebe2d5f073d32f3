import { html, nothing, render } from 'lit';
import type { Dispatch } from '../state/actions.ts';
import type { SceneModel } from '../state/scene-model.ts';
import { late, notLoaded } from '../ui/late.ts';
import type { Mounted } from '../ui/mounted.ts';
import type { Thumbnail } from './gallery.ts';

/** Loading that takes longer than this is said. */
const PATIENCE_MS = 300;

export interface Scene extends Mounted<SceneModel> {
  /** The picture as a PNG; null while there is none. */
  picture(): Promise<Blob | null>;
  /** Draws small pictures; null until the scene's code is there. */
  thumbnail(): Thumbnail | null;
}

type SceneCode = typeof import('../canvas/scene.ts');

/**
 * three.js is a chunk of its own: formulas stand on the page before it arrives, and without it if
 * it does not.
 */
export function lateScene(host: HTMLElement, dispatch: Dispatch): Scene {
  let model: SceneModel | null = null;
  let code: SceneCode | null = null;
  let mounted: ReturnType<SceneCode['mountScene']> | null = null;
  let disposed = false;
  const notice = document.createElement('div');
  notice.className = 'scene-waiting';
  const load = (): void => {
    host.append(notice);
    render(nothing, notice);
    const waiting = setTimeout(
      () => render(html`<p role="status">drawing…</p>`, notice),
      PATIENCE_MS,
    );
    late(() => import('../canvas/scene.ts')).then(
      (loaded) => {
        clearTimeout(waiting);
        notice.remove();
        if (disposed) return;
        code = loaded;
        mounted = loaded.mountScene(host, dispatch);
        if (model) mounted.render(model);
      },
      () => {
        clearTimeout(waiting);
        render(
          notLoaded(
            'The picture could not be loaded. All numbers, formulas and the plot work.',
            load,
          ),
          notice,
        );
      },
    );
  };
  load();
  return {
    render(next) {
      model = next;
      mounted?.render(next);
    },
    picture: async () => mounted?.picture() ?? null,
    thumbnail: () => code?.drawThumbnail ?? null,
    dispose() {
      disposed = true;
      mounted?.dispose();
    },
  };
}
