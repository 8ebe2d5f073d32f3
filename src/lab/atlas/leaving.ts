import {
  type Answers,
  createAnswers,
  createRays,
  type Kernel,
  type Rays,
} from '../../math/batch.ts';
import { evaluateTriple, float64, type Triple, vec, withPoint } from '../../math/formula.ts';
import type { Shape } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import type { Mark } from './marks.ts';
import type { StartRule } from './request.ts';

/** Gets the place of a ray and what is said of it; not called for a ray that meets nothing. */
type Tell = (i: number, mark: Mark) => void;

/**
 * Follows rays to their first hit, as the method finds it, and from there as a mirror sends them:
 * does the method say that they meet their own surface again? The truth is the exact answer for the
 * same outward ray, without the root at which it starts.
 *
 * - misses: it meets its surface again, and the method says that it does not;
 * - invents: the method finds a hit where the ray starts, or where there is none.
 */
export function createLeaving(start: StartRule) {
  return (shape: Shape, asked: Kernel, sure: Kernel, rays: Rays, tell: Tell): void => {
    const first = createAnswers(rays.count);
    asked.first(rays, Number.MIN_VALUE, Number.POSITIVE_INFINITY, first);
    const out = createRays(rays.count);
    const places: number[] = [];
    const normalAt = normalsOf(shape);
    for (let i = 0; i < rays.count; i++) {
      const t = first.t0[i] as number;
      if (!(t < Number.POSITIVE_INFINITY)) continue;
      if (leaves(rays, i, t, normalAt, out, places.length)) places.push(i);
    }
    out.count = places.length;
    const [own, truth] = [createAnswers(out.count), createAnswers(out.count)];
    asked.both(out, own);
    sure.both(out, truth);
    const least = leastOf(start);
    places.forEach((i, k) => {
      const length = Math.hypot(out.dx[k] as number, out.dy[k] as number, out.dz[k] as number);
      const again = ahead(dropped(truth, k), Number.MIN_VALUE);
      const roots = start.rule === 'from' ? dropped(own, k) : rootsOf(own, k);
      const said = ahead(roots, least / length);
      tell(i, judged(said, again));
    });
  };
}

const leastOf = (start: StartRule): number =>
  start.rule === 'epsilon' ? start.epsilon : Number.MIN_VALUE;

const rootsOf = ({ t0, t1 }: Answers, k: number): readonly [number, number] => [
  t0[k] as number,
  t1[k] as number,
];

/** Without the root nearest to 0; of two equally near ones the positive one goes. */
function dropped(answers: Answers, k: number): readonly [number, number] {
  const [near, far] = rootsOf(answers, k);
  return Math.abs(far) <= Math.abs(near) ? [near, Number.NaN] : [Number.NaN, far];
}

/** The first root from `least` on; NaN without one. */
function ahead(roots: readonly [number, number], least: number): number {
  const bound = Math.max(least, Number.MIN_VALUE);
  return roots.find((t) => t >= bound) ?? Number.NaN;
}

/** A first root less than half as far as the true one is the start itself. */
function judged(said: number, truth: number): Mark {
  if (Number.isNaN(said)) return Number.isNaN(truth) ? 'right' : 'misses';
  if (Number.isNaN(truth) || said < truth / 2) return 'invents';
  return said > 2 * truth ? 'misses' : 'right';
}

type NormalAt = (x: Triple<number>) => Triple<number>;

function normalsOf(shape: Shape): NormalAt {
  const { formula: of, values: valuesOf } = definitionOf(shape);
  const formula = of(shape);
  const values = valuesOf(shape);
  if (formula.family === 'flat') {
    const N = values.vectors[(vec('N') as { id: string }).id] as Triple<number>;
    return () => N;
  }
  const { normal } = formula;
  return (x) => evaluateTriple(normal, float64, withPoint(values, x));
}

/** Writes the mirrored ray into place k; false where there is no direction to leave in. */
function leaves(
  { Ex, Ey, Ez, dx, dy, dz }: Rays,
  i: number,
  t: number,
  normalAt: NormalAt,
  out: Rays,
  k: number,
): boolean {
  const d: Triple<number> = [dx[i] as number, dy[i] as number, dz[i] as number];
  const x: Triple<number> = [
    (Ex[i] as number) + t * d[0],
    (Ey[i] as number) + t * d[1],
    (Ez[i] as number) + t * d[2],
  ];
  const n = normalAt(x);
  const twice =
    (2 * (d[0] * n[0] + d[1] * n[1] + d[2] * n[2])) / (n[0] ** 2 + n[1] ** 2 + n[2] ** 2);
  const r: Triple<number> = [d[0] - twice * n[0], d[1] - twice * n[1], d[2] - twice * n[2]];
  const all = [...x, ...r];
  if (!all.every(Number.isFinite) || r.every((one) => one === 0)) return false;
  [out.Ex[k], out.Ey[k], out.Ez[k]] = x;
  [out.dx[k], out.dy[k], out.dz[k]] = r;
  return true;
}
