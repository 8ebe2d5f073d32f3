/**
 * The value that a control has sent but not been given back yet: the next key may come before the page is drawn again, and
 * has to go on from there. After two frames whoever owns the value has taken it or refused it.
 */
export class Ahead {
  private value: number | null = null;
  private count = 0;

  set(value: number): void {
    this.value = value;
    const mine = ++this.count;
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        if (mine === this.count) this.value = null;
      }),
    );
  }

  /** Where the control is, given what the page last told it. */
  of(told: number): number {
    return this.value ?? told;
  }
}
