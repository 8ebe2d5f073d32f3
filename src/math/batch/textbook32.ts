import {
  type Answers,
  CONTAINED,
  type Kernel,
  list,
  NONE,
  ONE,
  type Rays,
  selectFirst,
  TANGENT,
  TWO,
  UNDECIDED,
} from './batch.ts';
import { withoutRoots } from './loops.ts';
import type { Quadric } from './quadric.ts';

const { fround } = Math;

/**
 * What is below this does not round to infinity: a cylinder's hit would have no y, though its roots
 * do not know.
 */
const MOST = 2 ** 127;
/** With B and √D below 2^60 and |A| above 2^-60 no root leaves the range. */
const WIDE = 2 ** 60;
const TINY = 2 ** -60;

interface Rounded {
  readonly Cx: number;
  readonly Cy: number;
  readonly Cz: number;
  readonly a: number;
  readonly rho: number;
  readonly hasY: boolean;
  readonly hasR: boolean;
}

function rounded(q: Quadric): Rounded {
  const flare = fround(q.flare);
  const r = fround(q.r);
  return {
    Cx: fround(q.Cx),
    Cy: fround(q.Cy),
    Cz: fround(q.Cz),
    a: q.squared ? fround(flare * flare) : flare,
    rho: fround(r * r),
    hasY: q.hasY,
    hasR: q.hasR,
  };
}

/**
 * The course's formula over arrays with every number and operation in float32, for curved shapes.
 */
export function textbook32Quadric(quadric: Quadric): Kernel {
  const q = rounded(quadric);
  // A, B, C, D of the ray at hand.
  const S = new Float64Array(4);
  // With a = 0 a far hit can lack its normal: 0·∞. Then every ray is looked at one by one.
  const careful = q.hasY && q.a === 0;
  const both = (rays: Rays, out: Answers): void => solveAll(q, rays, out, S, careful, false);
  return {
    met: 'two',
    both,
    classes: (rays, out) => solveAll(q, rays, out, S, careful, true),
    first(rays, tMin, tMax, out) {
      both(rays, out);
      selectFirst(out, rays.count, tMin, tMax);
    },
  };
}

function solveAll(
  q: Rounded,
  rays: Rays,
  out: Answers,
  S: Float64Array,
  careful: boolean,
  classOnly: boolean,
): void {
  const { t0, t1, margin } = out;
  out.rareCount = 0;
  for (let i = 0; i < rays.count; i++) {
    coefficients(q, rays, i, S);
    const A = S[0] as number;
    const B = S[1] as number;
    const D = S[3] as number;
    const inFloat32 =
      Math.abs(rays.Ey[i] as number) < MOST && Math.abs(rays.dy[i] as number) < MOST;
    const usual =
      inFloat32 && D !== 0 && Math.abs(D) < WIDE && Math.abs(B) < WIDE && Math.abs(A) > TINY;
    if (careful || !usual) solveOne(q, rays, i, out, S);
    else if (classOnly) margin[i] = D;
    else {
      const s = fround(Math.sqrt(D));
      const w = fround(2 * A);
      const near = fround(fround(-B - s) / w);
      const far = fround(fround(s - B) / w);
      if (Math.abs(near) + Math.abs(far) === 0) solveOne(q, rays, i, out, S);
      else {
        t0[i] = Math.min(near, far);
        t1[i] = Math.max(near, far);
      }
    }
  }
}

/** A, B, C and D of ray i into S. */
function coefficients(q: Rounded, rays: Rays, i: number, S: Float64Array): void {
  const dx = fround(rays.dx[i] as number);
  const dz = fround(rays.dz[i] as number);
  const px = fround(fround(rays.Ex[i] as number) - q.Cx);
  const pz = fround(fround(rays.Ez[i] as number) - q.Cz);
  let A = fround(fround(dx * dx) + fround(dz * dz));
  let B = fround(fround(fround(2 * dx) * px) + fround(fround(2 * dz) * pz));
  let C = fround(fround(px * px) + fround(pz * pz));
  if (q.hasY) {
    const dy = fround(rays.dy[i] as number);
    const py = fround(fround(rays.Ey[i] as number) - q.Cy);
    A = fround(A - fround(q.a * fround(dy * dy)));
    B = fround(B - fround(fround(fround(2 * q.a) * dy) * py));
    C = fround(C - fround(q.a * fround(py * py)));
  }
  if (q.hasR) C = fround(C - q.rho);
  S[0] = A;
  S[1] = B;
  S[2] = C;
  S[3] = fround(fround(B * B) - fround(fround(4 * A) * C));
}

const finite = (x: number): boolean => x - x === 0;

function solveOne(q: Rounded, rays: Rays, i: number, out: Answers, S: Float64Array): void {
  const verdict = solve(q, rays, i, out, S);
  out.margin[i] = verdict === NONE ? -1 : 1;
  if (verdict !== NONE && verdict !== TWO) list(out, i, verdict);
}

/** The case distinction of methods/solvers.ts. */
function solve(q: Rounded, rays: Rays, i: number, out: Answers, S: Float64Array): number {
  const A = S[0] as number;
  const B = S[1] as number;
  const C = S[2] as number;
  const D = S[3] as number;
  if (!finite(A)) return withoutRoots(out, i, UNDECIDED);
  if (A === 0) {
    if (!finite(B)) return withoutRoots(out, i, UNDECIDED);
    if (B !== 0) return keep(q, rays, i, out, ONE, fround(-C / B), Number.NaN);
    const verdict = finite(C) ? (C === 0 ? CONTAINED : NONE) : UNDECIDED;
    return withoutRoots(out, i, verdict);
  }
  if (!finite(D)) return withoutRoots(out, i, UNDECIDED);
  if (D < 0) return withoutRoots(out, i, NONE);
  const w = fround(2 * A);
  if (D === 0) return keep(q, rays, i, out, TANGENT, fround(-B / w), Number.NaN);
  const s = fround(Math.sqrt(D));
  const near = fround(fround(-B - s) / w);
  const far = fround(fround(s - B) / w);
  return near > far ? keep(q, rays, i, out, TWO, far, near) : keep(q, rays, i, out, TWO, near, far);
}

/** A root that overflowed is no answer, nor is one without a place or a normal. */
function keep(
  q: Rounded,
  rays: Rays,
  i: number,
  out: Answers,
  verdict: number,
  near: number,
  far: number,
): number {
  const whole = hasPlace(q, rays, i, near) && (verdict !== TWO || hasPlace(q, rays, i, far));
  if (!whole) return withoutRoots(out, i, UNDECIDED);
  out.t0[i] = near;
  out.t1[i] = far;
  return verdict;
}

function hasPlace(q: Rounded, rays: Rays, i: number, t: number): boolean {
  if (!finite(t)) return false;
  if (q.hasY && q.a !== 0) return true;
  const y = fround(fround(rays.Ey[i] as number) + fround(t * fround(rays.dy[i] as number)));
  return q.hasY ? finite(fround(y - q.Cy)) : !Number.isNaN(y);
}
