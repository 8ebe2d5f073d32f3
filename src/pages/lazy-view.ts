import { html, nothing, render } from 'lit';
import { notLoaded } from '../ui/lazy.ts';
import type { Mounted } from '../ui/mounted.ts';

/** ms after which the page says that something is being loaded. */
const PATIENCE_MS = 300;

interface LazyView<Model, View> extends Mounted<Model> {
  /** Null until it has been loaded. */
  view(): View | null;
}

/**
 * A view whose code is a chunk of its own; the rest of the page works before and without it. `load`
 * loads it by `late`; `waiting` is shown while it loads, `failed` if it cannot be loaded.
 */
export function lazyView<Model, Code, View extends Mounted<Model>>(
  host: HTMLElement,
  load: () => Promise<Code>,
  mount: (code: Code) => View,
  { waiting, failed }: { readonly waiting: string; readonly failed: string },
): LazyView<Model, View> {
  let model: Model | null = null;
  let view: View | null = null;
  let disposed = false;
  const notice = document.createElement('div');
  notice.className = 'view-waiting';
  const begin = (): void => {
    host.append(notice);
    render(nothing, notice);
    const timer = setTimeout(() => render(html`<p data-say>${waiting}</p>`, notice), PATIENCE_MS);
    load().then(
      (loaded) => {
        clearTimeout(timer);
        notice.remove();
        if (disposed) return;
        view = mount(loaded);
        if (model) view.render(model);
      },
      () => {
        clearTimeout(timer);
        render(notLoaded(failed, begin), notice);
      },
    );
  };
  begin();
  return {
    render(next) {
      model = next;
      view?.render(next);
    },
    view: () => view,
    dispose() {
      disposed = true;
      view?.dispose();
    },
  };
}
