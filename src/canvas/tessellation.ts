import type { Patch, PatchEnd } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';
import { type Point, type StageUnits, smoothstep, unit } from './stage-units.ts';

/**
 * Steps around a closed patch: the chord of 1/96 of a turn leaves the circle by 0.05 % of its
 * radius, less than a pixel.
 */
const AROUND = 96;
const ACROSS = 24;
/** Least steps along v; straight profiles need them as well, for fading. */
const LEAST_ALONG = 16;
const MOST_ALONG = 72;

/**
 * Share of v (or u) in which a surface fades towards an end that goes on, and its opacity there.
 */
const FADE_LENGTH = 0.72;
const FADE_SIDES = 0.26;
const FADE_REST = 0.06;
/** The same for lines, which fade less, so that the outline is visible to its end. */
const LINE_FADE_LENGTH = 0.3;
const LINE_FADE_REST = 0.55;

/** A patch sampled on a grid, in stage units: (columns + 1) × (rows + 1) points, u along a row. */
export interface Grid {
  readonly patch: Patch;
  readonly columns: number;
  readonly rows: number;
  readonly points: Float64Array;
  /**
   * Unit normals; NaN at points without a normal or outside of the picture, which are not drawn.
   */
  readonly normals: Float64Array;
  /** Factor on the surface's opacity. */
  readonly fade: Float64Array;
  /** Whether triangles wind so that the normal is on their front. */
  readonly outward: boolean;
}

export function tessellate(patch: Patch, units: StageUnits): Grid {
  const columns = patch.closed ? AROUND : ACROSS;
  const rows = Math.min(Math.max(Math.ceil(patch.stepsV) || 1, LEAST_ALONG), MOST_ALONG);
  const count = (columns + 1) * (rows + 1);
  const points = new Float64Array(3 * count);
  const normals = new Float64Array(3 * count);
  const fade = new Float64Array(count);
  let k = 0;
  for (let j = 0; j <= rows; j++) {
    for (let i = 0; i <= columns; i++, k++) {
      const [u, v] = [i / columns, j / rows];
      const place = units.toStage(patch.at(u, v));
      const normal = place && normalAt(patch, u, v, 1 / rows);
      points.set(place ?? [0, 0, 0], 3 * k);
      normals.set(normal ?? [Number.NaN, Number.NaN, Number.NaN], 3 * k);
      fade[k] = surfaceFade(patch, u, v);
    }
  }
  const grid = { patch, columns, rows, points, normals, fade };
  return { ...grid, outward: windsOutward(grid) };
}

/** The normal; where the gradient is zero (a cone's vertex) that of a point next to it. */
function normalAt(patch: Patch, u: number, v: number, step: number): Point | null {
  const n = unit(patch.normal(u, v));
  return n ?? unit(patch.normal(u, v + (v < 0.5 ? step : -step) / 8));
}

/** A point of the patch between the samples; null outside of the picture. */
export function pointOn(patch: Patch, u: number, v: number, units: StageUnits): Point | null {
  return units.toStage(patch.at(u, v));
}

function surfaceFade(patch: Patch, u: number, v: number): number {
  const rest = fadeOf(patch, u, v, FADE_LENGTH, FADE_SIDES);
  return FADE_REST + (1 - FADE_REST) * rest;
}

export function lineFade(patch: Patch, u: number, v: number): number {
  const rest = fadeOf(patch, u, v, LINE_FADE_LENGTH, LINE_FADE_LENGTH);
  return LINE_FADE_REST + (1 - LINE_FADE_REST) * rest;
}

function fadeOf(patch: Patch, u: number, v: number, length: number, sides: number): number {
  // Where both ends go on, each may take less than half.
  const reach =
    patch.start === 'goes-on' && patch.end === 'goes-on' ? Math.min(length, sides) : length;
  const towards = (end: PatchEnd, distance: number, span: number) =>
    end === 'goes-on' ? smoothstep(0, span, distance) : 1;
  const ends = towards(patch.start, v, reach) * towards(patch.end, 1 - v, reach);
  if (patch.closed) return ends;
  return ends * towards(patch.sides, u, sides) * towards(patch.sides, 1 - u, sides);
}

/** Decided at the middle of the patch, where it is not degenerate. */
function windsOutward(grid: Omit<Grid, 'outward'>): boolean {
  const { columns, rows, points, normals } = grid;
  const k = Math.floor(rows / 2) * (columns + 1) + Math.floor(columns / 2);
  const read = (list: Float64Array, index: number): Vec3 => [
    list[3 * index] ?? 0,
    list[3 * index + 1] ?? 0,
    list[3 * index + 2] ?? 0,
  ];
  const [o, a, b] = [read(points, k), read(points, k + 1), read(points, k + columns + 1)];
  const [ux, uy, uz] = [a[0] - o[0], a[1] - o[1], a[2] - o[2]];
  const [vx, vy, vz] = [b[0] - o[0], b[1] - o[1], b[2] - o[2]];
  const n = read(normals, k);
  const volume =
    (uy * vz - uz * vy) * n[0] + (uz * vx - ux * vz) * n[1] + (ux * vy - uy * vx) * n[2];
  return !(volume < 0);
}
