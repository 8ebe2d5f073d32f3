/**
 * A value that was set, with the texts that were typed for its numbers; none where it was set in
 * another way.
 */
export class TypedEvent<Value> extends CustomEvent<Value> {
  readonly texts: readonly string[];

  constructor(type: 'graze-value' | 'graze-triple', detail: Value, texts: readonly string[]) {
    super(type, { detail, bubbles: true });
    this.texts = texts;
  }
}

export const textsOf = (event: Event): readonly string[] =>
  event instanceof TypedEvent ? event.texts : [];
