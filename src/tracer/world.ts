import { batchOf, type Kernel, type Quadric, quadricOf } from '../math/batch.ts';
import type { Box, Heights } from '../math/drawing.ts';
import {
  InvalidInput,
  intersect,
  type Ray,
  type Shape,
  type Solid,
  type Vec3,
} from '../math/index.ts';
import { definitionOf, findMethod, quote } from '../math/shapes.ts';
import type { CutOff, SurfaceMaterial, World, WorldLight } from '../scene/effects/body.ts';
import { declaredAt } from '../scene/effects/declared.ts';
import { type BodyValues, type FieldOwner, type Owner, valuesOf } from '../scene/effects/fields.ts';
import { boxOf, type Surface, surfacesOf } from '../scene/surfaces.ts';
import type { Light, Material, Paint, Scene } from '../scene/types.ts';
import { linear } from './colour.ts';
import { type GradientOf, gradientOf, unit } from './gradient.ts';

/** A surface with everything that the tracer needs of it. */
export interface Target extends CutOff {
  readonly surface: number;
  readonly kernel: Kernel;
  readonly flat: boolean;
  /** Whether nearly every line meets it, so that asking for the class first would not pay. */
  readonly endless: boolean;
  /** Whether both roots are computed to check their heights; bounds are ±∞ if it is not cut off. */
  readonly cut: boolean;
  readonly box: Box | null;
  /** Whether it blocks light. */
  readonly blocks: boolean;
  /** Whether it is of glass that absorbs light. */
  readonly absorbs: boolean;
  readonly gradient: GradientOf;
  /** A curved shape's numbers for departs.ts, if the method gives the exact class; else null. */
  readonly proven: Quadric | null;
}

export interface TracerWorld extends World {
  readonly surfaces: readonly Surface[];
  readonly targets: readonly Target[];
}

/**
 * @param heights 'off': no shape is cut off; 'needed': those with `between` are; 'all': heights are
 *   checked for every shape.
 */
export function worldOf(
  scene: Scene,
  method: string,
  heights: 'off' | 'needed' | 'all',
): TracerWorld {
  const asked = findMethod(method);
  if (!asked) throw new InvalidInput(`there is no method ${quote(method)} to trace with`);
  const surfaces = surfacesOf(scene);
  const rounding = ROUNDINGS * unitOf(asked);
  const materials = surfaces.map(({ thing }) => scene.things[thing]?.material as Material);
  return {
    surfaces,
    materials: materials.map((material, k) =>
      materialNumbers(material, surfaces[k]?.shape as Shape),
    ),
    lights: scene.lights.map(lightOf),
    values: bodyValuesOf('scene', scene),
    targets: surfaces.map((surface, k): Target => {
      const between = heights === 'off' ? undefined : surface.between;
      const formula = definitionOf(surface.shape).formula(surface.shape);
      return {
        surface: k,
        kernel: batchOf(asked, surface.shape),
        flat: formula.family === 'flat',
        endless: formula.family === 'flat' && formula.bound === null,
        cut: between !== undefined || heights === 'all',
        low: between?.[0] ?? Number.NEGATIVE_INFINITY,
        high: between?.[1] ?? Number.POSITIVE_INFINITY,
        isKept:
          between && formula.family === 'curved' ? keptBy(surface.shape, between, asked) : null,
        rounding,
        box: boxOf(between ? surface : { ...surface, between: EVERYWHERE }),
        blocks: materials[k]?.glass === undefined,
        absorbs: materials[k]?.glass?.absorption.some((x) => x > 0) ?? false,
        gradient: gradientOf(surface.shape),
        proven: asked.proven ? quadricOf(surface.shape) : null,
      };
    }),
  };
}

/**
 * Roundings between two ways to E.y + t d.y: t, the product, the sum, and the point's own; more
 * than there are, since the math module is asked within them.
 */
const ROUNDINGS = 16;

/** Distance of 1 from the next number that the method works with. */
function unitOf({ parts }: Method): number {
  const double = 2 ** -52;
  if (!parts) return double;
  return parts(({ arithmetic: { of, toNumber } }) => {
    let unit = double;
    while (toNumber(of(1 + unit)) === 1) unit *= 2;
    return unit;
  });
}

