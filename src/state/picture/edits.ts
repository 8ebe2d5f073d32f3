import { InvalidInput, type Shape, type Vec3 } from '../../math/index.ts';
import { definitionOf, type Param, type ShapeKind } from '../../math/shapes.ts';
import { freeId } from '../../scene/edit.ts';
import {
  GREY,
  type Light,
  type Material,
  type Paint,
  type Placed,
  type Scene,
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

/** Whether a parameter is a position: changing it moves the whole shape. */
export const isPlace = (param: Param): boolean => param.type === 'vector' && !param.nonZero;

/** A thing with one parameter of its shape changed. If it moves, its heights move with it. */
export function withParam(thing: Placed, param: Param, value: Vec3 | number | string): Placed {
  const shape = { ...thing.shape, [param.key]: value } as Shape;
  if (!isPlace(param) || !thing.between) return { ...thing, shape };
  const before = (thing.shape as unknown as Readonly<Record<string, Vec3>>)[param.key];
  const up = (value as Vec3)[1] - (before?.[1] ?? 0);
  const [low, high] = thing.between;
  // Rounded to 14 digits, so that a sum of short decimals is a short decimal.
  const raised = (y: number): number => Number((y + up).toPrecision(14));
  return up === 0 ? { ...thing, shape } : { ...thing, shape, between: [raised(low), raised(high)] };
}

/** The thing cut off at two heights about its anchor, or no longer cut off. */
export function withHeights(thing: Placed, on: boolean): Placed {
  const { between: _, capped: __, ...whole } = thing;
  if (!on) return whole;
  const { at, size } = definitionOf(thing.shape).anchor(thing.shape);
  const half = size > 0 ? size : 1;
  return { ...whole, between: [at[1] - half, at[1] + half], capped: canBeCapped(thing.shape) };
}

/** Whether the ends of a cut shape are circles, which caps can close. */
export const canBeCapped = (shape: Shape): boolean => definitionOf(shape).body.circleAt !== null;

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

/** Size of new things: a quarter of half the height that the camera sees at its target. */
function viewSize({ camera: { eye, target, angle } }: Scene): number {
  const distance = Math.hypot(...eye.map((x, i) => x - (target[i] ?? 0)));
  const half = distance * Math.tan((angle * Math.PI) / 360);
  return Number((half / 4).toPrecision(1));
}

/** A new grey shape in the middle of the picture; cut off at two heights if it is unbounded. */
export function newThing(scene: Scene, kind: ShapeKind): Placed {
  const unit = viewSize(scene);
  const { target } = scene.camera;
  const initial = initialShape(kind);
  const params = definitionOf(initial).params.map((param) => {
    if (isPlace(param)) return [param.key, target] as const;
    const isLength = param.type === 'number' && param.least === 0;
    return [param.key, isLength ? unit : (initial as never)[param.key]] as const;
  });
  const shape = { ...initial, ...Object.fromEntries(params) } as Shape;
  const id = freeId(scene, kind);
  const ends = definitionOf(shape).body.box(shape, null) !== null;
  if (ends || !canBeCapped(shape)) return { id, shape, material: GREY };
  const between = [target[1] - unit, target[1] + unit] as const;
  return { id, shape, material: GREY, between, capped: true };
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

/** What a thing is, in a few words: a hyperboloid with a = −1 is a sphere. */
export function thingWords({ id, shape, material }: Placed): string {
  const { name } = definitionOf(shape).named(shape);
  return [...(id === name ? [] : [name]), materialWords(material)].filter(Boolean).join('; ');
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
