import type { Quadric } from '../../batch/quadric.ts';
import type { CurvedDetails, Intersection, Sign } from '../../intersection.ts';
import type { Ray } from '../../ray.ts';
import {
  coefficientsPass,
  createGrid,
  ERROR,
  GRID_A,
  GRID_B,
  GRID_C,
  GRID_D,
  GRID_OFF_D,
  GRID_REACH_D,
  GRID_REACH_P,
  placePass,
  rootsPass,
} from './grids.ts';
import { createFound, findRoots, T0, T1 } from './one-ray.ts';
import { BOX, type CertifiedQuadric } from './quadric-numbers.ts';
import { FAITHFUL_ONCE } from './stage.ts';

/*
 * One ray against a curved shape in one go, by parts on grids: class, A, B, C, D, points and
 * normals to some 75 bits, which settles 99 of 100 rays of a picture in half the time of
 * plain-quadric.ts with its 106 bits. The roots are the batch's own. Null for the rest, and beyond
 * the box.
 *
 * D > 0 within its bound makes two hits, if A ≠ 0 is certain; a coordinate is not, where A is not,
 * so that A's test only saves the roots. D and P are above 1/BOX, |A| ≥ 2^-20 D², and so on, where
 * they pass, and D/4 ≥ 2^-38 D²P²: the filter of the batch kernels would have been sure of that.
 * What underflows (2^-1074, times factors of the box) is far below η of any of the scales. What
 * overflows makes D/4's bound infinite, or D/4 NaN by its splitting, and both fail a comparison; so
 * does the NaN of a root that is not there.
 */
const signOf = (x: number): Sign => (x > 0 ? 1 : -1);

type Answer = (q: Quadric, c: CertifiedQuadric, ray: Ray) => Intersection | null;

export const gridQuadric = onGrids();

function onGrids(): Answer {
  const grid = createGrid();
  const putCoefficients = coefficientsPass(grid);
  const found = createFound();
  const putRoots = rootsPass(grid, found);
  const hitAt = placePass(grid, found);
  const BOUND = ERROR;
  const SURE = FAITHFUL_ONCE;
  const SMALL = 1 / BOX;
  return (q, c, ray) => {
    if (!c.inBox) return null;
    putCoefficients(c.numbers, ray);
    const A = grid[GRID_A] as number;
    const b = grid[GRID_B] as number;
    const C = grid[GRID_C] as number;
    const D = grid[GRID_D] as number;
    const reachD = grid[GRID_REACH_D] as number;
    const reachP = grid[GRID_REACH_P] as number;
    const both = reachD * reachP;
    const sure =
      BOUND * (reachD * reachD) <= SURE * Math.abs(A) &&
      BOUND * both <= SURE * Math.abs(b) &&
      BOUND * (reachP * reachP) <= SURE * Math.abs(C) &&
      (grid[GRID_OFF_D] as number) <= SURE * Math.abs(D) &&
      reachD > SMALL &&
      reachP > SMALL;
    if (!sure) return null;
    const details: CurvedDetails = {
      family: 'curved',
      A,
      B: 2 * b,
      C,
      D: 4 * D,
      signs: { A: signOf(A), B: signOf(b), C: signOf(C), D: signOf(D) },
    };
    if (D < 0)
      return { class: 'none', hits: [], method: 'certified', decidedBy: 'filter', details };
    findRoots(q, ray, found, c);
    putRoots(ray);
    const near = hitAt(c.numbers, T0, 1);
    const far = near && hitAt(c.numbers, T1, -1);
    return (
      far && { class: 'two', hits: [near, far], method: 'certified', decidedBy: 'filter', details }
    );
  };
}
