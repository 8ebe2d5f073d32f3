import { mountGraph } from '../../charts/graph.ts';
import type { Vec3 } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import type { Dispatch } from '../../state/actions.ts';
import type { FullModel } from '../../state/derive.ts';
import { late } from '../../ui/late.ts';
import type { Mounted } from '../../ui/mounted.ts';
import { lateScene } from '../late-scene.ts';

interface StageModel {
  readonly model: FullModel;
  /** Whether what has this symbol can be taken in the scene. */
  readonly movable: (symbol: string) => boolean;
  /** Normals are drawn where the text speaks of them: there is little room for arrows. */
  readonly normals: boolean;
}

/** Width in CSS pixels from which the scene from above is no inset. */
const LARGE = 200;

/** E, where the ray meets the shape, and the shape around its middle. */
function toBeSeen({ shape, ray, scene }: FullModel): Vec3[] {
  const { at, size } = definitionOf(shape).anchor(shape);
  const hits = scene.hits.filter(({ drawn }) => drawn).map(({ point }) => point);
  const around = [-size, size].flatMap((by): Vec3[] => [
    [at[0] + by, at[1], at[2]],
    [at[0], at[1], at[2] + by],
  ]);
  return [...(scene.ray.originDrawn ? [ray.origin] : []), ...hits, ...around];
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
  let code: typeof import('../../canvas/thumbnail.ts') | null = null;
  let last: FullModel | null = null;
  const drawAbove = (): void => {
    const { clientWidth: width, clientHeight: height } = drawn;
    if (!code || !last || width === 0 || height === 0) return;
    const size = { width, height, scale: width < LARGE ? 0.6 : 0.8 };
    code.drawAbove(drawn, last.scene, size, toBeSeen(last));
  };
  const resized = new ResizeObserver(drawAbove);
  resized.observe(drawn);
  late(() => import('../../canvas/thumbnail.ts')).then(
    (loaded) => {
      code = loaded;
      drawAbove();
    },
    // The scene says that it did not come.
    () => above.remove(),
  );
  return {
    render({ model, movable, normals }) {
      const handles = model.scene.handles.filter(({ symbol }) => movable(symbol));
      const hits = model.scene.hits.map((hit) => (normals ? hit : { ...hit, normal: null }));
      scene.render({ ...model.scene, handles, hits });
      graph.render(model.graph);
      if (last !== model) {
        last = model;
        drawAbove();
      }
    },
    dispose() {
      resized.disconnect();
      scene.dispose();
      graph.dispose();
    },
  };
}
