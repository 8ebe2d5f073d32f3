/**
 * The value that a control has sent and that is not drawn yet, so that a next key can continue from
 * it. After two frames the value has been accepted or refused, and is forgotten.
 */
export class Ahead<T = number> {
  private value: T | null = null;
  private count = 0;

  set(value: T): void {
    this.value = value;
    const mine = ++this.count;
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        if (mine === this.count) this.value = null;
      }),
    );
  }

  /** Forgets the value that was sent, so that the next key starts from what the page shows. */
  forget(): void {
    this.value = null;
  }

  /** The value to continue from: the one sent last, else the one that the page shows. */
  of(told: T): T {
    return this.value ?? told;
  }
}
