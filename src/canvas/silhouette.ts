import type { Projection } from './projection.ts';
import type { Point, StageUnits } from './stage-units.ts';
import { at } from './stroke.ts';
import { type Grid, lineFade, pointOn } from './tessellation.ts';

/** A piece of a silhouette: points in stage units with the opacity there. */
interface Chain {
  readonly points: Float64Array;
  readonly fade: Float64Array;
  readonly closed: boolean;
}

/**
 * The silhouette of a patch: where n · (p − eye) = 0. That function of u and v is sampled on the
 * grid, its zero set followed by marching squares, and each crossing is moved to the true surface,
 * so that the line is smooth on a coarse grid.
 */
export function silhouette(grid: Grid, projection: Projection, units: StageUnits): Chain[] {
  const facing = sample(grid, projection);
  const links = new Map<number, number[]>();
  const { columns, rows, patch } = grid;
  const across = columns + 1;
  // Numbers of grid edges: 2k from sample k along u, 2k + 1 along v. In a closed patch the last
  // column is the first.
  const along = (i: number, j: number) => 2 * (j * across + i);
  const up = (i: number, j: number) =>
    2 * (j * across + (patch.closed && i === columns ? 0 : i)) + 1;
  for (let j = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++) {
      const k = j * across + i;
      const a = at(facing, k);
      const b = at(facing, k + 1);
      const c = at(facing, k + across + 1);
      const d = at(facing, k + across);
      if (Number.isNaN(a + b + c + d)) continue;
      const bottom = differ(a, b) ? along(i, j) : -1;
      const right = differ(b, c) ? up(i + 1, j) : -1;
      const top = differ(d, c) ? along(i, j + 1) : -1;
      const left = differ(a, d) ? up(i, j) : -1;
      const crossed = [bottom, right, top, left].filter((edge) => edge >= 0);
      if (crossed.length === 2) link(links, crossed[0] as number, crossed[1] as number);
      if (crossed.length === 4) {
        // At a saddle the sign in the middle decides which corners are connected.
        const corner = !differ(a, a + b + c + d);
        link(links, bottom, corner ? right : left);
        link(links, top, corner ? left : right);
      }
    }
  }
  return follow(links).map(({ edges, closed }) => place(edges, closed, grid, facing, units));
}

function sample({ points, normals, fade }: Grid, { eye }: Projection): Float64Array {
  const facing = new Float64Array(fade.length);
  for (let k = 0, c = 0; k < facing.length; k++, c += 3) {
    facing[k] =
      at(normals, c) * (at(points, c) - eye[0]) +
      at(normals, c + 1) * (at(points, c + 1) - eye[1]) +
      at(normals, c + 2) * (at(points, c + 2) - eye[2]);
  }
  return facing;
}

/** Zero counts as positive, so that a sample exactly on the silhouette is crossed once. */
function differ(a: number, b: number): boolean {
  return a < 0 !== b < 0;
}

function link(links: Map<number, number[]>, a: number, b: number): void {
  for (const [from, to] of [
    [a, b],
    [b, a],
  ] as const) {
    const list = links.get(from);
    if (list) list.push(to);
    else links.set(from, [to]);
  }
}

/** Splits the links into chains: first those with ends, then the loops. */
function follow(links: Map<number, number[]>): { edges: number[]; closed: boolean }[] {
  const chains: { edges: number[]; closed: boolean }[] = [];
  const seen = new Set<number>();
  const walk = (start: number) => {
    const edges = [start];
    seen.add(start);
    for (let here = start; ; ) {
      const next = links.get(here)?.find((edge) => !seen.has(edge));
      if (next === undefined) break;
      seen.add(next);
      edges.push(next);
      here = next;
    }
    return edges;
  };
  for (const [edge, { length }] of links) {
    if (length === 1 && !seen.has(edge)) chains.push({ edges: walk(edge), closed: false });
  }
  for (const edge of links.keys()) {
    if (!seen.has(edge)) chains.push({ edges: walk(edge), closed: true });
  }
  return chains;
}

function place(
  edges: number[],
  closed: boolean,
  grid: Grid,
  facing: Float64Array,
  units: StageUnits,
): Chain {
  const { patch, columns, rows } = grid;
  const across = columns + 1;
  const points: number[] = [];
  const fade: number[] = [];
  for (const edge of edges) {
    const k = edge >> 1;
    const isUp = (edge & 1) === 1;
    const a = at(facing, k);
    const s = a / (a - at(facing, isUp ? k + across : k + 1));
    const u = ((k % across) + (isUp ? 0 : s)) / columns;
    const v = (Math.floor(k / across) + (isUp ? s : 0)) / rows;
    const p: Point | null = pointOn(patch, u, v, units);
    if (!p) continue;
    points.push(...p);
    fade.push(lineFade(patch, u, v));
  }
  return { points: Float64Array.from(points), fade: Float64Array.from(fade), closed };
}
