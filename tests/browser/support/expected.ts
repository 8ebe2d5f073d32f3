import { alongRay } from '../../../src/math/along.ts';
import { derivation } from '../../../src/math/derivation.ts';
import { spanInFigure } from '../../../src/math/figure.ts';
import { coefficients, intersect, type Ray, SHAPES, type Shape } from '../../../src/math/index.ts';
import type { Hit, Intersection, PlaneHit } from '../../../src/math/intersection.ts';
import type { Shown } from './page.ts';

/** The shortest text that gives the same bits back. */
export function text(x: number): string {
  return Object.is(x, -0) ? '-0' : String(x);
}

type Value = number | string | readonly number[];

const paramsOf = (shape: Shape): [symbol: string, value: Value][] => {
  const own = shape as unknown as Record<string, Value>;
  const definition = SHAPES.find(({ kind }) => kind === shape.kind);
  return (definition?.params ?? []).map(({ key, symbol }) => [symbol, own[key] ?? '']);
};

/** A link as a person would write it, with nothing left out. */
export function linkOf(
  shape: Shape,
  ray: Ray,
  more: Readonly<Record<string, string>> = {},
): string {
  const written = (value: Value): string =>
    typeof value === 'string'
      ? value
      : [value]
          .flat()
          .map((x) => text(x as number))
          .join(',');
  const pairs: [string, Value][] = [
    ['shape', shape.kind],
    ['E', ray.origin],
    ['d', ray.direction],
    ...paramsOf(shape),
    ...Object.entries(more),
  ];
  return `#/explore?${pairs.map(([key, value]) => `${key}=${written(value)}`).join('&')}`;
}

/** Every quantity that the page must show, the bead's excepted, from the math module alone. */
export function expected(shape: Shape, ray: Ray, method: string): Shown {
  const found = intersect(shape, ray, method);
  const shown: Shown = { class: found.class };
  const put = (name: string, value: Value): void => {
    if (typeof value === 'string') shown[name] = value;
    else if (typeof value === 'number') {
      // What a method could not work out is no quantity.
      if (!Number.isNaN(value)) shown[name] = text(value);
    } else for (const [i, x] of value.entries()) put(`${name}.${'xyz'.charAt(i)}`, x);
  };
  put('E', ray.origin);
  put('d', ray.direction);
  for (const [symbol, value] of paramsOf(shape)) put(symbol, value);
  const { A, B, C } = coefficients(shape, ray, method);
  const { details } = found;
  if (details.family === 'curved') {
    for (const [name, x] of Object.entries({ A, B, C, D: details.D })) put(name, x);
  } else {
    put('N.d', B);
    put('N.(E-P)', C);
    const [condition] = derivation(shape, ray, found).conditions;
    if (condition?.relation.left.op === 'norm') put('distance', condition.left);
  }
  for (const [i, hit] of found.hits.entries()) putHit(put, hit, i + 1);
  const rejected = rejectedHit(found);
  if (rejected) {
    put('t', rejected.t);
    put('X', rejected.point);
    const { distance } = rejected;
    if (distance > 0 && Number.isFinite(distance)) put('outside', distance);
  }
  if (found.class === 'contained') putSpan(put, shape, ray);
  return shown;
}

/**
 * The stretch of a line in a figure's plane that is in the figure; one number where it only
 * touches.
 */
function putSpan(put: (name: string, value: Value) => void, shape: Shape, ray: Ray): void {
  const span = spanInFigure(shape, ray);
  if (!span) return;
  put('t.from', span.from);
  if (!span.touches) put('t.to', span.to);
}

function putHit(put: (name: string, value: Value) => void, hit: Hit, n: number): void {
  put(`t${n}`, hit.t);
  put(`P${n}`, hit.point);
  if (!hit.singular) put(`N${n}`, hit.normal);
}

/** The point of the plane outside of a figure. */
function rejectedHit({ details }: Intersection): PlaneHit | null {
  return details.family === 'flat' && details.plane?.inside === false ? details.plane : null;
}

/** f(t) and R(t) at the bead, absent where doubles do not reach. */
export function expectedBead(shape: Shape, ray: Ray, t: number): Shown {
  const { point, f } = alongRay(shape, ray, t);
  const [x, y, z] = point;
  const finite = Object.entries({ t, f, x, y, z }).filter(([, value]) => Number.isFinite(value));
  return Object.fromEntries(finite.map(([name, value]) => [`bead.${name}`, text(value)]));
}
