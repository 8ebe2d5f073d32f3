import { nothing, render } from 'lit';
import type { TreeModel, TreeTools } from '../../canvas/ray-tree.ts';
import { lazy, notLoaded } from '../../ui/lazy.ts';
import type { Mounted } from '../../ui/mounted.ts';

/**
 * The view in space, whose code is loaded with the first pixel that is chosen. The list stands
 * without it.
 */
interface LazyRayTree {
  /** Null removes the view. */
  render(model: TreeModel | null): void;
}

export function lazyRayTree(host: HTMLElement, tools: TreeTools): LazyRayTree {
  let model: TreeModel | null = null;
  let mounted: Mounted<TreeModel> | null = null;
  let asked = false;
  const load = (): void => {
    asked = true;
    render(nothing, host);
    lazy(() => import('../../canvas/ray-tree.ts')).then(
      ({ mountTree }) => {
        mounted = mountTree(host, tools);
        if (model) mounted.render(model);
      },
      () => {
        const words = 'The view in space could not be loaded. The list has every ray.';
        render(notLoaded(words, load), host);
      },
    );
  };
  return {
    render(next) {
      model = next;
      host.hidden = next === null;
      if (next && !asked) load();
      if (next) mounted?.render(next);
    },
  };
}
