import { html, nothing } from 'lit';
import { shortest } from '../text/format.ts';
import {
  hintOn,
  looksLikeTriple,
  parseNumber,
  parseTriple,
  type Triple,
  tripleTexts,
} from '../text/parse.ts';
import { Ahead } from './ahead.ts';
import { DrawnElement, redrawnBy } from './drawn-element.ts';
import { fitting } from './fitting.ts';
import { keyStep, onStep } from './step.ts';
import { themed } from './themed.ts';
import { TypedEvent } from './typed-event.ts';

/**
 * A box for one number, typed exactly: 1/3, sqrt(2), 1e7, −2^−40, 0,5. As many of six digits as fit
 * are shown, with ≈ where they are not all; with the focus, what was typed, or every digit. A text
 * that is not allowed stays in the box with the reason below it, and nothing else changes. Sends
 * `graze-value` with a number, or `graze-triple` when three numbers were pasted or typed, with
 * their texts.
 */
class GrazeNumberBox extends DrawnElement {
  declare value: number;
  declare step: number;
  declare label: string;
  declare symbol: string;
  declare locked: boolean;
  /** The typed text of the value, as from a link; '' if unknown. */
  declare typed: string;
  /** The name in data-quantity; none if another element carries it. */
  declare quantity: string;
  /** Why a number is not allowed here; null if it is. */
  check: (value: number) => string | null = () => null;
  declare private text: string | null;
  declare private reason: string | null;
  declare private focused: boolean;
  /** Width for digits in px; 0 until it is measured. */
  declare private room: number;
  declare private font: string;
  private ahead = new Ahead();
  /** The text typed last and its value; the text is shown while the value is the same. */
  private last: { text: string; value: number } | null = null;

  constructor() {
    super();
    this.value = 0;
    this.step = 0.1;
    this.label = '';
    this.symbol = '';
    this.locked = false;
    this.typed = '';
    this.quantity = '';
    this.text = null;
    this.reason = null;
    this.focused = false;
    this.room = 0;
    this.font = '';
  }

  private readonly observer = new ResizeObserver(() => this.measure());
  private readonly themes = new MutationObserver(() => this.measure());

  override connectedCallback(): void {
    super.connectedCallback();
    void this.redraw().then(() => {
      const input = this.querySelector('input');
      if (input) this.observer.observe(input);
    });
    // A theme may change the font size without changing the size of the box.
    this.themes.observe(themed(this), { attributeFilter: ['data-theme'] });
  }

  disconnectedCallback(): void {
    this.observer.disconnect();
    this.themes.disconnect();
  }

  /** Measures width and font of the box, once for each size. */
  private measure(): void {
    const input = this.querySelector('input');
    if (!input || this.focused) return;
    const style = getComputedStyle(input);
    const padding = Number.parseFloat(style.paddingLeft) + Number.parseFloat(style.paddingRight);
    this.room = input.clientWidth - padding - 1;
    this.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
  }

  override changed(name: string): void {
    // The value was changed elsewhere (a slider, a link): a refused text is dropped.
    if (name === 'value' && this.reason !== null) this.forget();
  }

  protected override template() {
    const reasonId = `${this.id}-reason`;
    const hint = this.focused && this.reason === null ? hintOn(this.written()) : null;
    const described = this.reason !== null || hint !== null;
    return html`<input
        type="text"
        class="number"
        autocomplete="off"
        spellcheck="false"
        enterkeyhint="done"
        ?readonly=${this.locked}
        .value=${this.text ?? this.shown()}
        aria-label=${this.label}
        aria-invalid=${this.reason === null ? 'false' : 'true'}
        aria-describedby=${described ? reasonId : nothing}
        title=${shortest(this.value)}
        data-symbol=${this.symbol}
        data-quantity=${this.quantity || nothing}
        data-value=${this.quantity ? shortest(this.value) : nothing}
        @focus=${this.enter}
        @blur=${this.leave}
        @input=${this.type}
        @change=${this.commit}
        @keydown=${this.key}
        @paste=${this.paste}
      />${
        this.reason === null
          ? nothing
          : html`<span class="reason" id=${reasonId} data-say="problem">${this.reason}</span>`
      }${
        hint === null
          ? nothing
          : html`<span class="reason" id=${reasonId}
        data-say>${hint}</span>`
      }`;
  }

  private shown(): string {
    if (!this.focused) return fitting(this.value, this.room, this.font);
    return this.written() || shortest(this.value);
  }

  /** The text that was typed for the value, here or elsewhere. */
  private written(): string {
    return this.last && Object.is(this.last.value, this.value) ? this.last.text : this.typed;
  }

  private forget(): void {
    this.text = null;
    this.reason = null;
  }

  private enter(event: FocusEvent): void {
    this.focused = true;
    const input = event.target as HTMLInputElement;
    void this.redraw().then(() => input.select());
  }

  private leave(): void {
    this.focused = false;
    if (this.reason === null) this.text = null;
  }

  private type(event: Event): void {
    this.text = (event.target as HTMLInputElement).value;
  }

  private commit(): void {
    const { text } = this;
    if (text === null) return;
    if (looksLikeTriple(text)) {
      const triple = parseTriple(text);
      if (triple.ok) this.sendTriple(triple.value, text);
      else this.reason = triple.reason;
      return;
    }
    const parsed = parseNumber(text);
    this.reason = parsed.ok ? this.check(parsed.value) : parsed.reason;
    if (!parsed.ok || this.reason !== null) return;
    this.last = { text: text.trim(), value: parsed.value };
    this.text = null;
    this.send(parsed.value, [text]);
  }

  private key(event: KeyboardEvent): void {
    if (this.locked || event.altKey || event.ctrlKey || event.metaKey) return;
    if (event.key === 'Enter') this.commit();
    if (event.key === 'Escape') this.forget();
    // Left and right move the caret, not the value.
    const change = /Left|Right/.test(event.key) ? null : keyStep(event, this.step);
    if (change === null) return;
    event.preventDefault();
    const next = onStep(
      this.ahead.of(this.value) + change,
      Math.abs(change) < this.step ? this.step / 10 : this.step,
    );
    this.reason = this.check(next);
    if (this.reason === null) this.text = null;
    if (this.reason === null) this.send(next, []);
  }

  private paste(event: ClipboardEvent): void {
    const text = event.clipboardData?.getData('text') ?? '';
    if (this.locked || !looksLikeTriple(text)) return;
    const triple = parseTriple(text);
    if (!triple.ok) return;
    event.preventDefault();
    this.sendTriple(triple.value, text);
  }

  private sendTriple(triple: Triple, text: string): void {
    this.forget();
    this.dispatchEvent(new TypedEvent('graze-triple', triple, tripleTexts(text) ?? []));
  }

  private send(value: number, texts: readonly string[]): void {
    this.ahead.set(value);
    this.dispatchEvent(new TypedEvent('graze-value', value, texts));
  }
}

const GIVEN = ['value', 'step', 'label', 'symbol', 'locked', 'typed', 'quantity'];
const OWN = ['text', 'reason', 'focused', 'room', 'font'];
customElements.define('graze-number', redrawnBy(GrazeNumberBox, [...GIVEN, ...OWN]));
