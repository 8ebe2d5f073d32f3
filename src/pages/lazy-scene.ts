import type { Dispatch } from '../state/actions.ts';
import type { SceneModel } from '../state/scene-model.ts';
import { lazy } from '../ui/lazy.ts';
import type { Mounted } from '../ui/mounted.ts';
import { lazyView } from './lazy-view.ts';

export interface Scene extends Mounted<SceneModel> {
  /** The picture as a PNG; null while there is none. */
  picture(): Promise<Blob | null>;
}

const WORDS = {
  waiting: 'drawing…',
  failed: 'The picture could not be loaded. All numbers and formulas work.',
};

/** The scene, with three.js. */
export function lazyScene(host: HTMLElement, dispatch: Dispatch): Scene {
  const { view, ...mounted } = lazyView<
    SceneModel,
    typeof import('../canvas/scene.ts'),
    ReturnType<typeof import('../canvas/scene.ts').mountScene>
  >(
    host,
    () => lazy(() => import('../canvas/scene.ts')),
    ({ mountScene }) => mountScene(host, dispatch),
    WORDS,
  );
  return {
    ...mounted,
    picture: async () => view()?.picture() ?? null,
  };
}
