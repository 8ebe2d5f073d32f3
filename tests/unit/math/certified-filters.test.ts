import { describe, expect, test } from 'vitest';
import { doubleDouble } from '../../../src/math/arithmetic/double-double.ts';
import {
  createAnswers,
  packRays,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../../src/math/batch/batch.ts';
import { batchOf } from '../../../src/math/batch/kernels.ts';
import { FAMILIES, findFamily, type Question } from '../../../src/math/families.ts';
import { scale } from '../../../src/math/float/bits.ts';
import { certified } from '../../../src/math/methods/certified.ts';
import { exact } from '../../../src/math/methods/exact.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { integer, type Random, randomSign, seeded, uniform, wide } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import { disagreement } from './against-exact.ts';

/** Both filters, by class only and by roots, against whole numbers. */
function filtersAgree({ shape, ray }: Question): void {
  const rays = packRays([ray]);
  const out = createAnswers(1);
  batchOf(exact, shape).both(rays, out);
  const [truth] = verdictsOfRoots(out, 1);
  const kernel = batchOf(certified, shape);
  kernel.classes(rays, out);
  const [byClasses] = verdictsOfClasses(out, 1, kernel.met);
  expect([JSON.stringify({ shape, ray }), byClasses, disagreement(shape, ray)]).toEqual([
    JSON.stringify({ shape, ray }),
    truth,
    null,
  ]);
}

const ulps = (random: Random, x: number, most: number): number =>
  x * (1 + integer(random, -most, most) * 2 ** -52);

/** A line that touches the shape at (cos φ, h, sin φ) but for `off` of its radius. */
function grazing(random: Random, off: number, size: number): Question {
  const flare = randomSign(random) * uniform(random, 0, 2);
  const radius = uniform(random, 0.5, 2);
  const phi = uniform(random, 0, 6.3);
  const [x, z] = [radius * (1 + off) * Math.cos(phi), radius * (1 + off) * Math.sin(phi)];
  const speed = uniform(random, 0.2, 3);
  const direction: Vec3 = [-speed * Math.sin(phi), 0, speed * Math.cos(phi)];
  const back = size * uniform(random, -1, 1);
  return {
    shape: { kind: 'hyperboloid', center: [0, 0, 0], flare, radius },
    ray: { origin: [x - back * direction[0], 0, z - back * direction[2]], direction },
  };
}

const N = 1500;
const adversaries: readonly [string, (random: Random) => Question][] = [
  [
    'grazing lines, off by a few ulps up to 1e-3',
    (r) => grazing(r, randomSign(r) * 10 ** uniform(r, -17, -3), 3),
  ],
  [
    'grazing lines from far away',
    (r) => grazing(r, randomSign(r) * 10 ** uniform(r, -12, -2), 10 ** uniform(r, 1, 12)),
  ],
  [
    'generators and rays a few ulps beside them: A cancels',
    (r) => {
      const slope = integer(r, 1, 8) / 4;
      return {
        shape: { kind: 'cone', vertex: [0, 0, 0], slope },
        ray: {
          origin: [uniform(r, -2, 2), uniform(r, -2, 2), uniform(r, -2, 2)],
          direction: [
            ulps(r, slope, 3),
            1,
            ulps(r, slope, 1) * (r() < 0.5 ? 0 : 2 ** -integer(r, 10, 60)),
          ],
        },
      };
    },
  ],
  [
    'E near the surface: C cancels',
    (r) => {
      const phi = uniform(r, 0, 6.3);
      return {
        shape: { kind: 'cylinder', center: [uniform(r, -1, 1), 0, uniform(r, -1, 1)], radius: 1 },
        ray: {
          origin: [ulps(r, Math.cos(phi), 40), 0, ulps(r, Math.sin(phi), 40)],
          direction: [uniform(r, -1, 1), 1, uniform(r, -1, 1)],
        },
      };
    },
  ],
  [
    'numbers at the edge of the box of the fast stages',
    (r) => {
      const edge = () => wide(r, -104, -96) * (r() < 0.5 ? 1 : 2 ** 200);
      return {
        shape: {
          kind: 'hyperboloid',
          center: [0, 0, 0],
          flare: wide(r, -210, 210),
          radius: Math.abs(edge()),
        },
        ray: { origin: [edge(), edge(), edge()], direction: [edge(), edge(), edge()] },
      };
    },
  ],
  [
    'underflow inside: everything small but what makes up for it',
    (r) => ({
      shape: {
        kind: 'hyperboloid',
        center: [0, 0, 0],
        flare: wide(r, 600, 1000),
        radius: Math.abs(wide(r, -240, -160)),
      },
      ray: { origin: [0, wide(r, -600, -520), wide(r, -200, -130)], direction: [1, 0, 0] },
    }),
  ],
  [
    'one coordinate far below the others',
    (r) => {
      const q = grazing(r, 0, 3);
      const origin: Vec3 = [q.ray.origin[0], wide(r, -1074, -20), q.ray.origin[2]];
      return { shape: q.shape, ray: { origin, direction: q.ray.direction } };
    },
  ],
  [
    'C loses bits in the subnormals, and a long d makes up for it',
    (r) => {
      const slope = uniform(r, 0.5, 1.5);
      const y = 2 ** -uniform(r, 529, 536);
      const x = slope * y * (1 + randomSign(r) * 2 ** -uniform(r, 8, 18));
      return {
        shape: { kind: 'cone', vertex: [0, 0, 0], slope },
        ray: { origin: [x, y, 0], direction: [0, 0, 2 ** integer(r, 200, 450)] },
      };
    },
  ],
  [
    'a plane nearly along the ray: N·d cancels to any share of its terms',
    (r) => {
      // ax + by with 52 bits and less is a double, so the third term makes up for it but for `off`.
      const [a, b, x] = [1, 2, 3].map(() => integer(r, 2 ** 25, 2 ** 26)) as [
        number,
        number,
        number,
      ];
      const y = -Math.round(((a * x) / b) * (1 + 2 ** -integer(r, 1, 20)));
      const off = 2 ** -integer(r, 5, 52);
      const origin: Vec3 = [uniform(r, -9, 9), uniform(r, -9, 9), uniform(r, -9, 9)];
      return {
        shape: { kind: 'plane', normal: [a, b, 1], point: [0, uniform(r, -9, 9), 0] },
        ray: { origin, direction: [x, y, -(a * x + b * y) * (1 + off)] },
      };
    },
  ],
  [
    'the same with full fractions: the last of three products cancels the others to 2^-60',
    (r) => {
      const { of, add, mul, toNumber } = doubleDouble();
      const [a, b, x, y] = [1, 2, 3, 4].map(() => uniform(r, 0.5, 1)) as [
        number,
        number,
        number,
        number,
      ];
      const sum = add(mul(of(a), of(x)), mul(of(b), of(y)));
      let best = { c: 1, z: 1, rest: 1 };
      for (let k = 0; k < 64; k++) {
        const c = uniform(r, 0.5, 1);
        const z = -toNumber(sum) / c;
        const rest = Math.abs(toNumber(add(sum, mul(of(c), of(z)))));
        if (rest < best.rest) best = { c, z, rest };
      }
      const origin: Vec3 = [uniform(r, -1, 1), uniform(r, -1, 1), uniform(r, -1, 1)];
      return {
        shape: { kind: 'plane', normal: [a, b, best.c], point: [0, uniform(r, -1, 1), 0] },
        ray: { origin, direction: [x, y, best.z] },
      };
    },
  ],
  [
    'E near a plane: N·p cancels to any share of its terms',
    (r) => {
      const normal: Vec3 = [uniform(r, 0.5, 1), uniform(r, 0.5, 1), uniform(r, 0.5, 1)];
      const [x, y] = [uniform(r, -1, 1), uniform(r, -1, 1)];
      const z = -(normal[0] * x + normal[1] * y) / normal[2];
      const direction: Vec3 = [uniform(r, -1, 1), uniform(r, -1, 1), uniform(r, -1, 1)];
      return {
        shape: { kind: 'plane', normal, point: [0, 0, 0] },
        ray: { origin: [x, y, z * (1 + 2 ** -uniform(r, 5, 53))], direction },
      };
    },
  ],
  [
    'N·p cancels, and the root is a double just below a power of two',
    (r) => {
      const t = 1 - 2 ** -integer(r, 4, 20);
      const d: Vec3 = [Math.fround(uniform(r, 0.5, 1)), Math.fround(uniform(r, 0.5, 1)), 0];
      const bits = 2 ** integer(r, 10, 24);
      const level = Math.round(uniform(r, 0.5, 1) * bits) / bits;
      const normal: Vec3 = [uniform(r, 0.5, 1), 0, 0];
      const third = -Math.round(((normal[0] * d[0]) / level) * bits) / bits;
      const direction: Vec3 = [d[0], d[1] * 2 ** -integer(r, 1, 40), third];
      return {
        shape: { kind: 'plane', normal: [normal[0], uniform(r, 0.5, 1), level], point: [0, 0, 0] },
        ray: { origin: direction.map((c) => -t * c) as unknown as Vec3, direction },
      };
    },
  ],
  [
    'a circle and a square far beside E: w cancels',
    (r) => {
      const direction: Vec3 = [uniform(r, 0.5, 1), uniform(r, 0.5, 1), uniform(r, 0.5, 1)];
      const t = 2 ** uniform(r, 5, 45);
      const origin = direction.map((x) => -t * x) as unknown as Vec3;
      const side = 2 ** -uniform(r, 5, 50) * t;
      return {
        shape:
          r() < 0.5
            ? { kind: 'circle', normal: [1, uniform(r, 0, 1), 2], center: [0, 0, 0], radius: side }
            : { kind: 'square', corner: [0, -side / 2, -side / 2], side, axis: 'x' },
        ray: { origin, direction },
      };
    },
  ],
  [
    'a disc as small as what its centre is off the line: w may round to 0',
    (r) => {
      const direction: Vec3 = [uniform(r, 0.5, 1), uniform(r, 0.5, 1), uniform(r, 0.5, 1)];
      const t = uniform(r, 1, 2);
      return {
        shape: {
          kind: 'circle',
          normal: [0, 0, 1],
          center: [0, 0, 0],
          radius: 2 ** -uniform(r, 51, 57),
        },
        ray: { origin: direction.map((x) => -t * x) as unknown as Vec3, direction },
      };
    },
  ],
  [
    'figures of any size, the line through their rim or edge but for a few ulps',
    (r) => {
      const [h, g] = [2 ** integer(r, -99, 99), 2 ** integer(r, -99, 99)];
      const along = uniform(r, 1, 2) * 2 ** integer(r, -99, 99);
      const reach = ulps(r, (h / g) * along, 2) * (r() < 0.1 ? 2 ** integer(r, -700, 700) : 1);
      const ray: Ray = { origin: [0, 0, h], direction: [along, 0, -g] };
      const size = Math.min(reach, Number.MAX_VALUE);
      return {
        ray,
        shape:
          r() < 0.5
            ? { kind: 'circle', normal: [0, 0, 1], center: [0, 0, 0], radius: size }
            : { kind: 'square', corner: [0, 0, 0], side: size, axis: 'z' },
      };
    },
  ],
  [
    'the squares of d lose bits in the subnormals, and lengths make up for it',
    (r) => {
      const phi = uniform(r, 0, 6.3);
      const speed = 2 ** -integer(r, 525, 538);
      const far = 2 ** (r() < 0.5 ? integer(r, 90, 99) : integer(r, 99, 480));
      const [c, s] = [Math.cos(phi), Math.sin(phi)];
      const beside = 1 + uniform(r, -0.3, 0.3);
      const [x, z] = [far * (c * 2 - s * beside), far * (s * 2 + c * beside)];
      const hyperboloid = r() < 0.5;
      return {
        shape: hyperboloid
          ? {
              kind: 'hyperboloid',
              center: [x, 0, z],
              flare: uniform(r, -2, 2),
              radius: Math.min(far, 2 ** 99),
            }
          : { kind: 'cylinder', center: [x, 0, z], radius: Math.min(far, 2 ** 99) },
        ray: {
          origin: [0, 0, 0],
          direction: [speed * c, r() < 0.5 ? 0 : speed * uniform(r, -1, 1), speed * s],
        },
      };
    },
  ],
  [
    'rim and edge by a few ulps',
    (r) => {
      const [a, b] = [ulps(r, 3, 2), ulps(r, 4, 2)];
      const down: Ray = { origin: [a, b, 2], direction: [2 ** -integer(r, 45, 60), 0, -1] };
      const circle: Shape = {
        kind: 'circle',
        normal: [0, 0, ulps(r, 3, 9)],
        center: [0, 0, 0],
        radius: ulps(r, 5, 2),
      };
      const square: Shape = { kind: 'square', corner: [-1, 4, 0], side: ulps(r, 4, 2), axis: 'z' };
      return { shape: r() < 0.5 ? circle : square, ray: down };
    },
  ],
];

describe(`what a filter certifies is never wrong (${N} rays each, seed 31)`, () => {
  test.each(adversaries)('%s', (_, make) => {
    const random = seeded(31);
    for (let k = 0; k < N; k++) filtersAgree(make(random));
  });

  test('the trap: a·(py·py) underflows where (a·py)·py does not', () => {
    const shape: Shape = {
      kind: 'hyperboloid',
      center: [0, 0, 0],
      flare: 1e150 ** 2,
      radius: 1e-60,
    };
    filtersAgree({ shape, ray: { origin: [0, 1e-170, 1e-50], direction: [1, 0, 0] } });
  });
});

/** Numbers of a question, each replaced. */
function each(q: Question, length: (x: number) => number, speed: (x: number) => number): Question {
  const entries = Object.entries(q.shape).map(([key, x]): [string, unknown] => {
    if (key === 'slope' || key === 'flare' || key === 'normal' || typeof x === 'string')
      return [key, x];
    return [key, Array.isArray(x) ? x.map(length) : length(x as number)];
  });
  return {
    shape: Object.fromEntries(entries) as unknown as Shape,
    ray: {
      origin: q.ray.origin.map(length) as unknown as Vec3,
      direction: q.ray.direction.map(speed) as unknown as Vec3,
    },
  };
}

const roots = (method: Pick<typeof exact, 'intersect'>, { shape, ray }: Question) => {
  const { class: verdict, hits } = method.intersect(shape, ray);
  return { verdict, ts: hits.map(({ t }) => t) };
};

describe('exact relations (typical, far, grazing and flat families, seed 41)', () => {
  const random = seeded(41);
  const questions = [
    'typical',
    'far-origin',
    'near-tangent',
    'exact-tangent',
    'circle-rim',
    'square',
    'degenerate',
  ]
    .map((id) => findFamily(id) ?? FAMILIES()[0])
    .flatMap((family) => Array.from({ length: 60 }, () => family?.make(random) as Question));

  /** `certified` may take the other neighbour: its class is compared, and its roots with exact. */
  const check = (q: Question, other: Question, t: (x: number) => number): void => {
    const before = roots(exact, q);
    expect(roots(exact, other)).toEqual({
      verdict: before.verdict,
      ts: before.ts.map(t).sort((a, b) => a - b),
    });
    expect(roots(certified, other).verdict).toBe(before.verdict);
    expect(disagreement(other.shape, other.ray)).toBeNull();
  };
  const same = (x: number): number => x;

  test.each([-300, -7, 1, 300])('d · 2^%i divides t by it', (k) => {
    for (const q of questions)
      check(
        q,
        each(q, same, (x) => scale(x, k)),
        (t) => scale(t, -k),
      );
  });
  test.each([-200, 3, 200])('the world · 2^%i multiplies t by it', (k) => {
    for (const q of questions)
      check(
        q,
        each(q, (x) => scale(x, k), same),
        (t) => scale(t, k),
      );
  });
  test('−d mirrors t', () => {
    for (const q of questions)
      check(
        q,
        each(q, same, (x) => -x),
        (t) => 0 - t,
      );
  });
  test('x and z change places', () => {
    const swap = ([x, y, z]: Vec3): Vec3 => [z, y, x];
    const axes = { x: 'z', y: 'y', z: 'x' } as const;
    for (const { shape, ray } of questions) {
      const entries = Object.entries(shape).map(([key, x]): [string, unknown] => {
        if (key === 'axis') return [key, axes[x as 'x' | 'y' | 'z']];
        return [key, Array.isArray(x) ? swap(x as unknown as Vec3) : x];
      });
      const other = {
        shape: Object.fromEntries(entries) as unknown as Shape,
        ray: { origin: swap(ray.origin), direction: swap(ray.direction) },
      };
      check({ shape, ray }, other, same);
    }
  });
});
