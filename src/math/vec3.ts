/** A point or a direction in space, components along x, y and z; y is the axis of round shapes. */
export type Vec3 = readonly [number, number, number];

/**
 * What a caller may give: for each vector any list of three numbers, a Float64Array for one. The
 * answers are made of plain arrays.
 */
export type Given<T> = T extends unknown
  ? { readonly [K in keyof T]: T[K] extends Vec3 ? ArrayLike<number> : T[K] }
  : never;

/** x, y and z as a plain array. */
export const plainVector = (v: ArrayLike<number>): Vec3 =>
  (Array.isArray(v) ? v : [v[0], v[1], v[2]]) as unknown as Vec3;

/** One of the three axes; y is the axis of round shapes. */
export type Axis = 'x' | 'y' | 'z';

/** x, y and z, in the order of components. */
export const AXES: readonly Axis[] = ['x', 'y', 'z'];

/**
 * `v` with its component at this index replaced.
 *
 * @param v of any unit.
 * @param index a whole number: 0, 1 or 2.
 * @param x in the unit of v.
 * @returns in the unit of v.
 * @see NUMERICS.md, section 1
 * @example
 * withComponent([1, 2, 3], 1, 9); // → [1, 9, 3]
 */
export function withComponent(v: Vec3, index: number, x: number): Vec3 {
  return v.map((old, i) => (i === index ? x : old)) as unknown as Vec3;
}

/**
 * The place of an axis among components.
 *
 * @param axis x, y or z.
 * @returns a whole number.
 * @example
 * ['x', 'y', 'z'].map((axis) => axisIndex(axis as 'x')); // → [0, 1, 2]
 */
export function axisIndex(axis: Axis): 0 | 1 | 2 {
  return axis === 'x' ? 0 : axis === 'y' ? 1 : 2;
}
