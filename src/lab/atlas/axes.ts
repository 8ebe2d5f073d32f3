import type { Question } from '../../math/families.ts';
import type { Ray, Shape, Vec3 } from '../../math/index.ts';
import { AXES, checkParam, definitionOf, type Param, withComponent } from '../../math/shapes.ts';

/** A number of the ray or the shape that an axis of a map can be. */
export interface MapAxis {
  /** As in links: E.z, r, C.x. */
  readonly id: string;
  readonly symbol: string;
  readonly of: 'origin' | 'direction' | 'shape';
  /** The shape's property; '' for the ray's. */
  readonly key: string;
  /** The component of a vector; null for a number. */
  readonly index: number | null;
  /** What the shape says of it; null for the ray's. */
  readonly param: Param | null;
}

const components = (symbol: string, rest: Omit<MapAxis, 'id' | 'symbol' | 'index'>): MapAxis[] =>
  AXES.map((axis, index) => ({ id: `${symbol}.${axis}`, symbol, index, ...rest }));

/** Every number of a ray and this shape: E, d, and the shape's own. */
export function axesOf(shape: Shape): readonly MapAxis[] {
  const own = definitionOf(shape).params.flatMap((param): MapAxis[] => {
    const { key, symbol, type } = param;
    if (type === 'axis') return [];
    if (type === 'vector') return components(symbol, { of: 'shape', key, param });
    return [{ id: symbol, symbol, of: 'shape', key, index: null, param }];
  });
  return [
    ...components('E', { of: 'origin', key: '', param: null }),
    ...components('d', { of: 'direction', key: '', param: null }),
    ...own,
  ];
}

/** The axis with this id; undefined if the shape has no such number. */
export const axisOf = (shape: Shape, id: string): MapAxis | undefined =>
  axesOf(shape).find((axis) => axis.id === id);

type Numbers = Readonly<Record<string, Vec3 | number>>;

/** The number that the axis is, as ray and shape have it. */
export function numberOn(axis: MapAxis, { shape, ray }: Question): number {
  const value = axis.of === 'shape' ? (shape as unknown as Numbers)[axis.key] : ray[axis.of];
  return axis.index === null ? (value as number) : ((value as Vec3)[axis.index] as number);
}

/** The same ray and shape with another number there; null if it is not allowed. */
export function withNumber(axis: MapAxis, { shape, ray }: Question, x: number): Question | null {
  if (!Number.isFinite(x)) return null;
  const { of, key, index, param } = axis;
  if (of !== 'shape') {
    const moved: Ray = { ...ray, [of]: withComponent(ray[of], index ?? 0, x) };
    return moved.direction.every((one) => one === 0) ? null : { shape, ray: moved };
  }
  const before = (shape as unknown as Numbers)[key];
  const value = index === null ? x : withComponent(before as Vec3, index, x);
  try {
    if (param) checkParam(param, value);
  } catch {
    return null;
  }
  return { shape: { ...shape, [key]: value } as Shape, ray };
}