/** As `intersect` decides it for one ray: exactly where the method is exact, else as it rounds. */
function keptBy(shape: Shape, between: Heights, method: Method): CutOff['isKept'] {
  const solid = { ...shape, between } as Solid;
  const [low, high] = between;
  const height = roundedHeight(method);
  return ({ Ex, Ey, Ez, dx, dy, dz }, i, root, t) => {
    const at = (all: Float64Array): number => all[i] as number;
    if (height) {
      const y = height(at(Ey), at(dy), t);
      return y >= low && y <= high;
    }
    const ray: Ray = { origin: [at(Ex), at(Ey), at(Ez)], direction: [at(dx), at(dy), at(dz)] };
    // A ray whose numbers overflowed on the way is refused there.
    const isRay = [...ray.origin, ...ray.direction].every(Number.isFinite);
    return isRay && intersect(solid, ray, method.id).hits[root]?.fate === 'hit';
  };
}

/** E.y + t d.y as the method rounds it; null if its t is more than the double that a root is. */
function roundedHeight({ parts }: Method): ((e: number, d: number, t: number) => number) | null {
  if (!parts) return null;
  return parts(({ arithmetic: { of, add, mul, toNumber } }) =>
    typeof of(1) === 'number' ? (e, d, t) => toNumber(add(of(e), mul(of(t), of(d)))) : null,
  );
}

type Method = NonNullable<ReturnType<typeof findMethod>>;

const EVERYWHERE = [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY] as const;

/** Values of declared fields for bodies: colours are linear light. */
function bodyValuesOf(place: FieldOwner, owner: Owner): BodyValues {
  const sets = declaredAt(place).map((set) => {
    const values = Object.entries(valuesOf(set, owner)).map(([key, value]) => {
      const isColour = set.fields[key]?.type === 'colour';
      return [key, isColour ? linear(value as string) : value] as const;
    });
    return [set.effect, Object.fromEntries(values)] as const;
  });
  return Object.fromEntries(sets);
}

function materialNumbers(material: Material, shape: Shape): SurfaceMaterial {
  const { paint, shine, mirror, glass } = material;
  const plain = linear(paint.colour);
  return {
    colour: plain,
    other: paint.pattern === 'plain' ? plain : linear(paint.other),
    pattern: axesOf(paint, shape),
    size: paint.pattern === 'plain' ? 1 : paint.size,
    mirror,
    shine: shine.strength,
    exponent: shine.exponent,
    index: glass?.index ?? 0,
    absorption: glass?.absorption ?? [0, 0, 0],
    matte: glass ? 0 : 1 - mirror,
    glossy: 1 - mirror,
    values: bodyValuesOf('material', material),
  };
}

/**
 * The axes that a pattern depends on. A checker on a flat shape leaves out the axis nearest to the
 * normal: along it, points of an axis-parallel plane differ by rounding only.
 */
function axesOf(paint: Paint, shape: Shape): readonly (0 | 1 | 2)[] {
  if (paint.pattern === 'plain') return [];
  if (paint.pattern === 'stripes') return [AXIS[paint.axis]];
  const definition = definitionOf(shape);
  if (definition.formula(shape).family === 'curved') return [0, 1, 2];
  const sizes = (definition.values(shape).vectors.N as Vec3).map(Math.abs);
  const most = sizes.indexOf(Math.max(...sizes));
  return ([0, 1, 2] as const).filter((axis) => axis !== most);
}

const AXIS = { x: 0, y: 1, z: 2 } as const;

function lightOf(light: Light, index: number): WorldLight {
  const [r, g, b] = linear(light.colour);
  const colour: Vec3 = [r * light.strength, g * light.strength, b * light.strength];
  const sun = light.light === 'sun';
  return {
    index,
    at: sun ? unit(light.towards) : light.at,
    sun,
    radius: light.light === 'sphere' ? light.radius : 0,
    colour,
    values: bodyValuesOf('light', light),
  };
}
