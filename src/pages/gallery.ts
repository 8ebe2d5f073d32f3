import { html, nothing, type TemplateResult } from 'lit';
import { ref } from 'lit/directives/ref.js';
import { SHAPES } from '../math/index.ts';
import { READY_MAPS } from '../state/accuracy/ready-maps.ts';
import { createDerive } from '../state/derive.ts';
import type { ShownExample } from '../state/example.ts';
import { exploreDetails } from '../state/explore-details.ts';
import type { Example } from '../state/gallery/define.ts';
import { GALLERY } from '../state/gallery/index.ts';
import type { SceneModel } from '../state/scene-model.ts';
import { decode } from '../state/url.ts';
import './gallery.css';

/** Draws a small picture of a scene into an element. */
export type Thumbnail = (host: HTMLElement, model: SceneModel) => void;

/** Every example with a small picture and its question, shape by shape. */
export function galleryContent(
  current: ShownExample | null,
  pick: (id: string) => void,
  thumbnail: Thumbnail | null,
  hidden: boolean,
  leave: () => void,
  present: () => void,
): TemplateResult {
  return html`<div class="gallery">
    <p>New to this? <a href="#/lesson/ray" @click=${leave}>Begin with the first lesson.</a>
      To show them to others:
      <button type="button" class="gallery-present" title="All values, what comes next (Shift+P)"
        @click=${present}>presenter’s window</button></p>
    <div role="group" aria-label="Examples">${SHAPES.map(({ kind, title }) => {
      const own = GALLERY.filter(({ link }) => decode(link).kind === kind);
      return html`<section aria-label=${title}>
        <h3>${title}</h3>
        <div class="gallery-cards">${own.map((example) =>
          card(example, current?.entry === example ? current : null, pick, thumbnail, hidden),
        )}</div>
      </section>`;
    })}</div>
    <section aria-label="Maps">
      <h3>Maps of where formulas fail</h3>
      <ul class="gallery-maps">${READY_MAPS.map(
        ({ id, title, sentence, link }) =>
          html`<li><a href=${link} data-map=${id} @click=${leave}>${title}</a>
            <span class="gallery-look">${sentence}</span></li>`,
      )}</ul>
    </section>
  </div>`;
}

function card(
  example: Example,
  current: ShownExample | null,
  pick: (id: string) => void,
  thumbnail: Thumbnail | null,
  hidden: boolean,
): TemplateResult {
  const draw = (element: Element | undefined): void => {
    if (element instanceof HTMLElement && thumbnail && element.childElementCount === 0) {
      thumbnail(element, {
        ...createDerive(() => exploreDetails)({
          ...decode(example.link),
          revealed: hidden ? 0 : null,
        }).scene,
        handles: [],
      });
    }
  };
  return html`<button
    type="button"
    class="gallery-card"
    data-example=${hidden ? nothing : example.id}
    aria-pressed=${current !== null && !current.changed}
    @click=${() => pick(example.id)}
  >
    <span class="thumbnail" aria-hidden="true" ${ref(draw)}></span>
    <strong>${hidden ? `example ${GALLERY.indexOf(example) + 1}` : example.title}</strong>
    ${
      current?.changed
        ? html`<span
      class="gallery-look">Changed since: choosing it brings it back.</span>`
        : nothing
    }
    <span class="gallery-look">${hidden ? '' : example.asks}</span>
  </button>`;
}
