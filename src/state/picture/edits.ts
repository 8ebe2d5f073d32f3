import { InvalidInput, type Shape, type Vec3 } from '../../math/index.ts';
import {
  axisIndex,
  definitionOf,
  type Param,
  type ShapeKind,
  withComponent,
} from '../../math/shapes.ts';
import { isPlace, sum } from '../../scene/edit.ts';
import { freeId, nameIn, wordFor } from '../../scene/names.ts';
import { facingAxis, placed, viewSize } from '../../scene/place.ts';
import {
  GREY,
  type Light,
  type Material,
  type Paint,
  type Scene,
  type Thing,
} from '../../scene/types.ts';
import { validateScene } from '../../scene/validate.ts';
import { initialShape } from '../state.ts';

/** Why a changed scene is refused, without the path to where it stands; null if it is not. */
export function refusalOf(scene: Scene): string | null {
  try {
    validateScene(scene);
    return null;
  } catch (error) {
    if (!(error instanceof InvalidInput)) throw error;
    return error.message
      .replace(/^(?:[\w-]+(?:\[\d+\])?\.)+(?=\w)/, '')
      .replace(/^\w+\[\d+\]: /, '');
  }
}

/** A thing with one parameter of its shape changed. If it moves, its heights move with it. */
export function withParam(thing: Thing, param: Param, value: Vec3 | number | string): Thing {
  const shape = { ...thing.shape, [param.key]: value } as Shape;
  const before = (thing.shape as unknown as Readonly<Record<string, Vec3>>)[param.key];
  const up = isPlace(param) ? (value as Vec3)[1] - (before?.[1] ?? 0) : 0;
  if (up === 0 || !thing.between) return { ...thing, shape };
  const [low, high] = thing.between;
  return { ...thing, shape, between: [sum(low, up), sum(high, up)] };
}

/** The thing cut off at two heights about its anchor, or no longer cut off. */
export function withHeights(thing: Thing, on: boolean): Thing {
  const { between: _, capped: __, ...whole } = thing;
  if (!on) return whole;
  const { at, size } = definitionOf(thing.shape).anchor(thing.shape);
  const half = size > 0 ? size : 1;
  return { ...whole, between: [at[1] - half, at[1] + half], capped: canBeCapped(thing.shape) };
}

/** Whether the ends of a cut shape are circles, which caps can close. */
export const canBeCapped = (shape: Shape): boolean => definitionOf(shape).body().circleAt !== null;

export function withPattern(material: Material, pattern: Paint['pattern']): Material {
  const { paint } = material;
  const other = paint.pattern === 'plain' ? '#f4f3ef' : paint.other;
  const size = paint.pattern === 'plain' ? 0.5 : paint.size;
  const { colour } = paint;
  if (pattern === 'plain') return { ...material, paint: { pattern, colour } };
  if (pattern === 'checker') return { ...material, paint: { pattern, colour, other, size } };
  return { ...material, paint: { pattern, colour, other, size, axis: 'y' } };
}

export function withGlass(material: Material, on: boolean): Material {
  const { glass: _, ...rest } = material;
  return on ? { ...rest, glass: { index: 1.5, absorption: [0, 0, 0] } } : rest;
}

/** A new grey thing on the floor beside the others; an endless flat one is a floor or a wall. */
export function newThing(scene: Scene, kind: ShapeKind): Thing {
  const unit = viewSize(scene);
  const { target } = scene.camera;
  // Flat things face the camera.
  const facing = facingAxis(scene.camera);
  const initial = initialShape(kind);
  const values = definitionOf(initial).params.map((param) => {
    if (isPlace(param)) return [param.key, target] as const;
    if (param.type === 'vector')
      return [param.key, withComponent([0, 0, 0], axisIndex(facing), 1)] as const;
    if (param.type === 'axis') return [param.key, facing] as const;
    return [param.key, param.unit === 'length' ? unit : param.initial] as const;
  });
  const shape = { ...initial, ...Object.fromEntries(values) } as Shape;
  return addedTo(scene, { shape, ...endsFor(shape, unit) });
}

