import type { Vec3 } from '../../../src/math/vec3.ts';
import type { FullModel } from '../../../src/state/derive.ts';
import { curvedDetails } from '../math/shorthand.ts';
import { holds as holdsInGallery, type Subject } from '../state/gallery-claims.ts';
import { at, dot, f, less, quadricOf } from '../state/ray-oracle.ts';

type Check = (subject: Subject, ...parts: string[]) => boolean;

/** Equal but for roundings of a few operations on numbers of this size. */
const near = (x: number, y: number, size = 0): boolean =>
  Math.abs(x - y) <= 1e-9 * (1 + size + Math.abs(x) + Math.abs(y));
const nearVec = (u: Vec3, v: Vec3): boolean => u.every((x, i) => near(x, v[i] ?? 0));

const quadric = ({ shape }: Subject) => {
  const found = quadricOf(shape);
  if (!found) throw new Error(`${shape.kind} is not curved`);
  return found;
};
const F = (s: Subject, point: Vec3): number => f(quadric(s), point);
const along = (s: Subject, t: number): number => F(s, at(s.ray, t));
const hit = (s: Subject, n: string) => s.found.hits[Number(n) - 1];
const TS = [-3, -1, -0.5, 0, 0.25, 1, 2, 7];
const ANGLES = [0, 1, 2, 3, 4, 5];
const onCircle = (s: Subject, angle: number, y: number): Vec3 => {
  const { C, rho } = quadric(s);
  const r = Math.sqrt(rho);
  return [C[0] + r * Math.cos(angle), C[1] + y, C[2] + r * Math.sin(angle)];
};

