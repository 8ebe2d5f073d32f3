import type { GrazeRay } from './graze-ray.ts';

/** What a notebook gives: values under names, kept in step with the kernel. */
export interface AnyModel {
  get(name: string): unknown;
  set(name: string, value: unknown): void;
  save_changes(): void;
  on(event: string, listener: () => void): void;
  off(event: string, listener: () => void): void;
}

/** Values that the element takes as attributes, where the model has them. */
const ATTRIBUTES = ['show', 'lock', 'hide', 'theme', 'home'];

/**
 * A <graze-ray> in `el`. The model's `state` is the link's query, both ways; `class` and `t` are
 * what was found. Returns what takes it away.
 */
export function rendered(model: AnyModel, el: HTMLElement): () => void {
  const ray = document.createElement('graze-ray') as GrazeRay;
  for (const name of ATTRIBUTES) {
    const value = model.get(name);
    if (typeof value === 'string') ray.setAttribute(name, value);
  }
  const take = (): void => {
    const state = model.get('state');
    if (typeof state === 'string' && state !== ray.state) ray.state = state;
  };
  const give = (event: Event): void => {
    const { detail } = event as CustomEvent<Readonly<Record<string, unknown>>>;
    for (const name of ['state', 'class', 't']) model.set(name, detail[name]);
    model.save_changes();
  };
  take();
  model.on('change:state', take);
  ray.addEventListener('change', give);
  el.append(ray);
  return () => {
    model.off('change:state', take);
    ray.remove();
  };
}
