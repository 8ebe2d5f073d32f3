import { mountGraph } from '../../charts/graph.ts';
import type { Vec3 } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import type { Dispatch } from '../../state/actions.ts';
import type { FullModel } from '../../state/derive.ts';
import { lazy } from '../../ui/lazy.ts';
import type { Mounted } from '../../ui/mounted.ts';
import { lazyScene } from '../lazy-scene.ts';

interface ExplorePartModel {
  readonly model: FullModel;
  /** Whether the handle of this symbol can be dragged. */
  readonly movable: (symbol: string) => boolean;
  /** Whether normals are drawn: only if the text mentions them, since there is little room. */
  readonly normals: boolean;
}

/** Least width in CSS pixels of a drawing from above that stands beside the scene, not in it. */
const LARGE = 200;

/** Points that must be in the frame: E, the hits, and points of the shape around its anchor. */
function toBeSeen({ shape, ray, scene }: FullModel): Vec3[] {
  const { at, size } = definitionOf(shape).anchor(shape);
  const hits = scene.hits.filter(({ drawn }) => drawn).map(({ point }) => point);
  const around = [-size, size].flatMap((by): Vec3[] => [
    [at[0] + by, at[1], at[2]],
    [at[0], at[1], at[2] + by],
  ]);
  return [...(scene.ray.originDrawn ? [ray.origin] : []), ...hits, ...around];
}

/** Explore's scene and graph for a lesson, with a drawing from above, without controls. */
export function mountExplorePart(host: HTMLElement, dispatch: Dispatch): Mounted<ExplorePartModel> {
  const area = (name: string, parent: HTMLElement = host): HTMLElement => {
    const element = document.createElement('div');
    element.className = name;
    parent.append(element);
    return element;
  };
  host.classList.add('explore-stage');
  const scene = lazyScene(area('scene-host', area('lesson-scene')), dispatch);
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
  lazy(() => import('../../canvas/thumbnail.ts')).then(
    (loaded) => {
      code = loaded;
      drawAbove();
    },
    // The scene itself shows that its code could not be loaded.
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
