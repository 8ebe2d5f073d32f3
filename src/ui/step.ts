/**
 * The multiple of `step` nearest to x, freed of the noise that the multiplication brings
 * (0.30000000000000004).
 */
export function onStep(x: number, step: number): number {
  return Number((Math.round(x / step) * step).toPrecision(12)) + 0;
}

/**
 * What a key does to a value on a scale of this step, or null: arrows a step, Shift a tenth, Page
 * keys ten.
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
