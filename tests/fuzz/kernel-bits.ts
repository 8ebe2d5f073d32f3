import { accelerate, decelerate } from '../../src/math/accelerate.ts';
import {
  type Answers,
  createAnswers,
  type Kernel,
  packRays,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../src/math/batch/batch.ts';
import { batchOf } from '../../src/math/batch/kernels.ts';
import type { Target } from '../../src/math/batch/target.ts';
import type { Question } from '../../src/math/families.ts';
import type { Intersection } from '../../src/math/intersection.ts';
import type { Method } from '../../src/math/methods/define.ts';
import { METHODS } from '../../src/math/methods/index.ts';
import { intersectBy } from '../../src/math/methods/tree-method.ts';
import type { MethodParts } from '../../src/math/methods/tree-parts.ts';
import type { Ray } from '../../src/math/ray.ts';
import { integer, pick, type Random } from '../../src/math/rng.ts';
import type { Shape } from '../../src/math/shapes/index.ts';
import { inUnits } from '../unit/math/whole-scenes.ts';
import { besides } from './unlike.ts';

/*
 * Methods that are made of trees: what is made of their trees (the object, the batch in TypeScript
 * and in WebAssembly) against the trees themselves, walked. NaN payloads aside, to the bit.
 */

const TARGETS: readonly Target[] = ['typescript', 'simd'];
/** More than two vectors of float32, and an odd number. */
const COUNT = 9;
const WINDOWS = [
  [0, Number.POSITIVE_INFINITY],
  [-1, 2],
] as const;

const walking = <T>(parts: MethodParts<T>, method: Method): Method => ({
  ...method,
  intersect: (shape, ray) => intersectBy(parts, shape, ray),
});

/** The methods, each with its tree. */
const WALKED: readonly { readonly method: Method; readonly tree: Method }[] = METHODS.flatMap(
  (method: Method) =>
    method.parts && method.id !== 'exact'
      ? [
          {
            method,
            tree: method.parts(({ arithmetic, form, solver }) =>
              walking({ arithmetic, form, solver, decidedBy: 'formula', id: method.id }, method),
            ),
          },
        ]
      : [],
);

/**
 * The exponents at which loops hand rays on: of inputs, of A and D, of roots; and where float32 and
 * float64 end.
 */
const LIMITS = [100, 60, 126, 128, 149, 150, 500, 511, 900, 1022, 1074] as const;

/** The question in units near one of the limits, or as it is. */
export function atKernelLimits(question: Question, random: Random): Question {
  if (random() < 0.4) return question;
  const near = (): number =>
    Math.round((pick(random, [1, -1]) * pick(random, LIMITS)) / pick(random, [1, 2, 4])) +
    integer(random, -2, 2);
  const length = random() < 0.3 ? 0 : near();
  const speed = pick(random, [0, near(), length - near(), -length]);
  const inRange = (k: number): number => Math.max(-1074, Math.min(1023, k));
  return inUnits(question, inRange(length), inRange(speed));
}

const text = (x: number | undefined): string => (Object.is(x, -0) ? '-0' : String(x));

/** All that an answer says but for who says it; zeros with their sign. */
const written = (found: Intersection): string =>
  JSON.stringify(found, (key, x) =>
    key === 'method' || key === 'decidedBy' ? undefined : typeof x === 'number' ? text(x) : x,
  );

interface Told {
  readonly classes: string[];
  readonly roots: string[];
  readonly firsts: string[][];
}

function byTree(tree: Method, shape: Shape, rays: readonly Ray[]): Told {
  const found = rays.map((ray) => tree.intersect(shape, ray));
  const rootsOf = ({ hits }: Intersection): number[] => hits.map(({ t }) => t);
  return {
    classes: found.map((one) => one.class),
    roots: found.map((one) => [one.class, ...rootsOf(one).map(text)].join(' ')),
    firsts: WINDOWS.map(([from, to]) =>
      found.map((one) => text(rootsOf(one).find((t) => t >= from && t <= to) ?? Number.NaN)),
    ),
  };
}

function byKernel(kernel: Kernel, list: readonly Ray[]): Told {
  const rays = packRays(list);
  const out: Answers = createAnswers(list.length);
  kernel.classes(rays, out);
  const classes = verdictsOfClasses(out, list.length, kernel.met);
  kernel.both(rays, out);
  const roots = verdictsOfRoots(out, list.length).map((verdict, i) =>
    [verdict, ...[out.t0[i], out.t1[i]].filter((t) => !Number.isNaN(t)).map((t) => text(t))].join(
      ' ',
    ),
  );
  const firsts = WINDOWS.map(([from, to]) => {
    kernel.first(rays, from, to, out);
    return Array.from(out.t0.subarray(0, list.length), text);
  });
  return { classes, roots, firsts };
}

const firstUnlike = (a: readonly string[], b: readonly string[]): number =>
  a.findIndex((x, i) => x !== b[i]);

/** Where a method and its tree differ in a bit, in words; null where they do not. */
export function unlikeTrees({ shape, ray }: Question): string | null {
  if (ray.direction.every((x) => x === 0)) return null;
  const rays = besides(ray, COUNT);
  accelerate();
  try {
    for (const { method, tree } of WALKED) {
      const walked = written(tree.intersect(shape, ray));
      const object = written(method.intersect(shape, ray));
      if (object !== walked) return `${method.id}: ${object} as an object, its tree ${walked}`;
      const want = byTree(tree, shape, rays);
      for (const target of TARGETS) {
        const got = byKernel(batchOf(method, shape, target), rays);
        for (const [what, a, b] of [
          ['classes', want.classes, got.classes],
          ['both', want.roots, got.roots],
          ...WINDOWS.map((_, k) => ['first', want.firsts[k], got.firsts[k]] as const),
        ] as const) {
          const k = firstUnlike(a as string[], b as string[]);
          if (k < 0) continue;
          const at = JSON.stringify({ shape, ray: rays[k] });
          return `${method.id}, ${what} in ${target}, ${at}: ${b?.[k]}, its tree ${a?.[k]}`;
        }
      }
    }
    return null;
  } finally {
    decelerate();
  }
}
