import type { Verdict } from '../intersection.ts';
import { requireFinite, requireNonZero } from '../invalid-input.ts';
import type { Ray } from '../ray.ts';
import { type MakeArray, ownArray } from './memory.ts';

/*
 * The batch form of a method: rays as a structure of arrays in, numbers out, no object or array
 * made per ray, but for rays that a kernel's loops leave open: these go to `intersect`, or in
 * `certified` to whole numbers, by which `exact` works always. Every method has loops of its own: a
 * loop shared between methods through a callback is fast for the first one that it inlines and slow
 * for all as soon as there is a second.
 */

/** Rays R(t) = E + t d, component by component; each array has at least `count` numbers. */
export interface Rays {
  /** Rays 0 … count − 1 are asked about; the arrays may be longer. */
  count: number;
  /** E, in the units of length that the shape has. */
  readonly Ex: Float64Array;
  readonly Ey: Float64Array;
  readonly Ez: Float64Array;
  /** d, of any length but 0: roots count in its lengths. */
  readonly dx: Float64Array;
  readonly dy: Float64Array;
  readonly dz: Float64Array;
}

/**
 * What a kernel writes; each array has at least as many places as there are rays. A byte or a
 * branch for the class costs more on random rays than the arithmetic, so the class is read from the
 * numbers, and the few rays for which these do not tell it are listed aside, in any order, each
 * once.
 */
export interface Answers {
  /** `both`, `first`: the roots in lengths of d, ascending; NaN where there is none. */
  readonly t0: Float64Array;
  readonly t1: Float64Array;
  /**
   * `classes`: ≥ 0 where the line meets the shape, negative where it does not; any number, NaN too,
   * if the ray is listed. Its unit is the method's own: only the sign counts.
   */
  readonly margin: Float64Array;
  /** The listed rays: rareIndex[k] has the class VERDICTS[rareVerdict[k]], for k < rareCount. */
  rareCount: number;
  readonly rareIndex: Int32Array;
  readonly rareVerdict: Uint8Array;
}

/**
 * A kernel for one shape. Rays are expected to be finite, with d ≠ 0; each call overwrites the
 * answers. At a ray that is not, `exact` and `certified` throw InvalidInput, with its index; then
 * no ray has an answer: t0, t1 and margin are NaN, and nothing is listed. So does every method for
 * a shape without kernel numbers. Elsewhere the other methods go on with what their arithmetic
 * makes of it. Numbers that the formula does not look at may be anything: a cylinder's does not
 * look at Ey and dy.
 */
export interface Kernel {
  /**
   * The class of a line that meets the shape and is not listed: 'two' for a curved shape, 'one' for
   * a flat one.
   */
  readonly met: 'two' | 'one';
  /**
   * "Is it hit?" for the whole line. Fills margin; lists every ray whose class is neither `met` nor
   * 'none'.
   */
  classes(rays: Rays, out: Answers): void;
  /**
   * The smallest root in [tMin, tMax] (in lengths of d, either end may be infinite), as the method
   * rounds its roots, in t0, NaN if there is none; t1 becomes NaN. Lists 'contained' and
   * 'undecided' (both with NaN); whether a root is a tangent's is not asked. Of a curved shape both
   * roots are found, and the first is chosen; `exact`, for a shape with kernel numbers, finds the
   * second only where the first is not in the range (docs/bench.md, "Why").
   */
  first(rays: Rays, tMin: number, tMax: number, out: Answers): void;
  /**
   * t0 ≤ t1: 'two'. t0 alone: 'one', or 'tangent' if it is listed so. Neither: 'none', or
   * 'contained' or 'undecided' if it is listed so.
   */
  both(rays: Rays, out: Answers): void;
}

/** What numbers in `rareVerdict` stand for: NONE is the place of 'none', and so on. */
export const VERDICTS = [
  'none',
  'one',
  'two',
  'tangent',
  'contained',
  'undecided',
] as const satisfies readonly Verdict[];

/** The place of 'none' in lists of verdicts by number. */
export const NONE = 0;
export const ONE = 1;
export const TWO = 2;
export const TANGENT = 3;
export const CONTAINED = 4;
export const UNDECIDED = 5;

/**
 * Room for `capacity` rays, all zeros, `count` 0.
 *
 * @param capacity a whole number ≥ 0.
 * @param make makes each array: `kernelArray` (memory.ts) saves copying where the arrays stay here.
 * @example
 * const rays = createRays(2);
 * [rays.Ex[0], rays.dx[0], rays.count] = [4, -1, 1];
 * rays.Ex.length; // → 2
 */
