import { render, type TemplateResult } from 'lit/html.js';

/**
 * A custom element without a shadow root that draws itself anew after a property of it was set to
 * another value: once for all changes of a task, before the browser paints.
 */
export abstract class DrawnElement extends HTMLElement {
  private next: Promise<void> | null = null;

  connectedCallback(): void {
    void this.redraw();
  }

  /** Fulfilled when it has been drawn. */
  redraw(): Promise<void> {
    this.next ??= Promise.resolve().then(() => {
      this.next = null;
      if (!this.isConnected) return;
      render(this.template(), this, { host: this });
      this.drawn();
    });
    return this.next;
  }

  protected abstract template(): TemplateResult;

  /** Called when a property has got another value. */
  changed(_name: string): void {}

  /** Called each time that it has been drawn. */
  protected drawn(): void {}
}

/** The class, once these properties of it redraw its elements; to be called once. */
export function redrawnBy<T extends { readonly prototype: DrawnElement }>(
  type: T,
  names: readonly string[],
): T {
  for (const name of names) {
    const values = new WeakMap<DrawnElement, unknown>();
    Object.defineProperty(type.prototype, name, {
      get(this: DrawnElement) {
        return values.get(this);
      },
      set(this: DrawnElement, value: unknown) {
        if (values.has(this) && Object.is(values.get(this), value)) return;
        values.set(this, value);
        this.changed(name);
        void this.redraw();
      },
    });
  }
  return type;
}
