import { mountGraph } from '../../charts/graph.ts';
import type { Dispatch } from '../../state/actions.ts';
import type { ExploreModel } from '../../state/derive.ts';
import { late } from '../../ui/late.ts';
import type { Mounted } from '../../ui/mounted.ts';
import { lateScene } from '../late-scene.ts';

interface StageModel {
  readonly model: ExploreModel;
  /** Whether what has this symbol can be taken in the scene. */
  readonly movable: (symbol: string) => boolean;
}

/** Explore's scene and graph, and the scene from above, without its controls. */
export function mountExploreStage(host: HTMLElement, dispatch: Dispatch): Mounted<StageModel> {
  const area = (name: string, parent: HTMLElement = host): HTMLElement => {
    const element = document.createElement('div');
    element.className = name;
    parent.append(element);
    return element;
  };
  host.classList.add('explore-stage');
  const scene = lateScene(area('scene-host', area('lesson-scene')), dispatch);
  const above = area('lesson-above');
  const drawn = area('above-drawing', above);
  const caption = document.createElement('p');
  caption.textContent = 'from above';
  above.append(caption);
  const graph = mountGraph(area('graph-host', area('lesson-graph')), dispatch);
  let draw: typeof import('../../canvas/thumbnail.ts').drawThumbnail | null = null;
  let last: ExploreModel | null = null;
  const drawAbove = (): void => {
    if (draw && last) draw(drawn, { ...last.scene, view: 'top' });
  };
  late(() => import('../../canvas/thumbnail.ts')).then(
    (loaded) => {
      draw = loaded.drawThumbnail;
      drawAbove();
    },
    // The scene says that it did not come.
    () => above.remove(),
  );
  return {
    render({ model, movable }) {
      const handles = model.scene.handles.filter(({ symbol }) => movable(symbol));
      scene.render({ ...model.scene, handles });
      graph.render(model.graph);
      if (last !== model) {
        last = model;
        drawAbove();
      }
    },
    dispose() {
      scene.dispose();
      graph.dispose();
    },
  };
}
