import { InvalidInput, quote, refused } from '../invalid-input.ts';
import type { ShapeDefinition } from './define.ts';
import { SHAPES, type Shape } from './index.ts';
import { checkParam } from './params.ts';

/** The registry's entry for a kind, or undefined. */
export function findShape(kind: unknown): ShapeDefinition<Shape> | undefined {
  // One entry's functions take that entry's shape only; whoever looks one up by a shape's kind passes that shape.
  return BY_KIND.get(kind) as ShapeDefinition<Shape> | undefined;
}

const BY_KIND: ReadonlyMap<unknown, unknown> = new Map(SHAPES.map((shape) => [shape.kind, shape]));

export function definitionOf(shape: Shape): ShapeDefinition<Shape> {
  const found = findShape(shape?.kind);
  if (!found) {
    if (shape?.kind === undefined || shape.kind === null) throw refused('kind', '', undefined);
    throw new InvalidInput(`unknown shape ${quote(shape.kind)}`);
  }
  return found;
}

/** Throws InvalidInput unless every parameter of the shape is there and in its range. */
export function checkShape(shape: Shape): ShapeDefinition<Shape> {
  const definition = definitionOf(shape);
  const given = shape as unknown as Readonly<Record<string, unknown>>;
  for (const param of definition.params) checkParam(param, given[param.key]);
  return definition;
}
