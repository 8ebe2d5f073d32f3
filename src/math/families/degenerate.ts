import { integer, pick } from '../rng.ts';
import type { Axis, Vec3 } from '../vec3.ts';
import { type Axial, coneOf, cylinderOf, hyperboloidOf } from './axial.ts';
import type { FamilyParts, Setting } from './define.ts';
import { cross, type Draw, type NonEmpty, nonZero, plus, wholeVector } from './random-vectors.ts';

const SMALL_CURVED: NonEmpty<Draw<Axial>> = [
  (random) => cylinderOf(wholeVector(random, 2), integer(random, 0, 2)),
  (random) => coneOf(wholeVector(random, 2), integer(random, -2, 2) / 2),
  (random) =>
    hyperboloidOf(wholeVector(random, 2), integer(random, -4, 4) / 4, integer(random, 0, 2)),
];

export const degenerate: FamilyParts<Axial> = {
  id: 'degenerate',
  hardness: 'special',
  title: 'small whole numbers',
  idea:
    'Coordinates from −2 to 2, with c, r and a that may be 0: every special case happens, ' +
    'and nothing rounds.',
  dial: null,
  setting: (random) => pick(random, SMALL_CURVED)(random),
  ray: (random) => ({
    origin: wholeVector(random, 2),
    direction: nonZero(() => wholeVector(random, 2)),
  }),
};

interface SmallFlat extends Setting {
  readonly normal: Vec3;
  readonly point: Vec3;
}

const NORMALS = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] } as const;

const SMALL_FLAT: NonEmpty<Draw<SmallFlat>> = [
  (random) => {
    const normal = nonZero(() => wholeVector(random, 2));
    const point = wholeVector(random, 2);
    return { shape: { kind: 'plane', normal, point }, normal, point };
  },
  (random) => {
    const normal = nonZero(() => wholeVector(random, 2));
    const point = wholeVector(random, 2);
    const radius = integer(random, 0, 2);
    return { shape: { kind: 'circle', normal, center: point, radius }, normal, point };
  },
  (random) => {
    const axis = pick<Axis>(random, ['x', 'y', 'z']);
    const point = wholeVector(random, 2);
    const side = integer(random, 0, 2);
    return { shape: { kind: 'square', corner: point, side, axis }, normal: NORMALS[axis], point };
  },
];

export const flatDegenerate: FamilyParts<SmallFlat> = {
  id: 'flat-degenerate',
  hardness: 'special',
  title: 'parallel or in the plane',
  idea:
    'Flat shapes in small whole numbers: half of the rays are parallel to the plane, and ' +
    'half of these lie in it.',
  dial: null,
  setting: (random) => pick(random, SMALL_FLAT)(random),
  ray(random, { normal, point }) {
    const level = (): Vec3 => nonZero(() => cross(normal, wholeVector(random, 2)));
    const parallel = random() < 0.5;
    return {
      origin: parallel && random() < 0.5 ? plus(point, level()) : wholeVector(random, 2),
      direction: parallel ? level() : nonZero(() => wholeVector(random, 2)),
    };
  },
};
