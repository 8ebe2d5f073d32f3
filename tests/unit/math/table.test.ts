import { describe, expect, test } from 'vitest';
import { coefficients, intersect } from '../../../src/math/index.ts';
import type { Hit, IntersectionClass } from '../../../src/math/intersection.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import {
  circle,
  cone,
  curvedDetails,
  cylinder,
  flatDetails,
  hyperboloid,
  METHOD_IDS,
  plane,
  ray,
  square,
} from './shorthand.ts';

/*
 * Every line of the table in docs/NUMERICS.md, in numbers that can be followed by hand: small whole
 * numbers, halves and quarters, so that no method has anything to round, not even in float32. p = E
 * − C throughout.
 */

type HandHit = readonly [t: number, P: Vec3, N: Vec3];

interface Line {
  readonly name: string;
  readonly shape: Shape;
  readonly ray: Ray;
  readonly class: IntersectionClass;
  readonly hits: readonly HandHit[];
}

interface CurvedLine extends Line {
  readonly ABCD: readonly [number, number, number, number];
}

interface FlatLine extends Line {
  /** N·(E − P) and N·d. */
  readonly offset: number;
  readonly rate: number;
  /** Where the plane is met, if the figure is not. */
  readonly missed?: HandHit;
}

const CURVED: readonly CurvedLine[] = [
  {
    // p = (4, −6, 0), d = (−1, ½, 0). A = 1 + 0; B = 2(−1)4 + 0 = −8; C = 16 + 0 − 4 = 12; D = 64 −
    // 48 = 16; t = (8 ± 4)/2.
    name: 'cylinder, straight through its axis',
    shape: cylinder([1, 7, 2], 2),
    ray: ray([5, 1, 2], [-1, 0.5, 0]),
    ABCD: [1, -8, 12, 16],
    class: 'two',
    hits: [
      [2, [3, 2, 2], [2, 0, 0]],
      [6, [-1, 4, 2], [-2, 0, 0]],
    ],
  },
  {
    // p = (4, ·, −1), d = (1, 2, 1). A = 1 + 1; B = 2·1·4 + 2·1·(−1) = 6; C = 16 + 1 − 25 = −8; D =
    // 36 + 64 = 100; t = (−6 ± 10)/4. E is inside.
    name: 'cylinder, from inside, askew',
    shape: cylinder([1, 0, -1], 5),
    ray: ray([5, 0, -2], [1, 2, 1]),
    ABCD: [2, 6, -8, 100],
    class: 'two',
    hits: [
      [-4, [1, -8, -6], [0, 0, -5]],
      [1, [6, 2, -1], [5, 0, 0]],
    ],
  },
  {
    // p = (2, 3, 5), d = (0, 1, −2). A = 4; B = 2(−2)5 = −20; C = 4 + 25 − 4 = 25; D = 400 − 400 =
    // 0; t = 20/8.
    name: 'cylinder, tangent',
    shape: cylinder([0, 0, 0], 2),
    ray: ray([2, 3, 5], [0, 1, -2]),
    ABCD: [4, -20, 25, 0],
    class: 'tangent',
    hits: [[2.5, [2, 5.5, 0], [2, 0, 0]]],
  },
  {
    // As above one farther out: C = 9 + 25 − 4 = 30; D = 400 − 480 = −80.
    name: 'cylinder, missed',
    shape: cylinder([0, 0, 0], 2),
    ray: ray([3, 3, 5], [0, 1, -2]),
    ABCD: [4, -20, 30, -80],
    class: 'none',
    hits: [],
  },
  {
    // c² = ¼, p = (4, 4, 0), d = (−1, 0, 0). A = 1; B = −8; C = 16 − ¼·16 = 12; D = 64 − 48 = 16; t
    // = (8 ± 4)/2. N = (x, −¼·4, z).
    name: 'cone, level ray',
    shape: cone([0, 0, 0], 0.5),
    ray: ray([4, 4, 0], [-1, 0, 0]),
    ABCD: [1, -8, 12, 16],
    class: 'two',
    hits: [
      [2, [2, 4, 0], [2, -1, 0]],
      [6, [-2, 4, 0], [-2, -1, 0]],
    ],
  },
  {
    // c² = 4, p = (3, 2, 2), d = (1, 1, 2). A = 1 + 4 − 4·1 = 1; B = 2·1·3 + 2·2·2 − 2·4·1·2 = 6 +
    // 8 − 16 = −2; C = 9 + 4 − 4·4 = −3; D = 4 + 12 = 16; t = (2 ± 4)/2. N = (x − 1, −4(y + 1), z).
    name: 'cone, askew, vertex away from the origin',
    shape: cone([1, -1, 0], 2),
    ray: ray([4, 1, 2], [1, 1, 2]),
    ABCD: [1, -2, -3, 16],
    class: 'two',
    hits: [
      [-1, [3, 0, 0], [2, -4, 0]],
      [3, [7, 4, 8], [6, -20, 8]],
    ],
  },
  {
    // The same numbers with c = −2: only c² counts, the radius at height h is |c h|.
    name: 'cone with a negative slope',
    shape: cone([1, -1, 0], -2),
    ray: ray([4, 1, 2], [1, 1, 2]),
    ABCD: [1, -2, -3, 16],
    class: 'two',
    hits: [
      [-1, [3, 0, 0], [2, -4, 0]],
      [3, [7, 4, 8], [6, -20, 8]],
    ],
  },
  {
    // c² = 4, p = (5, −1, 0), d = (1, 1, 0). A = 1 − 4 = −3; B = 10 − 2·4·1·(−1) = 18; C = 25 − 4 =
    // 21; D = 324 + 252 = 576 = 24²; t = (−18 ± 24)/(−6): A < 0 turns the two around. One hit on
    // each nappe.
    name: 'cone, both nappes, A < 0',
    shape: cone([0, 0, 0], 2),
    ray: ray([5, -1, 0], [1, 1, 0]),
    ABCD: [-3, 18, 21, 576],
    class: 'two',
    hits: [
      [-1, [4, -2, 0], [4, 8, 0]],
      [7, [12, 6, 0], [12, -24, 0]],
    ],
  },
  {
    // c = 1, p = (3, 1, 0), d = (1, 1, 0), parallel to a generator. A = 1 − 1 = 0; B = 6 − 2 = 4; C
    // = 9 − 1 = 8; t = −C/B.
    name: 'cone, A = 0, one root',
    shape: cone([0, 0, 0], 1),
    ray: ray([3, 1, 0], [1, 1, 0]),
    ABCD: [0, 4, 8, 16],
    class: 'one',
    hits: [[-2, [1, -1, 0], [1, 1, 0]]],
  },
  {
    // c = 1, p = (2, 2, 3), d = (1, 1, 0). A = 0; B = 4 − 4 = 0; C = 4 + 9 − 4 = 9 everywhere along
    // the ray.
    name: 'cone, A = B = 0, none',
    shape: cone([0, 0, 0], 1),
    ray: ray([2, 2, 3], [1, 1, 0]),
    ABCD: [0, 0, 9, 0],
    class: 'none',
    hits: [],
  },
  {
    // c = 1, p = (2, 2, 0), d = (1, 1, 0): the ray is the generator. A = B = C = 0.
    name: 'cone, the ray lies in it',
    shape: cone([0, 0, 0], 1),
    ray: ray([2, 2, 0], [1, 1, 0]),
    ABCD: [0, 0, 0, 0],
    class: 'contained',
    hits: [],
  },
  {
    // a = 1, r = 1, p = (−3, 2, 2), d = (1, 0, 0). A = 1; B = −6; C = 9 + 4 − 1·4 − 1 = 8; D = 36 −
    // 32 = 4; t = (6 ± 2)/2. N = (x − 1, −(y + 1), z − 2).
    name: 'hyperboloid, level ray',
    shape: hyperboloid([1, -1, 2], 1, 1),
    ray: ray([-2, 1, 4], [1, 0, 0]),
    ABCD: [1, -6, 8, 4],
    class: 'two',
    hits: [
      [2, [0, 1, 4], [-1, -2, 2]],
      [4, [2, 1, 4], [1, -2, 2]],
    ],
  },
  {
    // a = ½, r = 2¼, p = (1, −2, 1¼), d = (2, 2, 0). A = 4 − ½·4 = 2; B = 2·2·1 − 2·½·2·(−2) = 4 +
    // 4 = 8; C = 1 + 25/16 − ½·4 − 81/16 = −4½; D = 64 + 36 = 100; t = (−8 ± 10)/4. N = (x, −½(y −
    // 1), z + 1).
    name: 'hyperboloid, askew, a and r no whole numbers',
    shape: hyperboloid([0, 1, -1], 0.5, 2.25),
    ray: ray([1, -1, 0.25], [2, 2, 0]),
    ABCD: [2, 8, -4.5, 100],
    class: 'two',
    hits: [
      [-4.5, [-8, -10, 0.25], [-8, 5.5, 1.25]],
      [0.5, [2, 0, 0.25], [2, 0.5, 1.25]],
    ],
  },
  {
    // a = −1, r = 3 is a sphere. p = (2, 5, 1), d = (0, −1, 0). A = 0 + 1 = 1; B = −2(−1)(−1)5 =
    // −10; C = 4 + 1 + 25 − 9 = 21; D = 100 − 84 = 16; t = (10 ± 4)/2. N = (x, y − 1, z).
    name: 'hyperboloid with a = −1: a sphere',
    shape: hyperboloid([0, 1, 0], -1, 3),
    ray: ray([2, 6, 1], [0, -1, 0]),
    ABCD: [1, -10, 21, 16],
    class: 'two',
    hits: [
      [3, [2, 3, 1], [2, 2, 1]],
      [7, [2, -1, 1], [2, -2, 1]],
    ],
  },
  {
    // a = 1, r = 1, p = (1, 0, 0), d = (0, 1, 1): a ruling through the waist. A = 1 − 1; B = 0; C =
    // 1 − 1.
    name: 'hyperboloid, the ray is one of its rulings',
    shape: hyperboloid([0, 0, 0], 1, 1),
    ray: ray([1, 0, 0], [0, 1, 1]),
    ABCD: [0, 0, 0, 0],
    class: 'contained',
    hits: [],
  },
];

