/** A point or a direction in space, components along x, y and z. */
export type Vec3 = readonly [number, number, number];

export type Axis = 'x' | 'y' | 'z';

export const AXES: readonly Axis[] = ['x', 'y', 'z'];

/** The component of `v` along `axis`. */
export function component(v: Vec3, axis: Axis): number {
  return v[axisIndex(axis)];
}

/** `v` with its component at this index replaced. */
export function withComponent(v: Vec3, index: number, x: number): Vec3 {
  return v.map((old, i) => (i === index ? x : old)) as unknown as Vec3;
}

export function axisIndex(axis: Axis): 0 | 1 | 2 {
  return axis === 'x' ? 0 : axis === 'y' ? 1 : 2;
}
