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

  /** What was sent is not to be gone on from. */
  forget(): void {
    this.value = null;
  }

  /** Where the control is, given what the page last told it. */
  of(told: T): T {
    return this.value ?? told;
  }
}
