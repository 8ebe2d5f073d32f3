import type { Dispatch } from '../state/actions.ts';
import type { SceneModel } from '../state/scene-model.ts';
import { late } from '../ui/late.ts';
import type { Mounted } from '../ui/mounted.ts';
import { lateView } from './late-view.ts';

export interface Scene extends Mounted<SceneModel> {
  /** The picture as a PNG; null while there is none. */
  picture(): Promise<Blob | null>;
}

const WORDS = {
  waiting: 'drawing…',
  failed: 'The picture could not be loaded. All numbers and formulas work.',
};

/** The scene, with three.js. */
export function lateScene(host: HTMLElement, dispatch: Dispatch): Scene {
  const { view, ...mounted } = lateView<
    SceneModel,
    typeof import('../canvas/scene.ts'),
    ReturnType<typeof import('../canvas/scene.ts').mountScene>
  >(
    host,
    () => late(() => import('../canvas/scene.ts')),
    ({ mountScene }) => mountScene(host, dispatch),
    WORDS,
  );
  return {
    ...mounted,
    picture: async () => view()?.picture() ?? null,
  };
}