/** The shape of Explore as a new thing. */
export function exploredThing(
  scene: Scene,
  shape: Shape,
  between: Thing['between'] | null,
  caps: boolean,
): Thing {
  const ends = between && canBeCapped(shape) ? { between, capped: caps } : {};
  return addedTo(scene, { shape, ...ends });
}

function addedTo(scene: Scene, thing: Pick<Thing, 'shape' | 'between' | 'capped'>): Thing {
  const id = freeId(scene, wordFor(thing.shape));
  return placed(scene, { id, ...thing, material: GREY });
}

/**
 * Heights for what is unbounded and round: about its anchor, or to the one side of it where its
 * circles begin there. It is no wider than high.
 */
function endsFor(shape: Shape, unit: number): Pick<Thing, 'between' | 'capped'> {
  const { box, circleAt } = definitionOf(shape).body();
  if (!circleAt || box(shape, null)) return {};
  const y = definitionOf(shape).anchor(shape).at[1];
  const down = circleAt(shape, y - unit) !== null;
  const ends = (high: number): readonly [number, number] => {
    if (circleAt(shape, y)) return [sum(y, -high / 2), sum(y, high / 2)];
    return down ? [sum(y, -high), y] : [y, sum(y, high)];
  };
  const isWide = (between: readonly [number, number]): boolean => {
    const found = box(shape, between);
    return found !== null && found.high[0] - found.low[0] > 2.5 * unit;
  };
  const between = isWide(ends(2 * unit)) ? ends(unit) : ends(2 * unit);
  return { between, capped: true };
}

export const LIGHT_KINDS = ['point', 'sun', 'sphere'] as const;
export const LIGHT_WORDS = {
  point: 'a lamp without size',
  sun: 'a sun, infinitely far',
  sphere: 'a lamp with a size',
} as const;

/** A new light above the camera and to its left. */
export function newLight(scene: Scene, kind: Light['light']): Light {
  const { eye, target } = scene.camera;
  const up = 8 * viewSize(scene);
  const at: Vec3 = [target[0] - up, target[1] + 1.5 * up, (eye[2] + target[2]) / 2];
  const lamp = { light: 'point', id: 'lamp', colour: '#ffffff', strength: 0.6, at } as const;
  return asLight({ ...lamp, id: freeId(scene, kind === 'sun' ? 'sun' : 'lamp') }, kind, target);
}

/** The same light as another kind; a sun shines from where the lamp was as seen from the target. */
export function asLight(light: Light, kind: Light['light'], target: Vec3): Light {
  const { id, colour, strength, effects } = light;
  const common = { id, colour, strength };
  const added = effects ? { effects } : {};
  const far = (v: Vec3, w: Vec3, s: number): Vec3 => [
    v[0] + s * w[0],
    v[1] + s * w[1],
    v[2] + s * w[2],
  ];
  const at = light.light === 'sun' ? far(target, light.towards, 5) : light.at;
  if (kind === 'sun') {
    const towards = light.light === 'sun' ? light.towards : far(light.at, target, -1);
    const none = towards.every((x) => x === 0);
    return { light: 'sun', ...common, towards: none ? [0, 1, 0] : towards, ...added };
  }
  if (kind === 'point') return { light: 'point', ...common, at, ...added };
  const radius = light.light === 'sphere' ? light.radius : 0.5;
  return { light: 'sphere', ...common, at, radius, ...added };
}

/** What a thing is, in a few words, as far as its name does not say it. */
export function thingWords(scene: Scene, { id, shape, material }: Thing): string {
  const word = wordFor(shape);
  const { name } = definitionOf(shape).named(shape);
  const isSaid = ` ${nameIn(scene, id)} `.includes(` ${word} `);
  return [...(isSaid ? [] : [name]), materialWords(material)].filter(Boolean).join('; ');
}

/** What a material is, in a word or two. */
export function materialWords({ paint, mirror, glass }: Material): string {
  const words = [
    ...(glass ? [`glass, index ${glass.index}`] : []),
    ...(mirror > 0 ? [`mirror, ${Math.round(100 * mirror)} %`] : []),
    ...(paint.pattern === 'plain' || glass ? [] : [paint.pattern]),
  ];
  return words.join('; ');
}
