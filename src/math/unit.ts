import { exact } from './arithmetic/exact.ts';
import { alongAxes, evaluateTriple } from './formula/evaluate.ts';
import { comp, type ExprTriple, norm, over, vec } from './formula/expr.ts';
import type { Vec3 } from './vec3.ts';

const UNIT: ExprTriple = alongAxes((axis) => over(comp('d', axis), norm(vec('d'))));

/**
 * d / |d|, each component correctly rounded, at any scale; d must not be zero. What comes out is
 * not exactly of length 1: the components are doubles.
 */
export function unitVector(d: Vec3): Vec3 {
  const lifted = [exact.of(d[0]), exact.of(d[1]), exact.of(d[2])] as const;
  const [x, y, z] = evaluateTriple(UNIT, exact, { scalars: {}, vectors: { d: lifted } });
  return [exact.toNumber(x), exact.toNumber(y), exact.toNumber(z)];
}
