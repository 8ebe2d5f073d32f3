import { html, render } from 'lit';

/**
 * <graze-play label="E.x">: a button that asks to play one number, by the event `graze-play` with
 * its label. `playing` turns it into one that stops.
 */
class GrazePlay extends HTMLElement {
  /** The same element stands beside another number when the shape changes. */
  static readonly observedAttributes = ['label'];
  #playing = false;

  get label(): string {
    return this.getAttribute('label') ?? '';
  }

  get playing(): boolean {
    return this.#playing;
  }

  set playing(on: boolean) {
    if (on === this.#playing) return;
    this.#playing = on;
    this.#draw();
  }

  connectedCallback(): void {
    this.#draw();
  }

  attributeChangedCallback(): void {
    if (this.isConnected) this.#draw();
  }

  #draw(): void {
    const { label } = this;
    const title = this.#playing ? `Stop ${label} here` : `Play ${label} there and back`;
    const path = this.#playing ? 'M1 1H9V9H1Z' : 'M1.5 0.5L9.5 5L1.5 9.5Z';
    render(
      html`<button type="button" class="play-number" aria-label=${`Play ${label}`} title=${title}
        aria-pressed=${this.#playing} @click=${this.#ask}><svg viewBox="0 0 10 10" width="8"
        height="8" aria-hidden="true"><path d=${path} /></svg></button>`,
      this,
    );
  }

  #ask = (): void => {
    const { label } = this;
    this.dispatchEvent(new CustomEvent<string>('graze-play', { detail: label, bubbles: true }));
  };
}

customElements.define('graze-play', GrazePlay);
