import type { Question } from '../../math/families.ts';
import { InvalidInput, type Ray, type Shape } from '../../math/index.ts';
import { quote, unitVector } from '../../math/shapes.ts';
import { axisOf, type MapAxis, withNumber } from './axes.ts';
import { type MapScale, type Measure, scaleOf } from './window.ts';

/** Where rays that leave a surface begin, as on Picture. */
export type StartRule =
  /** The root at which the ray starts is dropped, by its place in the list. */
  | { readonly rule: 'from' }
  /** Any t > 0 counts. */
  | { readonly rule: 'none' }
  /** Any t ≥ epsilon counts, in lengths. */
  | { readonly rule: 'epsilon'; readonly epsilon: number };

/**
 * A map: two numbers of a ray and a shape as axes, and at each pixel what a method says of the ray
 * there, beside the exact verdict.
 */
export interface MapRequest {
  readonly shape: Shape;
  /** As it was typed; `unit` says whether the kernel gets d / |d|. */
  readonly ray: Ray;
  readonly unit: boolean;
  /** Ids of the axes, to the right and upwards. */
  readonly axes: readonly [x: string, y: string];
  readonly measure: Measure;
  readonly zoom: number;
  /** The numbers in the window's middle. */
  readonly at: readonly [x: number, y: number];
  /** One of METHODS. */
  readonly method: string;
  /**
   * Absent: the ray itself is asked about. Else the ray that leaves the first hit as from a mirror,
   * and whether it meets its own surface again.
   */
  readonly start?: StartRule | undefined;
}

/** Ray and shape at a pixel, as the kernel gets them; null where there are none. */
type QuestionAt = (column: number, row: number) => Question | null;

/** The rays of a map, without anybody's answers. */
interface MapRays {
  readonly axes: readonly [x: MapAxis, y: MapAxis];
  readonly at: QuestionAt;
}

/** @throws InvalidInput for an axis that the shape has not, or twice the same. */
export function raysOf(request: MapRequest): MapRays {
  const { shape, ray, unit } = request;
  const axes = mapAxes(request);
  const [x, y] = axes;
  const [across, up] = scalesOf(request);
  const raw: QuestionAt = (column, row) => {
    const first = withNumber(x, { shape, ray }, across.numberAt(column));
    return first && withNumber(y, first, up.numberAt(row));
  };
  const at: QuestionAt = (column, row) => {
    const found = raw(column, row);
    if (!found || !unit) return found;
    const { origin, direction } = found.ray;
    return { shape: found.shape, ray: { origin, direction: unitVector(direction) } };
  };
  return { axes, at };
}

/** The axes of a request. */
function mapAxes({ shape, axes }: MapRequest): readonly [MapAxis, MapAxis] {
  const [x, y] = axes.map((id) => axisOf(shape, id));
  if (!x || !y) {
    const missing = quote(axes[x ? 1 : 0]);
    throw new InvalidInput(`${missing} is no number of a ray and a ${shape.kind}`);
  }
  if (x.id === y.id) throw new InvalidInput(`${quote(x.id)} cannot be both axes`);
  return [x, y];
}

export const scalesOf = ({
  measure,
  zoom,
  at,
}: Pick<MapRequest, 'measure' | 'zoom' | 'at'>): readonly [MapScale, MapScale] => [
  scaleOf(measure, zoom, at[0]),
  scaleOf(measure, zoom, at[1]),
];
