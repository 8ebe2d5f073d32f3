import { coordinate } from '../text/coordinate.ts';

const SVG = 'http://www.w3.org/2000/svg';

export type Attributes = Readonly<Record<string, string | number>>;

/** An element of a template: tag and fixed attributes. */
export type Part = readonly [tag: string, attributes: Attributes];

interface Entry {
  readonly element: SVGElement;
  readonly written: Map<string, string>;
  used: boolean;
}

/**
 * Keyed SVG elements in a <g>. Each frame names the elements it shows; others are removed. An
 * element with the same key is kept from frame to frame, with its focus or drag, and only changed
 * attributes are written.
 */
export class Layer {
  readonly root: SVGElement;
  readonly #entries = new Map<string, Entry>();

  constructor(parent: Element, name: string) {
    this.root = document.createElementNS(SVG, 'g');
    this.root.setAttribute('class', name);
    parent.append(this.root);
  }

  begin(): void {
    for (const entry of this.#entries.values()) entry.used = false;
  }

  /** @param parts children of a new element; to change them use another key. */
  show(key: string, tag: string, attributes: Attributes, parts: readonly Part[] = []): SVGElement {
    let entry = this.#entries.get(key);
    if (!entry) {
      entry = { element: create(tag), written: new Map(), used: true };
      for (const [partTag, fixed] of parts) {
        const part = create(partTag);
        for (const [name, value] of Object.entries(fixed)) part.setAttribute(name, String(value));
        entry.element.append(part);
      }
      this.#entries.set(key, entry);
      this.root.append(entry.element);
    }
    entry.used = true;
    for (const name in attributes) {
      const value = text(attributes[name] as string | number);
      if (entry.written.get(name) === value) continue;
      entry.written.set(name, value);
      entry.element.setAttribute(name, value);
    }
    return entry.element;
  }

  end(): void {
    for (const [key, entry] of this.#entries) {
      if (entry.used) continue;
      entry.element.remove();
      this.#entries.delete(key);
    }
  }
}

function create(tag: string): SVGElement {
  return document.createElementNS(SVG, tag);
}

/** An attribute's text; numbers are rounded to hundredths of a px, and never NaN. */
export function text(value: string | number): string {
  if (typeof value === 'string') return value;
  return String(coordinate(value));
}