export function createRays(capacity: number, make: MakeArray = ownArray): Rays {
  const array = (): Float64Array => make(capacity);
  return { count: 0, Ex: array(), Ey: array(), Ez: array(), dx: array(), dy: array(), dz: array() };
}

/**
 * The same rays as a structure of arrays; `count` is their number. They are not checked here.
 *
 * @param list rays as `intersect` takes them; their numbers are copied.
 * @param make as for `createRays`.
 * @example
 * const rays = packRays([{ origin: [4, 1, 0], direction: [-1, 0, 2] }]);
 * [rays.count, rays.Ex[0], rays.dz[0]]; // → [1, 4, 2]
 */
export function packRays(list: readonly Ray[], make: MakeArray = ownArray): Rays {
  const rays = createRays(list.length, make);
  rays.count = list.length;
  list.forEach(({ origin, direction }, i) => {
    [rays.Ex[i], rays.Ey[i], rays.Ez[i]] = origin;
    [rays.dx[i], rays.dy[i], rays.dz[i]] = direction;
  });
  return rays;
}

/**
 * Room for the answers to `capacity` rays.
 *
 * @param capacity a whole number ≥ 0: most rays that a kernel is asked about at once.
 * @param make as for `createRays`; not for the list.
 * @example
 * const rays = packRays([{ origin: [-10, 0, 3], direction: [1, 0, 0] }]);
 * const out = createAnswers(rays.count);
 * const certified = METHODS.find(({ id }) => id === 'certified')!;
 * const kernel = batchOf(certified, { kind: 'cylinder', center: [0, 0, 0], radius: 5 });
 * kernel.both(rays, out);
 * [out.t0[0], out.t1[0]]; // → [6, 14]
 * kernel.first(rays, 7, Infinity, out);
 * [out.t0[0], out.t1[0]]; // → [14, NaN]
 */
export function createAnswers(capacity: number, make: MakeArray = ownArray): Answers {
  return {
    t0: make(capacity),
    t1: make(capacity),
    margin: make(capacity),
    rareCount: 0,
    rareIndex: new Int32Array(capacity),
    rareVerdict: new Uint8Array(capacity),
  };
}

/**
 * For kernels that throw: InvalidInput, and no answers, if ray i is not in order. Asked only of
 * rays that take long anyway.
 *
 * @param looksAtY as Quadric.hasY: false where Ey and dy may be anything.
 * @throws InvalidInput with the ray's index, if one of its numbers is not finite or d is 0.
 * @example
 * const rays = packRays([{ origin: [0, 0, 0], direction: [0, 0, 0] }]);
 * checkRay(rays, 0, true, createAnswers(1));
 * // throws InvalidInput: ray 0: direction must not be zero, got (0, 0, 0)
 */
export function checkRay(rays: Rays, i: number, looksAtY: boolean, out: Answers): void {
  const ex = rays.Ex[i] as number;
  const ey = rays.Ey[i] as number;
  const ez = rays.Ez[i] as number;
  const x = rays.dx[i] as number;
  const y = rays.dy[i] as number;
  const z = rays.dz[i] as number;
  // x − x is 0 for a finite x only.
  const around = ex - ex + (ez - ez) + (x - x) + (z - z);
  const along = looksAtY ? ey - ey + (y - y) : 0;
  if (around + along === 0 && (x !== 0 || y !== 0 || z !== 0)) return;
  for (const answers of [out.t0, out.t1, out.margin]) answers.fill(Number.NaN, 0, rays.count);
  out.rareCount = 0;
  const parts = looksAtY ? PARTS : PARTS.filter((part) => !part.endsWith('y'));
  for (const part of parts) requireFinite(`ray ${i}: ${part}`, rays[part][i]);
  requireNonZero(`ray ${i}: direction`, [x, y, z]);
}

const PARTS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'] as const;

/**
 * For kernels: puts ray i on the list.
 *
 * @param verdict a place in VERDICTS.
 * @example
 * const out = createAnswers(2);
 * list(out, 1, CONTAINED);
 * [out.rareCount, out.rareIndex[0], VERDICTS[out.rareVerdict[0]!]]; // → [1, 1, 'contained']
 */
export function list(out: Answers, i: number, verdict: number): void {
  out.rareIndex[out.rareCount] = i;
  out.rareVerdict[out.rareCount] = verdict;
  out.rareCount += 1;
}

