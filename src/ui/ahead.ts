/**
 * The value that a control has sent but not been given back yet: the next key may come before the
 * page is drawn again, and has to go on from there. After two frames whoever owns the value has
 * taken it or refused it.
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

  /** The value to go on from: the one that was sent last, else the one that the page shows. */
  of(told: T): T {
    return this.value ?? told;
  }
}
