import type { Page } from '@playwright/test';
import { type Ray, SHAPES, type Shape, type Vec3 } from '../../../src/math/index.ts';
import type { NumberParam, Param, VectorParam } from '../../../src/math/shapes/params.ts';
import { RAY_PARAMS } from '../../../src/state/state.ts';
import { expected } from './expected.ts';
import { quantities } from './page.ts';
import { expect } from './test.ts';

/** What is asked of the math module. */
export interface Question {
  readonly shape: Shape;
  readonly ray: Ray;
}

export type Moved = VectorParam | NumberParam;
export type MovedValue = Vec3 | number;

const ownParams = (kind: Shape['kind']): readonly Param[] =>
  SHAPES.find((shape) => shape.kind === kind)?.params ?? [];

/** The parameters of the ray and of a shape that are numbers. */
export function movedParams(kind: Shape['kind']): Moved[] {
  const all = [RAY_PARAMS.E, RAY_PARAMS.d, ...ownParams(kind)];
  return all.filter((param): param is Moved => param.type !== 'axis');
}

/** What the page opens with. */
export function initial(kind: Shape['kind']): Question {
  const own = ownParams(kind).map((param) => [param.key, param.initial]);
  return {
    shape: { kind, ...Object.fromEntries(own) } as Shape,
    ray: { origin: RAY_PARAMS.E.initial, direction: RAY_PARAMS.d.initial },
  };
}

export function currentOf({ shape, ray }: Question, { key }: Moved): MovedValue {
  return ({ ...shape, ...ray } as unknown as Record<string, MovedValue>)[key] ?? 0;
}

/** The question with one parameter changed. */
export function withValue({ shape, ray }: Question, { key }: Moved, value: MovedValue): Question {
  return key in ray
    ? { shape, ray: { ...ray, [key]: value } }
    : { shape: { ...shape, [key]: value } as Shape, ray };
}

/** The page shows the math module's answer to this question, and nothing else. */
export async function expectShown(page: Page, { shape, ray }: Question): Promise<void> {
  const shown = Object.entries(await quantities(page)).filter(
    ([name]) => !name.startsWith('bead.'),
  );
  expect(Object.fromEntries(shown)).toEqual(expected(shape, ray, 'exact'));
}
