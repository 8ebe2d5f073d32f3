import { countFields, InvalidInput, quote, refused, requireFields } from '../invalid-input.ts';
import { type Given, plainVector } from '../vec3.ts';
import type { ShapeDefinition } from './define.ts';
import { SHAPES, type Shape } from './index.ts';
import { checkParam } from './params.ts';

/** The registry's entry for a kind, or undefined. */
export function findShape(kind: unknown): ShapeDefinition<Shape> | undefined {
  // One entry's functions take that entry's shape only; whoever looks one up by a shape's kind
  // passes that shape.
  return BY_KIND.get(kind) as ShapeDefinition<Shape> | undefined;
}

const BY_KIND: ReadonlyMap<unknown, unknown> = new Map(SHAPES.map((shape) => [shape.kind, shape]));

const FIELDS: ReadonlyMap<string, readonly string[]> = new Map(
  SHAPES.map(({ kind, params }) => [kind, params.map(({ key }) => key)]),
);

/**
 * What a name that people may look for is here: "a hyperboloid with a = -1"; null for a name that
 * nothing has.
 */
export function knownAs(name: unknown): string | null {
  for (const { kind } of SHAPES) {
    const { title, alsoCalled = {} } = findShape(kind) ?? {};
    if (Object.hasOwn(alsoCalled, String(name)))
      return `a ${title} with ${alsoCalled[String(name)]}`;
  }
  return null;
}

export function definitionOf(shape: Shape): ShapeDefinition<Shape> {
  const found = findShape(shape?.kind);
  if (!found) {
    if (shape?.kind === undefined || shape.kind === null) throw refused('kind', '', undefined);
    throw new InvalidInput(`unknown shape ${quote(shape.kind)}`);
  }
  return found;
}

/**
 * The shape with its vectors as plain arrays: itself, where they are. Throws InvalidInput unless
 * every parameter of its kind is there and in its range, and nothing else.
 */
export function checkedShape(shape: Given<Shape>): Shape {
  const { kind, params } = definitionOf(shape as Shape);
  const given = shape as unknown as Readonly<Record<string, unknown>>;
  const odd = countFields(given) !== params.length + 1;
  let plain = true;
  for (const param of params) {
    const value = given[param.key];
    if (odd || value === undefined) requireFields(kind, given, FIELDS.get(kind) ?? [], 'kind');
    checkParam(param, value);
    if (param.type === 'vector' && !Array.isArray(value)) plain = false;
  }
  if (plain) return shape as Shape;
  const own = params.map(({ key, type }) => [
    key,
    type === 'vector' ? plainVector(given[key] as ArrayLike<number>) : given[key],
  ]);
  return { kind, ...Object.fromEntries(own) } as Shape;
}
