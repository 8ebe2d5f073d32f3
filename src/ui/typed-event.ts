/** Event of a value that was set, with the typed texts of its numbers if it was typed. */
export class TypedEvent<Value> extends CustomEvent<Value> {
  readonly texts: readonly string[];

  constructor(type: 'graze-value' | 'graze-triple', detail: Value, texts: readonly string[]) {
    super(type, { detail, bubbles: true });
    this.texts = texts;
  }
}

export const textsOf = (event: Event): readonly string[] =>
  event instanceof TypedEvent ? event.texts : [];
