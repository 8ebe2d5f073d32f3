import { intersect } from '../intersect.ts';
import type { Intersection } from '../intersection.ts';
import type { Ray } from '../ray.ts';
import { integer, pick, type Random, randomSign, uniform } from '../rng.ts';
import type { ShapeDefinition } from '../shapes/define.ts';
import type { Shape } from '../shapes/index.ts';
import type { Param } from '../shapes/params.ts';
import type { Axis, Vec3 } from '../vec3.ts';
import { binaryExponent, type Family, family, powerOfTen, type Setting } from './define.ts';
import {
  along,
  inBox,
  minus,
  type NonEmpty,
  nonZero,
  nudgedVector,
  plus,
  scaled,
  stepsOf,
  times,
  unitDirection,
  wholeVector,
} from './random-vectors.ts';

/* Families made from a shape's own parameters, for a shape that has none written for it. */

type AnyDefinition = ShapeDefinition<Shape>;
type Value = Vec3 | number | Axis;

interface PlacedSetting extends Setting {
  readonly at: Vec3;
  readonly size: number;
}

function shapeWith(
  { kind, params, anchor }: AnyDefinition,
  draw: (param: Param) => Value,
): PlacedSetting {
  const values = params.map((param) => [param.key, draw(param)] as const);
  const shape = { kind, ...Object.fromEntries(values) } as unknown as Shape;
  const { at, size } = anchor(shape);
  return { shape, at, size: size || 1 };
}

/** Numbers within the ends of their sliders, points up to 2 from the origin. */
const ordinaryShape = (random: Random, definition: AnyDefinition): PlacedSetting =>
  shapeWith(definition, (param) => {
    if (param.type === 'axis') return pick(random, ['x', 'y', 'z']);
    if (param.type === 'vector') return param.nonZero ? unitDirection(random) : inBox(random, 2);
    return uniform(random, Math.max(param.range[0], param.least ?? param.range[0]), param.range[1]);
  });

/** Every number is whole and small: sums, products and squares of a few are exact. */
const wholeShape = (random: Random, definition: AnyDefinition): PlacedSetting =>
  shapeWith(definition, (param) => {
    if (param.type === 'axis') return pick(random, ['x', 'y', 'z']);
    if (param.type === 'number') {
      const x = integer(random, 1, 4);
      return param.least === undefined ? x * randomSign(random) : x;
    }
    return param.nonZero ? nonZero(() => wholeVector(random, 2)) : wholeVector(random, 2);
  });

/** Towards a place up to 1.5 sizes from the shape's anchor. */
const aimed = (random: Random, { at, size }: PlacedSetting, origin: Vec3): Vec3 =>
  minus(plus(at, inBox(random, 1.5 * size)), origin);

/** E is within one size of the anchor, where it may be inside, or within five: by equal chance. */
function ordinaryRay(random: Random, placed: PlacedSetting): Ray {
  const reach = pick(random, [placed.size, 5 * Math.max(1, placed.size)]);
  const origin = plus(placed.at, inBox(random, reach));
  return { origin, direction: aimed(random, placed, origin) };
}

const isMet = (shape: Shape, origin: Vec3, direction: Vec3): boolean =>
  intersect(shape, { origin, direction }).class !== 'none';

/** Most draws of one ray, and most halvings of a direction. */
const TRIES = 60;

/**
 * A ray between one that meets the shape and one that does not: the direction is halved between the
 * two until they are neighbours, then moved by up to 2^k doubles.
 */
function nearTangentRay(random: Random, placed: PlacedSetting, k: number): Ray {
  const { origin, direction } = ordinaryRay(random, placed);
  const { shape } = placed;
  const met = isMet(shape, origin, direction);
  let other = direction;
  for (let i = 0; i < TRIES && isMet(shape, origin, other) === met; i++) {
    other = i % 2 ? unitDirection(random) : aimed(random, placed, origin);
  }
  let [near, far] = [direction, other];
  for (let i = 0; i < TRIES; i++) {
    const middle = times(0.5, plus(near, far));
    if (isMet(shape, origin, middle) === met) near = middle;
    else far = middle;
  }
  return { origin, direction: nudgedVector(random, near, stepsOf(k)) };
}

type Class = Intersection['class'];

/** Classes that special rays are searched for: one list by chance. Few shapes have the second. */
const SPECIAL_CLASSES: NonEmpty<readonly Class[]> = [['tangent'], ['one', 'contained']];

/**
 * A ray of a wanted class, from up to TRIES draws. If there is none: the last draw whose class is
 * neither 'two' nor 'none'; else the first draw.
 */
function wholeRay(random: Random, { shape }: PlacedSetting): Ray {
  const wanted = pick(random, SPECIAL_CLASSES);
  const draw = (): Ray => ({
    origin: wholeVector(random, 4),
    direction: nonZero(() => wholeVector(random, 1)),
  });
  let best = draw();
  for (let i = 0; i < TRIES; i++) {
    const ray = draw();
    const { class: found } = intersect(shape, ray);
    if (wanted.includes(found)) return ray;
    if (found !== 'two' && found !== 'none') best = ray;
  }
  return best;
}

/** Families of rays about one shape, called after its kind. */
export function familiesOfShape(definition: AnyDefinition): readonly Family[] {
  const { kind, title } = definition;
  const of = (random: Random): PlacedSetting => ordinaryShape(random, definition);
  return [
    family({
      id: kind,
      hardness: 'ordinary',
      title,
      idea: `A ${title} and a ray in no special position.`,
      dial: null,
      setting: of,
      ray: ordinaryRay,
    }),
    family({
      id: `${kind}-whole`,
      hardness: 'special',
      title: `${title} in whole numbers`,
      idea: 'Every number is whole and small, so that exact tangents and zeros come up.',
      dial: null,
      setting: (random) => wholeShape(random, definition),
      ray: wholeRay,
    }),
    family({
      id: `${kind}-far`,
      hardness: 'hard',
      title: `${title}, far origin`,
      idea: 'E is many sizes away and aimed at the shape.',
      dial: { title: 'E is 10^k sizes away', range: [0, 12], usual: [3, 9] },
      setting: of,
      ray(random, placed, k) {
        const direction = unitDirection(random);
        const aim = plus(placed.at, inBox(random, placed.size));
        const distance = powerOfTen(k) * placed.size * uniform(random, 1, 2);
        return { origin: along(aim, -distance, direction), direction };
      },
    }),
    family({
      id: `${kind}-scale-ray`,
      hardness: 'hard',
      title: `${title}, long or short d`,
      idea: 'An ordinary ray whose d is very long or short.',
      dial: { title: '|d| is about 10^k', range: [-150, 150], usual: [-8, 8] },
      setting: of,
      ray(random, placed, k) {
        const { origin, direction } = ordinaryRay(random, placed);
        return { origin, direction: scaled(direction, binaryExponent(k)) };
      },
    }),
    family({
      id: `${kind}-near-tangent`,
      hardness: 'hard',
      title: `${title}, near tangent`,
      idea:
        'Between a direction that meets the shape and its neighbour that does not, moved ' +
        'by a few doubles.',
      dial: { title: 'by up to 2^k doubles', range: [0, 20], usual: [0, 6] },
      setting: of,
      ray: nearTangentRay,
    }),
  ];
}