const FLAT: readonly FlatLine[] = [
  {
    // E − P = (4, 2, 3). N·(E−P) = 4 + 4 + 6 = 14; N·d = −1 − 2 − 4 = −7; t = −14/−7.
    name: 'plane',
    shape: plane([1, 2, 2], [1, 0, 0]),
    ray: ray([5, 2, 3], [-1, -1, -2]),
    offset: 14,
    rate: -7,
    class: 'one',
    hits: [[2, [3, 0, -1], [1, 2, 2]]],
  },
  {
    // 0x + 2y + 0z + 2 = 0, the plane y = −1: N = (0, 2, 0), P = (0, −1, 0). N·(E−P) = 8; N·d = −4.
    name: 'plane given by Ax + By + Cz + D = 0',
    shape: plane([0, 2, 0], [0, -1, 0]),
    ray: ray([0, 3, 0], [1, -2, 4]),
    offset: 8,
    rate: -4,
    class: 'one',
    hits: [[2, [2, -1, 8], [0, 2, 0]]],
  },
  {
    // E − P = (1, 0, −3): N·(E−P) = 2 + 0 + 3 = 5; N·d = 2 + 0 + 0 = 2; t = −5/2: behind E.
    name: 'plane behind E',
    shape: plane([2, 0, -1], [0, 1, 3]),
    ray: ray([1, 1, 0], [1, 1, 0]),
    offset: 5,
    rate: 2,
    class: 'one',
    hits: [[-2.5, [-1.5, -1.5, 0], [2, 0, -1]]],
  },
  {
    // N·(E−C) = 2(1 − 5) = −8; N·d = 4; t = 2: (4, 5, 5), from C by (3, 4, 0), and 5 ≤ 5: the rim
    // is inside.
    name: 'circle, on its rim',
    shape: circle([0, 0, 2], [1, 1, 5], 5),
    ray: ray([0, 0, 1], [2, 2.5, 2]),
    offset: -8,
    rate: 4,
    class: 'one',
    hits: [[2, [4, 5, 5], [0, 0, 2]]],
  },
  {
    // The same, but 5 > 4½.
    name: 'circle, outside',
    shape: circle([0, 0, 2], [1, 1, 5], 4.5),
    ray: ray([0, 0, 1], [2, 2.5, 2]),
    offset: -8,
    rate: 4,
    class: 'none',
    hits: [],
    missed: [2, [4, 5, 5], [0, 0, 2]],
  },
  {
    // N = (1, 0, 1), askew: N·E = 2, N·d = −1, t = 2: (2, 1, −2), 3 from the centre, and 3 ≤ 4.
    name: 'circle in a tilted plane',
    shape: circle([1, 0, 1], [0, 0, 0], 4),
    ray: ray([2, 1, 0], [0, 0, -1]),
    offset: 2,
    rate: -1,
    class: 'one',
    hits: [[2, [2, 1, -2], [1, 0, 1]]],
  },
  {
    // z = 3: 7 − 2t = 3, t = 2: (2½, 3, 3); 1 ≤ 2½ ≤ 3 and 2 ≤ 3 ≤ 4.
    name: 'square with normal z',
    shape: square([1, 2, 3], 2, 'z'),
    ray: ray([2, 3, 7], [0.25, 0, -2]),
    offset: 4,
    rate: -2,
    class: 'one',
    hits: [[2, [2.5, 3, 3], [0, 0, 1]]],
  },
  {
    // x = 1: −1 + t = 1, t = 2: (1, 3, 4); 2 ≤ 3 ≤ 4 and 3 ≤ 4 ≤ 5.
    name: 'square with normal x',
    shape: square([1, 2, 3], 2, 'x'),
    ray: ray([-1, 4, 2], [1, -0.5, 1]),
    offset: -2,
    rate: 1,
    class: 'one',
    hits: [[2, [1, 3, 4], [1, 0, 0]]],
  },
  {
    // y = 2: 6 − t = 2, t = 4: (2, 2, 4); 1 ≤ 2 ≤ 3 and 3 ≤ 4 ≤ 5.
    name: 'square with normal y',
    shape: square([1, 2, 3], 2, 'y'),
    ray: ray([0, 6, 0], [0.5, -1, 1]),
    offset: 4,
    rate: -1,
    class: 'one',
    hits: [[4, [2, 2, 4], [0, 1, 0]]],
  },
  {
    // (2, 2, 6): x is within [1, 3], but z = 6 is beyond 5.
    name: 'square with normal y, outside in z only',
    shape: square([1, 2, 3], 2, 'y'),
    ray: ray([0, 6, 2], [0.5, -1, 1]),
    offset: 4,
    rate: -1,
    class: 'none',
    hits: [],
    missed: [4, [2, 2, 6], [0, 1, 0]],
  },
  {
    // (5, 2, 4): z is within [3, 5], but x = 5 is beyond 3.
    name: 'square with normal y, outside in x only',
    shape: square([1, 2, 3], 2, 'y'),
    ray: ray([3, 6, 0], [0.5, -1, 1]),
    offset: 4,
    rate: -1,
    class: 'none',
    hits: [],
    missed: [4, [5, 2, 4], [0, 1, 0]],
  },
];

