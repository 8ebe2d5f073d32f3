/** The multiple of `step` nearest to x, without rounding errors such as 0.30000000000000004. */
export function onStep(x: number, step: number): number {
  return Number((Math.round(x / step) * step).toPrecision(12)) + 0;
}

/**
 * The change of a value by a key: arrows one step, with Shift a tenth, Page keys ten; else null.
 */
export function keyStep(event: KeyboardEvent, step: number): number | null {
  const size = event.shiftKey ? step / 10 : step;
  switch (event.key) {
    case 'ArrowRight':
    case 'ArrowUp':
      return size;
    case 'ArrowLeft':
    case 'ArrowDown':
      return -size;
    case 'PageUp':
      return 10 * size;
    case 'PageDown':
      return -10 * size;
    default:
      return null;
  }
}