/** Claims of lessons; those of the gallery can be made too. */
const CHECKS: readonly (readonly [RegExp, Check])[] = [
  [/^R\(0\) = E$/, ({ ray }) => nearVec(at(ray, 0), ray.origin)],
  [
    /^R\(1\) = E \+ d$/,
    ({ ray: { origin: E, direction: d } }) =>
      nearVec(at({ origin: E, direction: d }, 1), [E[0] + d[0], E[1] + d[1], E[2] + d[2]]),
  ],
  [
    /^on the wall: distance r from the axis$/,
    (s) =>
      ANGLES.every((angle) => {
        const [p, { C, rho }] = [onCircle(s, angle, 2), quadric(s)];
        const off = less(p, C);
        return near(Math.hypot(off[0], off[2]), Math.sqrt(rho)) && near(F(s, p), 0, rho);
      }),
  ],
  [
    /^y does not matter$/,
    (s) => ANGLES.every((a) => [-50, 0, 9].every((y) => near(F(s, onCircle(s, a, y)), 0, 9))),
  ],
  [
    /^f\(t\) = A t² \+ B t \+ C$/,
    (s) => {
      const { A, B, C } = curvedDetails(s.found);
      const size = Math.abs(A) * 49 + Math.abs(B) * 7 + Math.abs(C);
      return TS.every((t) => near(along(s, t), (A * t + B) * t + C, size));
    },
  ],
  [
    /^A = d_x² \+ d_z²$/,
    (s) => {
      const { direction: d } = s.ray;
      return near(curvedDetails(s.found).A, d[0] ** 2 + d[2] ** 2);
    },
  ],
  [
    /^√D near \|B\|$/,
    (s) => {
      const { B, D } = curvedDetails(s.found);
      return Math.abs(Math.sqrt(D) / Math.abs(B) - 1) < 1e-9;
    },
  ],
  [/^A = d·d$/, (s) => near(curvedDetails(s.found).A, dot(s.ray.direction, s.ray.direction))],
  [
    /^nearest to the axis: (\S+)$/,
    (s, distance) => {
      const { origin: E, direction: d } = s.ray;
      const [x, , z] = less(E, quadric(s).C);
      return near(Math.abs(x * d[2] - z * d[0]) / Math.hypot(d[0], d[2]), Number(distance));
    },
  ],
  [
    /^N(\d) along the gradient$/,
    (s, n = '') => {
      const { point, normal } = hit(s, n) ?? {};
      if (!point || !normal) return false;
      const step = 1e-5;
      const slope = ([0, 1, 2] as const).map((i) => {
        const to = (by: number): Vec3 => point.map((x, j) => x + (i === j ? by : 0)) as never;
        return (F(s, to(step)) - F(s, to(-step))) / (2 * step);
      }) as unknown as Vec3;
      const lengths = Math.hypot(...slope) * Math.hypot(...normal);
      return lengths > 0 && Math.abs(dot(slope, normal) / lengths - 1) < 1e-9;
    },
  ],
  [/^d sideways$/, ({ ray: { direction: d } }) => d[0] !== 0 || d[2] !== 0],
  [/^C = f\(0\)$/, (s) => near(curvedDetails(s.found).C, along(s, 0))],
  [
    /^D = B² − 4AC$/,
    (s) => {
      const { A, B, C, D } = curvedDetails(s.found);
      return near(D, B * B - 4 * A * C, B * B);
    },
  ],
  [/^f\(t(\d)\) = 0$/, (s, n = '') => near(along(s, hit(s, n)?.t ?? Number.NaN), 0)],
  [
    /^t(\d) = \(−B [−+] √D\) \/ 2A$/,
    (s, n = '') => {
      const { A, B, D } = curvedDetails(s.found);
      const root = (n === '1' ? -1 : 1) * Math.sqrt(D);
      return near(hit(s, n)?.t ?? Number.NaN, (-B + root) / (2 * A));
    },
  ],
  [
    /^t1 = −B \/ 2A$/,
    (s) => {
      const { A, B } = curvedDetails(s.found);
      return near(hit(s, '1')?.t ?? Number.NaN, -B / (2 * A));
    },
  ],
  [/^N(\d) level$/, (s, n = '') => hit(s, n)?.normal[1] === 0],
  [
    /^N(\d) along P\1 − C$/,
    (s, n = '') => {
      const { point, normal } = hit(s, n) ?? {};
      if (!point || !normal) return false;
      const arm = less(point, quadric(s).C);
      const [lengths, product] = [Math.hypot(...arm) * Math.hypot(...normal), dot(arm, normal)];
      return lengths > 0 && near(product, lengths);
    },
  ],
  [
    /^N(\d) across the axis, away from it$/,
    (s, n = '') => {
      const { point, normal } = hit(s, n) ?? {};
      if (!point || !normal) return false;
      const arm = less(point, quadric(s).C);
      const outward: Vec3 = [arm[0], 0, arm[2]];
      const lengths = Math.hypot(...outward) * Math.hypot(...normal);
      return normal[1] === 0 && lengths > 0 && near(dot(outward, normal), lengths);
    },
  ],
  [
    /^N(\d)·d ([<>=]) 0$/,
    (s, n = '', relation) => {
      const product = dot(hit(s, n)?.normal ?? [Number.NaN, 0, 0], s.ray.direction);
      if (relation === '=') return near(product, 0);
      return relation === '<' ? product < 0 : product > 0;
    },
  ],
];

/** Whether a claim holds of what a step shows; throws at a claim that no check knows. */
export function holds(claim: string, { shape, ray, found, graph }: FullModel): boolean {
  const subject = { shape, ray, found };
  if (claim === 'graph is f') return near(graph.bead.f, along(subject, graph.bead.t), 50);
  for (const [pattern, check] of CHECKS) {
    const match = claim.match(pattern);
    if (match) return check(subject, ...match.slice(1));
  }
  return holdsInGallery(claim, subject);
}

/** "B stays", "C follows": of one model against another, of a moved number. */
export function holdsBetween(claim: string, one: FullModel, other: FullModel): boolean {
  const [, letter = '', how] = claim.match(/^([ABCD]) (stays|follows)$/) ?? [];
  const [x, y] = [one, other].map(({ found }) => curvedDetails(found)[letter as 'A']);
  return how === 'stays' ? x === y : x !== y;
}
export const isBetween = (claim: string): boolean => /^[ABCD] (stays|follows)$/.test(claim);
