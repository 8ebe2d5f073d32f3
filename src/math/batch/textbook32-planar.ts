import { CONTAINED, NONE, ONE, UNDECIDED } from './batch.ts';
import { type SolveRay, withoutRoots } from './loops.ts';
import type { Planar } from './planar.ts';

const { fround } = Math;
const finite = (x: number): boolean => x - x === 0;

/** The course's formula in float32 for a flat shape. */
export function textbook32Planar({ N, P, bound, size, u, v }: Planar): SolveRay {
  const [Nx, Ny, Nz] = N.map(fround) as [number, number, number];
  const [Px, Py, Pz] = P.map(fround) as [number, number, number];
  const r = fround(size);
  // X of the ray at hand, and P.
  const X = new Float64Array(3);
  const from = Float64Array.of(Px, Py, Pz);
  return (rays, i, out) => {
    const dx = fround(rays.dx[i] as number);
    const dy = fround(rays.dy[i] as number);
    const dz = fround(rays.dz[i] as number);
    const Ex = fround(rays.Ex[i] as number);
    const Ey = fround(rays.Ey[i] as number);
    const Ez = fround(rays.Ez[i] as number);
    const rate = fround(fround(fround(Nx * dx) + fround(Ny * dy)) + fround(Nz * dz));
    const offset = fround(
      fround(fround(Nx * fround(Ex - Px)) + fround(Ny * fround(Ey - Py))) +
        fround(Nz * fround(Ez - Pz)),
    );
    if (!finite(rate)) return withoutRoots(out, i, UNDECIDED);
    if (rate === 0) {
      const verdict = finite(offset) ? (offset === 0 ? CONTAINED : NONE) : UNDECIDED;
      return withoutRoots(out, i, verdict);
    }
    const t = fround(-offset / rate);
    X[0] = fround(Ex + fround(t * dx));
    X[1] = fround(Ey + fround(t * dy));
    X[2] = fround(Ez + fround(t * dz));
    const inside =
      bound === 'none'
        ? ONE
        : bound === 'circle'
          ? withinCircle(X, from, r)
          : withinSquare(X, from, r, u, v);
    if (inside !== ONE) return withoutRoots(out, i, inside);
    if (!finite(t) || Number.isNaN(X[0]) || Number.isNaN(X[1]) || Number.isNaN(X[2])) {
      return withoutRoots(out, i, UNDECIDED);
    }
    out.t0[i] = t;
    out.t1[i] = Number.NaN;
    return ONE;
  };
}

function withinCircle(X: Float64Array, C: Float64Array, r: number): number {
  const x = fround((X[0] as number) - (C[0] as number));
  const y = fround((X[1] as number) - (C[1] as number));
  const z = fround((X[2] as number) - (C[2] as number));
  const square = fround(fround(fround(x * x) + fround(y * y)) + fround(z * z));
  const beyond = fround(fround(Math.sqrt(square)) - r);
  return finite(beyond) ? (beyond > 0 ? NONE : ONE) : UNDECIDED;
}

/**
 * P ≤ x ≤ P + L along both axes: one condition that fails decides, one that overflows leaves it
 * open.
 */
function withinSquare(X: Float64Array, P: Float64Array, L: number, u: number, v: number): number {
  const a = fround((P[u] as number) - (X[u] as number));
  const b = fround((X[u] as number) - fround((P[u] as number) + L));
  const c = fround((P[v] as number) - (X[v] as number));
  const d = fround((X[v] as number) - fround((P[v] as number) + L));
  if (isAbove(a) || isAbove(b) || isAbove(c) || isAbove(d)) return NONE;
  return finite(a) && finite(b) && finite(c) && finite(d) ? ONE : UNDECIDED;
}

const isAbove = (x: number): boolean => x > 0 && finite(x);
