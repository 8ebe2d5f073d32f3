import { CONTAINED, NONE, ONE, UNDECIDED } from './batch.ts';
import { type SolveRay, withoutRoots } from './loops.ts';
import type { Planar } from './planar.ts';

const finite = (x: number): boolean => x - x === 0;
const isAbove = (x: number): boolean => x > 0 && finite(x);

/**
 * The moment form in float64 for a flat shape: w = m × N and N·d, both with the sign of N·d,
 * decide.
 */
export function momentPlanar({ N, P, bound, size, u, v }: Planar): SolveRay {
  const [Nx, Ny, Nz] = N;
  const [Px, Py, Pz] = P;
  const w = new Float64Array(3);
  return (rays, i, out) => {
    const dx = rays.dx[i] as number;
    const dy = rays.dy[i] as number;
    const dz = rays.dz[i] as number;
    const px = (rays.Ex[i] as number) - Px;
    const py = (rays.Ey[i] as number) - Py;
    const pz = (rays.Ez[i] as number) - Pz;
    const rate = Nx * dx + Ny * dy + Nz * dz;
    const offset = Nx * px + Ny * py + Nz * pz;
    if (!finite(rate)) return withoutRoots(out, i, UNDECIDED);
    if (rate === 0) {
      const verdict = finite(offset) ? (offset === 0 ? CONTAINED : NONE) : UNDECIDED;
      return withoutRoots(out, i, verdict);
    }
    const mx = dy * pz - dz * py;
    const my = dz * px - dx * pz;
    const mz = dx * py - dy * px;
    const s = rate < 0 ? -1 : 1;
    w[0] = s * (my * Nz - mz * Ny);
    w[1] = s * (mz * Nx - mx * Nz);
    w[2] = s * (mx * Ny - my * Nx);
    const inside =
      bound === 'none'
        ? ONE
        : bound === 'circle'
          ? withinCircle(w, size * size * (rate * rate))
          : withinSquare(w, size * (s * rate), u, v);
    if (inside !== ONE) return withoutRoots(out, i, inside);
    const t = -offset / rate;
    // P + w / |N·d| is NaN just where w is (rate is finite and not 0).
    const isPlace = !Number.isNaN(w[0]) && !Number.isNaN(w[1]) && !Number.isNaN(w[2]);
    if (!finite(t) || !isPlace) return withoutRoots(out, i, UNDECIDED);
    out.t0[i] = t;
    out.t1[i] = Number.NaN;
    return ONE;
  };
}

function withinCircle(w: Float64Array, limit: number): number {
  const x = w[0] as number;
  const y = w[1] as number;
  const z = w[2] as number;
  const beyond = x * x + y * y + z * z - limit;
  return finite(beyond) ? (beyond > 0 ? NONE : ONE) : UNDECIDED;
}

/** 0 ≤ w ≤ L|N·d| along both axes. */
function withinSquare(w: Float64Array, limit: number, u: number, v: number): number {
  const a = w[u] as number;
  const b = w[v] as number;
  if (isAbove(-a) || isAbove(a - limit) || isAbove(-b) || isAbove(b - limit)) return NONE;
  return finite(a) && finite(b) && finite(a - limit) && finite(b - limit) ? ONE : UNDECIDED;
}
