import { mountEmbed } from '../pages/embed/embed-view.ts';
import { leaveKeys } from '../pages/embed/host-keys.ts';
import { announcement } from '../state/announce.ts';
import { createDerive, type FullModel } from '../state/derive.ts';
import { exploreDetails } from '../state/explore-details.ts';
import { type Answer, answerOf, opened } from '../state/host-messages.ts';
import { INITIAL } from '../state/state.ts';
import { createStore, type Store } from '../state/store.ts';
import { decode } from '../state/url.ts';
import { createAnnouncer } from '../ui/announcer.ts';
import { watchGestures } from '../ui/gesture.ts';
import { watchHighlight } from '../ui/highlight.ts';
import type { Mounted } from '../ui/mounted.ts';
import { watchTheme } from '../ui/theme.ts';
import { ATTRIBUTES, withAttributes } from './attributes.ts';
import { sheets } from './styles.ts';

/** What stands in the shadow tree while the element is in a document. */
interface Shown {
  readonly view: Mounted<FullModel>;
  readonly stops: readonly (() => void)[];
}

/**
 * `<graze-ray shape="cone" E="3,1,1" d="-.8,-.2,-.3" show="scene,graph" lock="c">`: a ray and a
 * shape in any page. Attributes are the keys of Graze's links, and `show` the parts; they may
 * change at any time. `state` is the link's query, to read and to set. `change` tells of a new
 * state: detail.state, detail.class, detail.t. `home` is the address that the mark "Graze" leads
 * to; without it the folder above this module's, where a site has it.
 *
 * @example
 * const ray = document.querySelector('graze-ray');
 * ray.addEventListener('change', ({ detail }) => console.log(detail.class, detail.t));
 * ray.state = 'shape=sphere&C=0,1,0&r=2';
 */
export class GrazeRay extends HTMLElement {
  static readonly observedAttributes = [...ATTRIBUTES, 'home'];

  readonly #derive = createDerive(() => exploreDetails);
  #store: Store | null = null;
  #shown: Shown | null = null;
  #model: FullModel | null = null;
  #told = '';
  #frame = 0;
  /** Attributes that were changed in this task. */
  readonly #pending = new Set<string>();
  #announce: (words: string) => void = () => {};
  #root: HTMLElement | null = null;

  get state(): string {
    this.#take();
    return this.#answer().state;
  }

  set state(query: string) {
    this.#take();
    const link = `#/explore?${String(query).replace(/^#?(\/explore)?\??/, '')}`;
    this.#stored().dispatch({ type: 'open', state: (now) => opened(link, now) });
  }

  attributeChangedCallback(name: string): void {
    if (name === 'home') return;
    if (this.#pending.size === 0) queueMicrotask(() => this.#take());
    this.#pending.add(name);
  }

  connectedCallback(): void {
    if (this.#shown) return;
    this.#take();
    const store = this.#stored();
    const root = this.#placed();
    const theme = watchTheme(this, () => this.#ask());
    theme.ask(store.get().theme);
    this.#shown = {
      view: mountEmbed(root, store.dispatch, this.#home()),
      stops: [
        store.subscribe(({ theme: asked }) => {
          theme.ask(asked);
          this.#ask();
        }),
        watchHighlight(root),
        // As if Graze were not there: they go on from the element itself.
        leaveKeys(root, (event) => {
          if (!this.dispatchEvent(new KeyboardEvent(event.type, event))) event.preventDefault();
        }),
      ],
    };
    this.#ask();
  }

  disconnectedCallback(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    for (const stop of this.#shown?.stops ?? []) stop();
    this.#shown?.view.dispose();
    this.#shown = null;
  }

  /** Where the parts stand; made when the element first comes into a document. */
  #placed(): HTMLElement {
    if (this.#root) return this.#root;
    const shadow = this.attachShadow({ mode: 'open' });
    shadow.adoptedStyleSheets = sheets();
    const root = document.createElement('div');
    root.className = 'embed-root';
    shadow.append(root);
    this.#announce = createAnnouncer(shadow as unknown as HTMLElement);
    this.#root = root;
    return root;
  }

  #stored(): Store {
    this.#store ??= createStore(decode('#/explore?shape=cone', INITIAL), watchGestures(this));
    return this.#store;
  }

  /** The changed attributes put into the state. */
  #take(): void {
    if (this.#pending.size === 0) return;
    const given = new Map([...this.#pending].map((name) => [name, this.getAttribute(name)]));
    this.#pending.clear();
    this.#stored().dispatch({ type: 'open', state: (now) => withAttributes(now, given) });
  }

  #home(): string | null {
    const given = this.getAttribute('home');
    const own = import.meta.url;
    if (given !== null) {
      const { protocol, href } = new URL(given, document.baseURI);
      return /^(?:https?|file):$/.test(protocol) ? href.replace(/#.*$/, '') : null;
    }
    return /^https?:.*\/embed\/graze\.js/.test(own) ? new URL('../', own).href : null;
  }

  #answer(): Answer {
    const state = this.#stored().get();
    return answerOf({ ...state, embed: null, lock: [], theme: null }, this.#derive(state));
  }

  #ask(): void {
    this.#frame ||= requestAnimationFrame(() => this.#draw());
  }

  #draw(): void {
    this.#frame = 0;
    if (!this.#shown) return;
    const before = this.#model;
    this.#model = this.#derive(this.#stored().get());
    this.#shown.view.render(this.#model);
    if (before && before !== this.#model) {
      const words = announcement(before, this.#model);
      if (words) this.#announce(words);
    }
    const detail = this.#answer();
    const told = JSON.stringify(detail);
    if (this.#told !== '' && told !== this.#told) {
      this.dispatchEvent(new CustomEvent('change', { detail }));
    }
    this.#told = told;
  }
}
