import { GrazeRay } from './embed/graze-ray.ts';
import { type AnyModel, rendered } from './embed/widget.ts';

// Another copy on the page may have come first: its elements are the same.
if (!customElements.get('graze-ray')) {
  customElements.define('graze-ray', GrazeRay);
  // In a shadow tree a font is not declared by a style sheet. Where the host's policy forbids it,
  // formulas are in the reader's own mathematical font.
  const url = new URL('./ui/fonts/stix-two-math-subset.woff2', import.meta.url);
  const face = new FontFace('STIX Two Math', `url("${url.href}")`);
  document.fonts.add(face);
}

/** The convention of anywidget: a notebook's cell as a view of a model. */
export function render({ model, el }: { model: AnyModel; el: HTMLElement }): () => void {
  return rendered(model, el);
}

export default { render };