/**
 * The verdicts of the first `count` rays after `classes`.
 *
 * @param out what a kernel wrote.
 * @param count how many rays were asked: a whole number ≥ 0.
 * @param met the kernel's `met`: the class of a ray whose margin is ≥ 0.
 * @example
 * const out = createAnswers(3);
 * out.margin.set([1, -1]);
 * verdictsOfClasses(out, 3, 'two'); // → ['two', 'none', 'two']
 */
export function verdictsOfClasses(out: Answers, count: number, met: 'two' | 'one'): Verdict[] {
  const found = Array.from(
    { length: count },
    (_, i): Verdict => ((out.margin[i] as number) >= 0 ? met : 'none'),
  );
  return withListed(found, out);
}

/**
 * The verdicts of the first `count` rays after `both`.
 *
 * @param out what a kernel wrote.
 * @param count how many rays were asked: a whole number ≥ 0.
 * @example
 * const out = createAnswers(3);
 * out.t0.set([6, 2, Number.NaN]);
 * out.t1.set([14, Number.NaN, Number.NaN]);
 * verdictsOfRoots(out, 3); // → ['two', 'one', 'none']
 */
export function verdictsOfRoots(out: Answers, count: number): Verdict[] {
  const found = Array.from({ length: count }, (_, i): Verdict => {
    if (!Number.isNaN(out.t1[i])) return 'two';
    return Number.isNaN(out.t0[i]) ? 'none' : 'one';
  });
  return withListed(found, out);
}

function withListed(found: Verdict[], out: Answers): Verdict[] {
  for (let k = 0; k < out.rareCount; k++) {
    found[out.rareIndex[k] as number] = VERDICTS[out.rareVerdict[k] as number] as Verdict;
  }
  return found;
}

/**
 * Turns the answers of `both` into those of `first`. Chosen by a place in an array: on random rays
 * a branch is wrong too often.
 *
 * @param tMin in lengths of d, as tMax; either may be infinite.
 * @example
 * const out = createAnswers(1);
 * [out.t0[0], out.t1[0]] = [6, 14];
 * selectFirst(out, 1, 7, Infinity);
 * [out.t0[0], out.t1[0]]; // → [14, NaN]
 */
export function selectFirst(out: Answers, count: number, tMin: number, tMax: number): void {
  chooseFirst(out, 0, count, tMin, tMax);
  keepUnsettled(out);
}

/**
 * For kernels: the roots' part of `selectFirst`, for rays `from` to `to` − 1.
 *
 * @param tMin in lengths of d, as tMax; either may be infinite.
 * @example
 * const out = createAnswers(2);
 * out.t0.set([6, 6]);
 * out.t1.set([14, 14]);
 * chooseFirst(out, 1, 2, 7, Infinity);
 * [...out.t0, ...out.t1]; // → [6, 14, 14, NaN]
 */
export function chooseFirst(
  { t0, t1 }: Answers,
  from: number,
  to: number,
  tMin: number,
  tMax: number,
): void {
  const choice = Float64Array.of(Number.NaN, 0, 0);
  for (let i = from; i < to; i++) {
    const near = t0[i] as number;
    const far = t1[i] as number;
    const nearIsIn = Number(near >= tMin) & Number(near <= tMax);
    const farIsIn = Number(far >= tMin) & Number(far <= tMax);
    choice[1] = far;
    choice[2] = near;
    t0[i] = choice[(nearIsIn << 1) | (farIsIn & (nearIsIn ^ 1))] as number;
    t1[i] = Number.NaN;
  }
}

/**
 * For kernels: the list's part of `selectFirst`: 'contained' and 'undecided' stay on it.
 *
 * @example
 * const out = createAnswers(2);
 * list(out, 0, TANGENT);
 * list(out, 1, CONTAINED);
 * keepUnsettled(out);
 * [out.rareCount, out.rareIndex[0]]; // → [1, 1]
 */
export function keepUnsettled(out: Answers): void {
  const { rareIndex, rareVerdict } = out;
  let kept = 0;
  for (let k = 0; k < out.rareCount; k++) {
    const verdict = rareVerdict[k] as number;
    if (verdict < CONTAINED) continue;
    rareIndex[kept] = rareIndex[k] as number;
    rareVerdict[kept] = verdict;
    kept += 1;
  }
  out.rareCount = kept;
}
