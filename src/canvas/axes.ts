import { coordinate } from '../text/coordinate.ts';
import { italic } from './captions.ts';
import type { Layer } from './layer.ts';
import type { Projection } from './projection.ts';

const ARM = 32;
/** Least distance in px of the cross from the lower left corner; letters need room as well. */
const ORIGIN = 44;
const LETTER = 24;
/** Arms shorter than this in px point at the eye: their letter is drawn beside the origin. */
const SHORT = 5;

const AXES = [
  ['x', [1, 0, 0]],
  ['y', [0, 1, 0]],
  ['z', [0, 0, 1]],
] as const;

/** Draws the three axes as a small cross at the lower left, turned like the scene. */
export function drawAxes(layer: Layer, projection: Projection, scale: number, font: number): void {
  const arms = AXES.map(([name, direction]) => {
    const [x, y] = projection.onScreen(direction);
    return { name, dx: x * ARM * scale, dy: y * ARM * scale };
  });
  const room = (extent: number) => Math.max(ORIGIN * scale, extent + LETTER * scale);
  const x = room(-Math.min(...arms.map(({ dx }) => dx)));
  const y = projection.height - room(Math.max(...arms.map(({ dy }) => dy)));
  layer.begin();
  for (const { name, dx, dy } of arms) {
    const length = Math.hypot(dx, dy);
    layer.show(`${name} arm`, 'path', {
      d: `M${coordinate(x)} ${coordinate(y)}l${coordinate(dx)} ${coordinate(dy)}`,
      'stroke-width': 1.5 * scale,
    });
    const isShort = length < SHORT * scale;
    const [ux, uy] = isShort ? [-Math.SQRT1_2, Math.SQRT1_2] : [dx / length, dy / length];
    const reach = Math.max(length, 2) + 0.45 * font;
    const letter = layer.show(name, 'text', {
      x: x + ux * reach,
      y: y + uy * reach + 0.22 * font,
      'font-size': font,
    });
    letter.textContent ||= italic(name);
  }
  layer.end();
}
