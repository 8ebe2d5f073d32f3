import { InvalidInput, type Shape } from '../math/index.ts';
import { checkedShape, definitionOf, quote, refused } from '../math/shapes.ts';
import { effectValues } from './effects/declared.ts';
import {
  axis,
  colour,
  fieldsOf,
  flag,
  listOf,
  nonZero,
  number,
  oneOf,
  type Reader,
  record,
  text,
  variant,
  vector,
} from './reader.ts';
import type {
  Background,
  Camera,
  CheckerPaint,
  Glass,
  Light,
  Material,
  Paint,
  PlainPaint,
  PointLight,
  Scene,
  Shine,
  SphereLight,
  StripesPaint,
  SunLight,
  Thing,
} from './types.ts';

/** Limits for values of a file. Squares of the largest coordinates do not overflow in float32. */
const LIMITS = {
  things: 250,
  lights: 8,
  coordinate: 1e12,
  name: 60,
} as const;

const coordinate = number(-LIMITS.coordinate, LIMITS.coordinate);
const point = vector(coordinate);
const direction = nonZero(point);
const share = number(0, 1);
const size = number(1e-6, LIMITS.coordinate);
const name = text(LIMITS.name);

const paint = variant<Paint>('pattern', {
  plain: record<PlainPaint>({ pattern: oneOf(['plain']), colour }),
  checker: record<CheckerPaint>({ pattern: oneOf(['checker']), colour, other: colour, size }),
  stripes: record<StripesPaint>({ pattern: oneOf(['stripes']), colour, other: colour, size, axis }),
});

const material = record<Material>(
  {
    paint,
    shine: record<Shine>({ strength: share, exponent: number(1, 10_000) }),
    mirror: share,
    glass: record<Glass>({ index: number(1, 5), absorption: vector(number(0, 1e6)) }),
    effects: effectValues('material'),
  },
  ['glass', 'effects'],
);

const shape: Reader<Shape> = (value, path) => {
  const given = fieldsOf(value, path);
  try {
    const { kind, params } = definitionOf(checkedShape(value as Shape));
    const own = params.map(({ key, type }) => {
      const read: Reader<unknown> =
        type === 'vector' ? point : type === 'number' ? coordinate : (x) => x;
      return [key, read(given[key], key)] as const;
    });
    return { kind, ...Object.fromEntries(own) } as unknown as Shape;
  } catch (error) {
    if (!(error instanceof InvalidInput)) throw error;
    throw new InvalidInput(`${path}: ${error.message}`);
  }
};

const heights: Reader<readonly [number, number]> = (value, path) => {
  if (!Array.isArray(value) || value.length !== 2) {
    throw refused(path, 'must be two heights', value);
  }
  const low = coordinate(value[0], `${path}[0]`);
  const high = coordinate(value[1], `${path}[1]`);
  if (!(low < high)) throw new InvalidInput(`${path} must go up, got (${low}, ${high})`);
  return [low, high];
};

const thing = record<Thing>({ id: name, shape, material, between: heights, capped: flag }, [
  'between',
  'capped',
]);

const common = { id: name, colour, strength: number(0, 100) };
const added = { effects: effectValues('light') };
const light = variant<Light>('light', {
  point: record<PointLight>({ light: oneOf(['point']), ...common, at: point, ...added }, [
    'effects',
  ]),
  sun: record<SunLight>({ light: oneOf(['sun']), ...common, towards: direction, ...added }, [
    'effects',
  ]),
  sphere: record<SphereLight>(
    { light: oneOf(['sphere']), ...common, at: point, radius: size, ...added },
    ['effects'],
  ),
});

const scene = record<Scene>(
  {
    title: name,
    camera: record<Camera>({ eye: point, target: point, angle: number(0.000001, 170) }),
    background: record<Background>({ low: colour, high: colour }),
    ambient: share,
    things: listOf(thing, LIMITS.things),
    lights: listOf(light, LIMITS.lights),
    effects: effectValues('scene'),
  },
  ['effects'],
);

/**
 * Makes a Scene from an untrusted value and shares no objects with it. Throws InvalidInput with the
 * place and the value: `things[0].material.mirror must be a number from 0 to 1, got 2`.
 */
export function validateScene(value: unknown): Scene {
  const found = scene(value, '');
  const { eye, target } = found.camera;
  if (eye.every((x, i) => x === target[i])) {
    throw new InvalidInput(`camera.target must not be the eye, got (${target.join(', ')})`);
  }
  const ids = new Set<string>();
  for (const { id } of [...found.things, ...found.lights]) {
    if (ids.has(id)) throw new InvalidInput(`two things are called ${quote(id)}`);
    ids.add(id);
  }
  return found;
}
