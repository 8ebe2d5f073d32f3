import type { Kernel } from '../math/batch/batch.ts';
import { planarOf } from '../math/batch/planar.ts';
import { type Quadric, quadricOf } from '../math/batch/quadric.ts';
import { findMethod } from '../math/intersect.ts';
import { InvalidInput, quote } from '../math/invalid-input.ts';
import type { Shape } from '../math/shapes/index.ts';
import type { Vec3 } from '../math/vec3.ts';
import type { Look, World, WorldLight } from '../scene/effects/body.ts';
import { type Surface, surfacesOf } from '../scene/surfaces.ts';
import type { Light, Material, Paint, Scene } from '../scene/types.ts';
import { type Box, boxOf } from './boxes.ts';
import { linear } from './colour.ts';
import { PROVEN } from './departs.ts';

/** A surface as the tracer asks it. */
export interface Target {
  readonly surface: number;
  readonly kernel: Kernel;
  readonly flat: boolean;
  /** Nearly every line meets it: asking for the class first would be a question for nothing. */
  readonly endless: boolean;
  /** Both roots are looked at, and their heights; ±∞ where the shape is not cut off. */
  readonly cut: boolean;
  readonly low: number;
  readonly high: number;
  readonly box: Box | null;
  /** Stands in the way of light. */
  readonly blocks: boolean;
  readonly normal: NormalOf;
  /** A curved shape's numbers, where the method's answers are those of exact arithmetic: see departs.ts. */
  readonly proven: Quadric | null;
}

/** The unit normal N of a flat shape, or the gradient (x − Cx, −a(y − Cy), z − Cz) of a curved one. */
export interface NormalOf {
  readonly flat: boolean;
  readonly N: Vec3;
  readonly center: Vec3;
  readonly a: number;
}

export interface TracerWorld extends World {
  readonly surfaces: readonly Surface[];
  readonly targets: readonly Target[];
}

/** `heights`: 'off' leaves all shapes whole, 'needed' cuts those that are cut, 'all' looks at the heights of every one. */
export function worldOf(
  scene: Scene,
  method: string,
  heights: 'off' | 'needed' | 'all',
): TracerWorld {
  const batch = findMethod(method)?.batch;
  if (!batch) throw new InvalidInput(`there is no method ${quote(method)} to trace with`);
  const surfaces = surfacesOf(scene);
  const materials = surfaces.map(({ thing }) => scene.things[thing]?.material as Material);
  return {
    surfaces,
    looks: materials.map((material, k) => lookOf(material, surfaces[k]?.shape as Shape)),
    lights: scene.lights.map(lightOf),
    targets: surfaces.map((surface, k): Target => {
      const between = heights === 'off' ? undefined : surface.between;
      const planar = planarOf(surface.shape);
      return {
        surface: k,
        kernel: batch(surface.shape),
        flat: planar !== null,
        endless: planar?.bound === 'none',
        cut: between !== undefined || heights === 'all',
        low: between?.[0] ?? Number.NEGATIVE_INFINITY,
        high: between?.[1] ?? Number.POSITIVE_INFINITY,
        box: boxOf(between ? surface : { ...surface, between: EVERYWHERE }),
        blocks: materials[k]?.glass === undefined,
        normal: normalOf(surface.shape),
        proven: PROVEN.has(method) ? quadricOf(surface.shape) : null,
      };
    }),
  };
}

const EVERYWHERE = [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY] as const;

function normalOf(shape: Shape): NormalOf {
  const planar = planarOf(shape);
  if (planar) return { flat: true, N: unit(planar.N), center: planar.P, a: 0 };
  const q = quadricOf(shape);
  if (!q) throw new RangeError(`no normals for a ${shape.kind}`);
  const a = q.squared ? q.flare * q.flare : q.hasY ? q.flare : 0;
  return { flat: false, N: [0, 1, 0], center: [q.Cx, q.hasY ? q.Cy : 0, q.Cz], a };
}

function lookOf({ paint, shine, mirror, glass }: Material, shape: Shape): Look {
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
  };
}

/** A checker on a flat shape takes no part across it, where all points are alike but for their last bit. */
function axesOf(paint: Paint, shape: Shape): readonly (0 | 1 | 2)[] {
  if (paint.pattern === 'plain') return [];
  if (paint.pattern === 'stripes') return [AXIS[paint.axis]];
  const planar = planarOf(shape);
  if (!planar) return [0, 1, 2];
  const sizes = planar.N.map(Math.abs);
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
  };
}

export function unit(v: Vec3): Vec3 {
  // Scaled first, so that no square leaves the doubles.
  const size = Math.max(Math.abs(v[0]), Math.abs(v[1]), Math.abs(v[2]));
  const [x, y, z] = [v[0] / size, v[1] / size, v[2] / size];
  const length = Math.sqrt(x * x + y * y + z * z);
  return [x / length, y / length, z / length];
}
