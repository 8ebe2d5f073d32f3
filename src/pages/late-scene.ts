import type { Dispatch } from '../state/actions.ts';
import type { SceneModel } from '../state/scene-model.ts';
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

/** three.js is a chunk of its own: formulas stand on the page before it arrives, and without it if it does not. */
export function lateScene(host: HTMLElement, dispatch: Dispatch): Scene {
  let model: SceneModel | null = null;
  let code: SceneCode | null = null;
  let mounted: ReturnType<SceneCode['mountScene']> | null = null;
  let disposed = false;
  const notice = document.createElement('p');
  notice.className = 'scene-waiting';
  notice.setAttribute('role', 'status');
  const say = (words: string): void => {
    notice.textContent = words;
    host.append(notice);
  };
  const waiting = setTimeout(() => say('drawing…'), PATIENCE_MS);
  const done = (): void => {
    clearTimeout(waiting);
    notice.remove();
  };
  import('../canvas/scene.ts').then(
    (loaded) => {
      done();
      if (disposed) return;
      code = loaded;
      mounted = loaded.mountScene(host, dispatch);
      if (model) mounted.render(model);
    },
    () => {
      done();
      say('The picture could not be loaded. All numbers, formulas and the plot work.');
    },
  );
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
