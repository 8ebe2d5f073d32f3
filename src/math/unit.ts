import { exact } from './arithmetic/exact.ts';
import { alongAxes, evaluateTriple } from './formula/evaluate.ts';
import { comp, norm, over, vec } from './formula/expr.ts';
import { lazily } from './lazily.ts';
import type { Vec3 } from './vec3.ts';

const unit = lazily(() => alongAxes((axis) => over(comp('d', axis), norm(vec('d')))));

/**
 * d / |d|, each component correctly rounded, at any scale; d must not be zero. What comes out is
 * not exactly of length 1: the components are doubles.
 *
 * @param d any but 0, of any unit.
 * @returns no unit; components from −1 to 1.
 * @throws RangeError for d = 0.
 * @see NUMERICS.md, section 4: correctly rounded (u + v√D)/w.
 * @example
 * unitVector([3, 0, -4]); // → [0.6, 0, -0.8]
 */
export function unitVector(d: Vec3): Vec3 {
  const lifted = [exact.of(d[0]), exact.of(d[1]), exact.of(d[2])] as const;
  const [x, y, z] = evaluateTriple(unit(), exact, { scalars: {}, vectors: { d: lifted } });
  return [exact.toNumber(x), exact.toNumber(y), exact.toNumber(z)];
}
