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
 * Keyed SVG elements in one <g>. Each frame asks for the elements it shows, by key; what is not
 * asked for goes away. An element keeps its identity from frame to frame (a focus or a drag on it
 * survives), and only attributes that changed are written.
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

  /** `parts` fill a new element, once; their change needs another key. */
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

/** Hundredths of a pixel are enough, and NaN never becomes an attribute. */
export function text(value: string | number): string {
  if (typeof value === 'string') return value;
  return String(coordinate(value));
}
