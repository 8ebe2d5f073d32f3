import type { Shape } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import type { Draft } from './define.ts';

type Param = NonNullable<Draft['param']>;

/** The shape's parameters that are single numbers: r, c, a. */
export function numberParams(shape: Shape): Param[] {
  return definitionOf(shape).params.flatMap(({ type, symbol, key }) =>
    type === 'number' ? [{ symbol, key, value: numberIn(shape, key) }] : [],
  );
}

const numberIn = (shape: Shape, key: string): number =>
  (shape as unknown as Readonly<Record<string, number>>)[key] ?? Number.NaN;

export const withParam = (shape: Shape, { key }: Param, value: number): Shape =>
  ({ ...shape, [key]: value }) as Shape;
