import { exact } from '../../../src/math/arithmetic/exact.ts';
import type { Surd } from '../../../src/math/exact/surd.ts';
import { POINT } from '../../../src/math/formula/common.ts';
import {
  dotProduct,
  evaluate,
  evaluateTriple,
  type Triple,
  withScalars,
} from '../../../src/math/formula/evaluate.ts';
import { valuesOf } from '../../../src/math/methods/tree-method.ts';
import type { Ray } from '../../../src/math/ray.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';

/** Whether the line meets the figure's plane exactly on its rim or edge; N·d ≠ 0. */
export function onBoundary(shape: Shape, ray: Ray): boolean {
  const formula = definitionOf(shape).formula(shape);
  if (formula.family !== 'flat') throw new Error(`a flat shape is needed, got ${shape.kind}`);
  const values = valuesOf(shape, ray, exact);
  const t = evaluate(formula.t, exact, values);
  const x = evaluateTriple(POINT, exact, withScalars(values, { t }));
  return shape.kind === 'circle'
    ? onRim(x, values.vectors.C as Triple<Surd>, shape.radius)
    : shape.kind === 'square' && onEdge(x, values.vectors.P as Triple<Surd>, shape);
}

function onRim(x: Triple<Surd>, center: Triple<Surd>, radius: number): boolean {
  const from = x.map((c, i) => exact.sub(c, center[i] as Surd)) as unknown as Triple<Surd>;
  return exact.sign(exact.sub(dotProduct(from, from, exact), exact.sqr(exact.of(radius)))) === 0;
}

function onEdge(
  x: Triple<Surd>,
  corner: Triple<Surd>,
  { side, axis }: Extract<Shape, { kind: 'square' }>,
): boolean {
  const others = ([0, 1, 2] as const).filter((i) => 'xyz'[i] !== axis);
  const places = others.map((i) => {
    const from = exact.sub(x[i], corner[i]);
    return [exact.sign(from), exact.sign(exact.sub(exact.of(side), from))];
  });
  return places.every(([a, b]) => a !== -1 && b !== -1) && places.flat().includes(0);
}
