import { accelerate, decelerate } from '../../src/math/accelerate.ts';
import { createAnswers, packRays, verdictsOfRoots } from '../../src/math/batch/batch.ts';
import { batchOf } from '../../src/math/batch/kernels.ts';
import type { Question } from '../../src/math/families.ts';
import { createHit, type PreparedHit, prepare } from '../../src/math/index.ts';
import { certified } from '../../src/math/methods/certified.ts';
import type { Ray } from '../../src/math/ray.ts';

/** More than WebAssembly takes at least, and an odd number of them. */
const COUNT = 17;

/**
 * The ray, and others beside it: each with one number changed a little more than in the one before.
 */
export const besides = ({ origin, direction }: Ray, count = COUNT): Ray[] =>
  Array.from({ length: count }, (_, k) => {
    const numbers = [...origin, ...direction];
    const at = k % 6;
    const bent = (numbers[at] as number) * (1 + k * 2 ** -12);
    if (Number.isFinite(bent) && (at < 3 || bent !== 0)) numbers[at] = bent;
    const [ex, ey, ez, dx, dy, dz] = numbers as [number, number, number, number, number, number];
    return { origin: [ex, ey, ez], direction: [dx, dy, dz] };
  });

function answersOf({ shape, ray }: Question): string[] {
  const kernel = batchOf(certified, shape);
  const rays = packRays(besides(ray));
  const out = createAnswers(COUNT);
  kernel.both(rays, out);
  const verdicts = verdictsOfRoots(out, COUNT);
  const text = (t: number | undefined): string => (Object.is(t, -0) ? '-0' : String(t));
  return verdicts.map((verdict, k) => `${verdict} ${text(out.t0[k])} ${text(out.t1[k])}`);
}

/**
 * Where a batch by WebAssembly and one by TypeScript differ in a bit, in words; null where they do
 * not.
 */
export function unlike(question: Question): string | null {
  decelerate();
  const plain = answersOf(question);
  accelerate();
  const fast = answersOf(question);
  decelerate();
  const k = plain.findIndex((answer, i) => answer !== fast[i]);
  return k < 0
    ? null
    : `${JSON.stringify({ shape: question.shape, ray: besides(question.ray)[k] })}: ` +
        `${fast[k]} by WebAssembly, ${plain[k]} without`;
}

const WINDOWS = [
  {},
  { tMin: Number.NEGATIVE_INFINITY },
  { tMin: 0.5, tMax: 2 },
  { tMin: -1, tMax: 0 },
] as const;

/** All of a hit, zeros with their sign. */
const written = (hit: PreparedHit | null | undefined): string =>
  JSON.stringify(hit ?? null, (_, x) => (Object.is(x, -0) ? '-0' : Number.isNaN(x) ? 'NaN' : x));

/**
 * Where `first`, which solves the root that it needs, differs in a bit from the first one of `all`,
 * which has both; or `any`, which may need none. In words; null where they do not.
 */
export function unlikeAll({ shape, ray }: Question): string | null {
  for (const window of WINDOWS) {
    const one = prepare(shape, window);
    for (const near of besides(ray, 5)) {
      const wanted = written(one.all(near).find(({ fate }) => fate !== 'cut'));
      const at = JSON.stringify({ shape, ray: near, window });
      const found = written(one.first(near));
      const put = written(one.first(near, createHit()));
      if (found !== wanted || put !== wanted) return `first ${found}, of all ${wanted}: ${at}`;
      if (one.any(near) !== (wanted !== 'null')) return `any is not so: ${at}`;
    }
  }
  return null;
}