/**
 * An interval may not be able to tell a zero from its neighbours; every other method must answer.
 */
const mayDoubt = (method: string, line: Line): boolean =>
  method === 'interval' && !(line.class === 'two' || line.class === 'one');

/** A method may work out points and normals when they are read: they are compared as values. */
const plain = ({ t, point, normal, singular }: Hit): Hit => ({ t, point, normal, singular });

const asHits = (hits: readonly HandHit[]) =>
  hits.map(([t, point, normal]) => ({ t, point, normal, singular: false }));

describe.each(METHOD_IDS)('%s', (method) => {
  test.each(CURVED)('$name', (line) => {
    const [A, B, C, D] = line.ABCD;
    expect(coefficients(line.shape, line.ray, method)).toEqual({ A, B, C });
    const found = intersect(line.shape, line.ray, method);
    if (found.class === 'undecided' && mayDoubt(method, line)) return;
    expect([found.class, found.method]).toEqual([line.class, method]);
    expect(found.hits.map(plain)).toEqual(asHits(line.hits));
    const details = curvedDetails(found);
    expect([details.A, details.B, details.C, details.D]).toEqual([A, B, C, D]);
    const { signs } = details;
    expect([signs.A, signs.B, signs.C, signs.D]).toEqual([A, B, C, D].map(Math.sign));
  });

  test.each(FLAT)('$name', (line) => {
    const { offset, rate } = line;
    expect(coefficients(line.shape, line.ray, method)).toEqual({ A: 0, B: rate, C: offset });
    const found = intersect(line.shape, line.ray, method);
    if (found.class === 'undecided' && mayDoubt(method, line)) return;
    expect([found.class, found.method]).toEqual([line.class, method]);
    expect(found.hits.map(plain)).toEqual(asHits(line.hits));
    expect(flatDetails(found)).toMatchObject({
      offset,
      rate,
      signs: { offset: Math.sign(offset), rate: Math.sign(rate) },
      meetsFigure: null,
    });
    const [t, point, normal] = line.hits[0] ?? line.missed ?? [];
    expect(flatDetails(found).plane).toMatchObject({
      t,
      point,
      normal,
      inside: line.missed === undefined,
    });
  });
});

describe('the table says of itself', () => {
  test.each([...CURVED, ...FLAT])('$name: each point is E + t d', (line) => {
    const { origin, direction } = line.ray;
    for (const [t, point] of line.hits) {
      expect(point).toEqual(origin.map((e, i) => e + t * (direction[i] ?? 0)));
    }
  });

  test('that every shape is in it', () => {
    const kinds = new Set([...CURVED, ...FLAT].map(({ shape }) => shape.kind));
    expect([...kinds].sort()).toEqual([
      'circle',
      'cone',
      'cylinder',
      'hyperboloid',
      'plane',
      'square',
    ]);
  });
});
