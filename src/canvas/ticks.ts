import type { SceneModel } from '../state/scene-model.ts';
import { coordinate } from '../text/coordinate.ts';
import { display } from '../text/format.ts';
import { type Box, overlap } from './labels.ts';
import type { Layer } from './layer.ts';
import { heading, isInside } from './off-screen-pointer.ts';
import type { Projection } from './projection.ts';
import { pointAt } from './ray.ts';
import type { StageUnits } from './stage-units.ts';

/** Half the length of a tick, and the distance of its number below the ray, in px at scale 1. */
const HALF = 6;
const BELOW = 18;
const FONT = 12.5;
/**
 * Distance in tick steps from roots, E, the tip of d, and the bead within which no number is put.
 */
const NEAR_ROOT = 0.6;
const NEAR_BEAD = 0.25;
/** Least digits of a number; more if neighbouring ones would be the same. */
const LEAST_DIGITS = 4;
const MOST_DIGITS = 12;

interface Ticks {
  /** Path data. */
  readonly strokes: string;
  readonly numbers: readonly { readonly label: string; readonly box: Box }[];
}

/** Ticks across the ray at round t, with numbers if there is room. */
export function ticksOn(
  model: SceneModel,
  units: StageUnits,
  projection: Projection,
  scale: number,
  taken: readonly Box[],
): Ticks {
  const { ray } = model;
  const numbers: { label: string; box: Box }[] = [];
  const step = smallestStep(ray.ticks);
  const roots = [0, 1, ...model.hits.map((hit) => hit.t)];
  const boxes = [...taken];
  let strokes = '';
  for (const t of ray.ticks) {
    const place = Math.abs(t) > step / 4 ? pointAt(ray, t, units) : null;
    const spot = place && projection.project(place);
    const course = place && heading(place, ray.direction, projection);
    if (!spot || !course || !isInside(spot, projection)) continue;
    const [nx, ny] = course[0] >= 0 ? [-course[1], course[0]] : [course[1], -course[0]];
    const half = HALF * scale;
    // No tick at t = 1, the tip of d.
    if (t !== 1) {
      const [x, y] = [half * nx, half * ny];
      strokes += `M${pair(spot.x - x, spot.y - y)}L${pair(spot.x + x, spot.y + y)}`;
    }
    const isNear = (s: number, steps: number) => Math.abs(t - s) < steps * step;
    if (roots.some((root) => isNear(root, NEAR_ROOT))) continue;
    if (model.bead && isNear(model.bead.t, NEAR_BEAD)) continue;
    const digits = Math.ceil(Math.log10(Math.abs(t) / step)) + 2;
    const label = display(t, Math.min(Math.max(digits, LEAST_DIGITS), MOST_DIGITS));
    const box = {
      x: spot.x + BELOW * scale * nx,
      y: spot.y + BELOW * scale * ny,
      w: (0.62 * label.length + 0.5) * FONT * scale,
      h: FONT * scale,
    };
    const isWhole =
      isInside({ x: box.x - box.w / 2, y: box.y - box.h / 2 }, projection) &&
      isInside({ x: box.x + box.w / 2, y: box.y + box.h / 2 }, projection);
    if (!isWhole || boxes.some((other) => overlap(box, other) > 0)) continue;
    boxes.push(box);
    numbers.push({ label, box });
  }
  return { strokes, numbers };
}

export function drawTicks(layer: Layer, { strokes, numbers }: Ticks, scale: number): void {
  layer.begin();
  for (const { label, box } of numbers) {
    const attributes = { class: 'scene-number', x: box.x, y: box.y + 0.36 * FONT * scale };
    layer.show(`t ${label}`, 'text', attributes).textContent = label;
  }
  if (strokes)
    layer.show('strokes', 'path', { class: 'scene-ticks', d: strokes, 'stroke-width': 2 * scale });
  layer.end();
}

function smallestStep(ticks: readonly number[]): number {
  let step = Infinity;
  for (let k = 1; k < ticks.length; k++) {
    step = Math.min(step, Math.abs((ticks[k] ?? 0) - (ticks[k - 1] ?? 0)));
  }
  return step < Infinity ? step : Math.abs(ticks[0] ?? 1);
}

function pair(x: number, y: number): string {
  return `${coordinate(x)} ${coordinate(y)}`;
}
