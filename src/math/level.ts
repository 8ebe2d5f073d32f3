import { float64 } from './arithmetic/float64.ts';
import { evaluate, evaluateTriple, withScalars } from './formula/evaluate.ts';
import { valuesOf } from './methods/tree-method.ts';
import type { Shape } from './shapes/index.ts';
import { definitionOf } from './shapes/lookup.ts';
import type { Vec3 } from './vec3.ts';

/** F on a line: C + B s + A s². */
interface OnLine {
  readonly A: number;
  readonly B: number;
  readonly C: number;
}

/** F = left − right of a surface's equation, off the surface too, in doubles. */
export interface Level {
  /** F(from + s · by) as a polynomial in s. */
  along(from: Vec3, by: Vec3): OnLine;
  /** Half the gradient of F at a point: the course's N; of a flat shape its N. */
  normal(at: Vec3): Vec3;
}

/**
 * F of a shape by its own trees, for pictures of its level surfaces. A flat shape's F is N·(X − P),
 * whatever the conditions of its figure.
 *
 * @param shape as for `intersect`.
 * @see NUMERICS.md, section 1: surfaces, and A, B and C.
 * @example
 * const sphere = { kind: 'sphere', center: [0, 0, 0], radius: 2 } as const;
 * levelOf(sphere).along([3, 0, 0], [1, 0, 0]); // → { A: 1, B: 6, C: 5 }
 */
export function levelOf(shape: Shape): Level {
  const formula = definitionOf(shape).formula(shape);
  const at = (origin: Vec3, direction: Vec3) => valuesOf(shape, { origin, direction }, float64);
  if (formula.family === 'flat') {
    return {
      along(from, by) {
        const values = at(from, by);
        const [B, C] = [formula.rate, formula.offset].map((tree) =>
          evaluate(tree, float64, values),
        );
        return { A: 0, B: B ?? 0, C: C ?? 0 };
      },
      normal: (point) => at(point, point).vectors.N as Vec3,
    };
  }
  return {
    along(from, by) {
      const values = at(from, by);
      const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], float64, values);
      return { A, B, C };
    },
    normal([x, y, z]) {
      const values = withScalars(at([x, y, z], [x, y, z]), { x, y, z });
      return evaluateTriple(formula.normal, float64, values);
    },
  };
}
