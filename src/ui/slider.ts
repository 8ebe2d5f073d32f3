import { html } from 'lit';
import { live } from 'lit/directives/live.js';
import { display } from '../text/format.ts';
import { Ahead } from './ahead.ts';
import { DrawnElement, redrawnBy } from './drawn-element.ts';
import { keyStep, onStep } from './step.ts';

/**
 * A native range input that may be told a value beyond its ends (it rests there), moves on a step
 * without forcing a value onto it that was typed, and takes fine steps with Shift. Sends
 * `graze-value` with the new number.
 */
class GrazeSlider extends DrawnElement {
  declare value: number;
  declare least: number;
  declare most: number;
  declare step: number;
  declare label: string;
  declare symbol: string;
  declare locked: boolean;
  private ahead = new Ahead();

  constructor() {
    super();
    this.value = 0;
    this.least = 0;
    this.most = 1;
    this.step = 0.1;
    this.label = '';
    this.symbol = '';
    this.locked = false;
  }

  protected override template() {
    return html`<input
      type="range"
      class="slider"
      min=${this.least}
      max=${this.most}
      step="any"
      .value=${live(String(this.value))}
      aria-label=${this.label}
      aria-valuetext=${display(this.value)}
      ?disabled=${this.locked}
      data-symbol=${this.symbol}
      @input=${this.slide}
      @keydown=${this.key}
    />`;
  }

  protected override drawn(): void {
    const input = this.querySelector('input');
    const { least, most } = this;
    const share = (x: number): string =>
      `${(100 * (Math.min(Math.max(x, least), most) - least)) / (most - least)}%`;
    const zero = share(0);
    const here = share(this.value);
    // The strict content security policy forbids style attributes, but not the style object.
    input?.style.setProperty('--zero', zero);
    input?.style.setProperty('--fill-from', this.value < 0 ? here : zero);
    input?.style.setProperty('--fill-to', this.value < 0 ? zero : here);
  }

  private slide(event: Event): void {
    const input = event.target as HTMLInputElement;
    this.send(onStep(Number(input.value), this.step));
  }

  private key(event: KeyboardEvent): void {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const change = keyStep(event, this.step);
    if (change === null) return;
    event.preventDefault();
    const next = onStep(
      this.ahead.of(this.value) + change,
      Math.abs(change) < this.step ? this.step / 10 : this.step,
    );
    this.send(Math.min(Math.max(next, this.least), this.most));
  }

  private send(value: number): void {
    this.ahead.set(value);
    this.dispatchEvent(new CustomEvent<number>('graze-value', { detail: value, bubbles: true }));
    // After a refused value the thumb goes back to the state's value.
    void this.redraw();
  }
}

const PROPERTIES = ['value', 'least', 'most', 'step', 'label', 'symbol', 'locked'];
customElements.define('graze-slider', redrawnBy(GrazeSlider, PROPERTIES));
