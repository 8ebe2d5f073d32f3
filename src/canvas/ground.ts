import { roundStep } from '../math/drawing.ts';
import type { StageUnits } from './stage-units.ts';
import { smoothstep } from './stage-units.ts';
import type { Stroke } from './stroke.ts';

/** Radius of the grid in stage radii, and the share of it within which lines do not fade. */
const REACH = 1.7;
const CLEAR = 0.45;
const PIECES = 24;
/** Most lines to each side of the middle. */
const MOST_LINES = 60;

/**
 * The ground grid, in stage units: lines at whole multiples of a round world step, fading into the
 * background.
 */
export function ground(units: StageUnits): Stroke[] {
  const { center, radius } = units.stage;
  const step = roundStep(radius / 5);
  const strokes: Stroke[] = [];
  const y = units.ground;
  if (!(Math.abs(y) < REACH)) return strokes;
  for (const horizontal of [0, 2] as const) {
    const middle = center[horizontal];
    const first = Math.ceil((middle - REACH * radius) / step);
    for (let k = first; k < first + 2 * MOST_LINES; k++) {
      const offset = (k * step - middle) / radius;
      if (!(offset < REACH)) break;
      const half = Math.sqrt(Math.max(REACH * REACH - offset * offset, 0));
      strokes.push(fadingLine(horizontal, offset, half, y));
    }
  }
  return strokes;
}

function fadingLine(horizontal: 0 | 2, offset: number, half: number, y: number): Stroke {
  const points = new Float64Array(3 * (PIECES + 1));
  const fade = new Float64Array(PIECES + 1);
  for (let k = 0; k <= PIECES; k++) {
    const s = half * ((2 * k) / PIECES - 1);
    points.set(horizontal === 0 ? [offset, y, s] : [s, y, offset], 3 * k);
    fade[k] = 1 - smoothstep(CLEAR * REACH, REACH, Math.hypot(offset, s));
  }
  return { points, fade, closed: false, ink: 'edge', width: 1, alpha: 0.45, dash: null };
}
