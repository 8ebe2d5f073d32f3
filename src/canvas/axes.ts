import { italic } from './captions.ts';
import type { Layer } from './layer.ts';
import type { Lens } from './lens.ts';

const ARM = 32;
const ORIGIN = { x: 44, y: 44 };
/** Shorter arms point at the eye: the letter then stands beside the origin. */
const SHORT = 5;

/** The three axes as a small cross at the lower left, turned like the scene. */
export function drawAxes(layer: Layer, lens: Lens, scale: number, font: number): void {
  const [x, y] = [ORIGIN.x * scale, lens.height - ORIGIN.y * scale];
  layer.begin();
  for (const [name, direction] of [
    ['x', [1, 0, 0]],
    ['y', [0, 1, 0]],
    ['z', [0, 0, 1]],
  ] as const) {
    const [dx, dy] = lens.onScreen(direction).map((part) => part * ARM * scale) as [number, number];
    const length = Math.hypot(dx, dy);
    layer.show(`${name} arm`, 'path', {
      d: `M${x.toFixed(2)} ${y.toFixed(2)}l${dx.toFixed(2)} ${dy.toFixed(2)}`,
      'stroke-width': 1.5 * scale,
    });
    const [ux, uy] =
      length > SHORT * scale ? [dx / length, dy / length] : [-Math.SQRT1_2, Math.SQRT1_2];
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
