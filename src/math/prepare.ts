import { endingBy, isFaithful } from './answer-with-ends.ts';
import { DEFAULT_METHOD, findMethod } from './find-method.ts';
import { InvalidInput, quote } from './invalid-input.ts';
import type { Method } from './methods/define.ts';
import { anySurface } from './prepare/flat.ts';
import { neverTold, type Surface } from './prepare/lines.ts';
import {
  entryOf,
  ownSolid,
  type Prepared,
  type PrepareOptions,
  preparedBy,
  rangeOf,
} from './prepare/prepare.ts';
import type { ShapeDefinition } from './shapes/define.ts';
import { SHAPES, type Shape, type Solid } from './shapes/index.ts';
import type { Given } from './vec3.ts';

/** What `prepare` takes beside a shape. */
export interface PrepareAnyOptions extends PrepareOptions<Shape> {
  /** The `id` of one of METHODS; `certified` unless given. */
  readonly method?: string | undefined;
}

/**
 * A shape that many rays are asked about: what depends on the shape alone is worked out once. By
 * `certified` each answer is the exact one, and each t one of the two doubles around the exact
 * root, though not always the one of both that `intersect` has.
 *
 * @param shape as for `intersect`, with its ends; its numbers are read now.
 * @param options `tMin` and `tMax`: the least and the greatest t that count, 0 and Infinity unless
 *   given, both included; `from`: the shape that every ray starts on, as for `intersect`; `method`:
 *   the `id` of one of METHODS.
 * @throws InvalidInput as `intersect` does, and where tMin or tMax is NaN.
 * @see NUMERICS.md, section 5, the end: one ray after the other.
 * @example
 * const can = prepare(
 *   { kind: 'cylinder', center: [0, 0, 0], radius: 5, between: [-1, 1], caps: true },
 *   { tMin: 1 },
 * );
 * const steep = { origin: [0, 4, 0], direction: [1, -1, 0] } as const;
 * can.first(steep);
 * // → { t: 3, point: [3, 1, 0], normal: [0, 1, 0], singular: false, fate: 'cap' }
 * can.all(steep).map(({ t }) => t); // → [3, 5]
 * can.any({ origin: [0, 4, 0], direction: [1, 1, 0] }); // → false
 * [can.inside([5, 0, 0]), can.side([5, 0, 0]), can.inside([0, 2, 0])]; // → [true, 0, false]
 */
export function prepare(shape: Given<Solid>, options?: PrepareAnyOptions | null): Prepared {
  const entry = entryOf(ENTRIES, shape ?? {});
  const solid = ownSolid(entry, shape);
  const id = options?.method ?? DEFAULT_METHOD;
  const method = findMethod(id);
  if (!method) throw new InvalidInput(`unknown method ${quote(id)}`);
  const range = rangeOf(ENTRIES, options, ['method']);
  const surface =
    id === DEFAULT_METHOD ? anySurface(entry, solid.shape) : surfaceBy(method, solid.shape);
  return preparedBy(entry, solid, surface, range);
}

/** One entry's functions get that entry's shapes only. */
const ENTRIES = SHAPES as unknown as readonly ShapeDefinition<Shape>[];

/** As any method answers. */
const surfaceBy = (method: Method, shape: Shape): Surface => ({
  ask: null,
  settle: neverTold,
  quadric: null,
  isExact: isFaithful(method.id),
  ending: (ray, whole) => endingBy(method.id, shape, ray, whole),
  place: (ray, k) => method.intersect(shape, ray).hits[k] as never,
  roots(ray) {
    const { class: verdict, hits } = method.intersect(shape, ray);
    return { verdict, hits };
  },
});
