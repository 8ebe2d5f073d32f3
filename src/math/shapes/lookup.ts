import { InvalidInput, quote, refused } from '../invalid-input.ts';
import { lazily } from '../lazily.ts';
import type { Given } from '../vec3.ts';
import { checkedBy } from './checked.ts';
import type { ShapeDefinition } from './define.ts';
import { SHAPES, type Shape } from './index.ts';

/**
 * The registry's entry for a kind, or undefined.
 *
 * @param kind anything; a shape's `kind` has an entry.
 * @example
 * findShape('cone')?.title; // → 'cone'
 * findShape('torus'); // → undefined
 */
export function findShape(kind: unknown): ShapeDefinition<Shape> | undefined {
  // One entry's functions take that entry's shape only; whoever looks one up by a shape's kind
  // passes that shape.
  return byKind().get(kind) as ShapeDefinition<Shape> | undefined;
}

const byKind = lazily(
  (): ReadonlyMap<unknown, unknown> => new Map(SHAPES.map((shape) => [shape.kind, shape])),
);

/**
 * What a name that people may look for is here: "a hyperboloid with a = -1"; null for a name that
 * nothing has.
 *
 * @param name anything.
 * @example
 * knownAs('ellipsoid'); // → 'a hyperboloid with a < 0'
 * knownAs('torus'); // → null
 */
export function knownAs(name: unknown): string | null {
  for (const { kind } of SHAPES) {
    const { title, alsoCalled = {} } = findShape(kind) ?? {};
    if (Object.hasOwn(alsoCalled, String(name)))
      return `a ${title} with ${alsoCalled[String(name)]}`;
  }
  return null;
}

/**
 * The registry's entry for a shape.
 *
 * @param shape only its `kind` is looked at.
 * @throws InvalidInput for a kind that there is not.
 * @example
 * const sphere = { kind: 'sphere', center: [0, 0, 0], radius: 1 } as const;
 * definitionOf(sphere).params.map(({ symbol }) => symbol); // → ['C', 'r']
 */
export function definitionOf(shape: Shape): ShapeDefinition<Shape> {
  const found = findShape(shape?.kind);
  if (!found) {
    if (shape?.kind === undefined || shape.kind === null) throw refused('kind', '', undefined);
    throw new InvalidInput(`unknown shape ${quote(shape.kind)}`);
  }
  return found;
}

/**
 * The shape with its vectors as plain arrays: itself, where they are.
 *
 * @param shape what a caller gave.
 * @throws InvalidInput unless every parameter of its kind is there and in its range, and nothing
 *   else.
 * @example
 * checkedShape({ kind: 'sphere', center: Float64Array.of(1, 2, 3), radius: 1 });
 * // → { kind: 'sphere', center: [1, 2, 3], radius: 1 }
 * checkedShape({ kind: 'sphere', center: [0, 0, 0], radius: -1 });
 * // throws InvalidInput: radius must be ≥ 0, got -1
 */
export function checkedShape(shape: Given<Shape>): Shape {
  return checkedBy(definitionOf(shape as Shape), shape);
}
