import type { Stage } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';

/** A point in stage units: the stage's centre is 0 and its radius 1. */
export type Point = [number, number, number];

/** Largest distance of a drawn point in stage radii; beyond it float32 and SVG show noise. */
const FAR = 1e5;

/**
 * World to stage units, in doubles. GPUs and SVG have float32, so a world of size 1e-9 or 1e7 is
 * scaled to size 1 before.
 */
export class StageUnits {
  readonly stage: Stage;
  readonly #perRadius: number;

  constructor(stage: Stage) {
    this.stage = stage;
    this.#perRadius = 1 / stage.radius;
  }

  /** Null for a point that is not finite or too far away. */
  toStage(p: Vec3): Point | null {
    const c = this.stage.center;
    const x = (p[0] - c[0]) * this.#perRadius;
    const y = (p[1] - c[1]) * this.#perRadius;
    const z = (p[2] - c[2]) * this.#perRadius;
    // The comparison is false for NaN.
    return Math.abs(x) + Math.abs(y) + Math.abs(z) < FAR ? [x, y, z] : null;
  }

  /** Height of the ground in stage units. */
  get ground(): number {
    return (this.stage.ground - this.stage.center[1]) * this.#perRadius;
  }

  /** Unit vector from the stage's centre to p, also if p is too far away; null for NaN and 0. */
  towards(p: Vec3): Point | null {
    const c = this.stage.center;
    return unit([p[0] - c[0], p[1] - c[1], p[2] - c[2]]);
  }
}

/** v / |v|; null if v is 0 or not finite. Scaled first, so that no square over- or underflows. */
export function unit(v: Vec3): Point | null {
  const size = Math.max(Math.abs(v[0]), Math.abs(v[1]), Math.abs(v[2]));
  if (!(size > 0 && size < Infinity)) return null;
  const [x, y, z] = [v[0] / size, v[1] / size, v[2] / size];
  const length = Math.hypot(x, y, z);
  return [x / length, y / length, z / length];
}

export function dot(a: Vec3, b: Vec3): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** a + s b */
export function along(a: Vec3, b: Vec3, s: number): Point {
  return [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
}

/** 0 below `from`, 1 above `to`, smooth between. */
export function smoothstep(from: number, to: number, x: number): number {
  const s = Math.min(Math.max((x - from) / (to - from), 0), 1);
  return s * s * (3 - 2 * s);
}
