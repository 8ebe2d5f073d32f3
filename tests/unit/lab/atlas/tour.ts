import { axesOf, numberOn } from '../../../../src/lab/atlas/axes.ts';
import type { MapRequest } from '../../../../src/lab/atlas/request.ts';
import { clampZoom, MEASURES, PIXELS, ZOOMS } from '../../../../src/lab/atlas/window.ts';
import { FAMILIES, type Question } from '../../../../src/math/families.ts';
import { integer, type Random, seeded, uniform } from '../../../../src/math/rng.ts';

const oneOf = <T>(random: Random, all: readonly T[]): T =>
  all[integer(random, 0, all.length - 1)] as T;

/** A window around a ray: any two numbers as axes, in lengths, decades or doubles, at any zoom. */
export function windowAround({ shape, ray }: Question, random: Random, method: string): MapRequest {
  const axes = axesOf(shape);
  const x = oneOf(random, axes);
  const y = oneOf(
    random,
    axes.filter(({ id }) => id !== x.id),
  );
  const measure = oneOf(random, MEASURES).id;
  const [least, most] = ZOOMS[measure];
  return {
    ...{ shape, ray, unit: random() < 0.2, axes: [x.id, y.id], measure, method },
    at: [numberOn(x, { shape, ray }), numberOn(y, { shape, ray })],
    zoom: clampZoom(measure, uniform(random, Math.max(least, -2), most)),
  };
}

/** Windows around hard rays, a family after the other. */
export function* tour(seed: number, count: number, method: string): Generator<MapRequest, void> {
  const random = seeded(seed);
  for (let i = 0; i < count; i++) {
    const family = FAMILIES()[i % FAMILIES().length];
    if (family) yield windowAround(family.make(random), random, method);
  }
}

/** About so many pixels of a map, in no pattern of rows and columns. */
export const somePixels = (count: number): Int32Array => {
  const step = Math.max(1, Math.floor(PIXELS / count));
  // An odd step that shares no divisor with the side meets every column.
  const odd = step % 2 === 0 ? step + 1 : step;
  return Int32Array.from({ length: Math.floor(PIXELS / odd) }, (_, i) => i * odd);
};
