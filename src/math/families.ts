import { linearCancellation, nearAxis } from './families/asymptotes.ts';
import { circle, circleRim, square, squareEdge } from './families/circle-and-square.ts';
import {
  type Family,
  type FamilyParts,
  family,
  type Hardness,
  type Setting,
} from './families/define.ts';
import { degenerate, flatDegenerate } from './families/degenerate.ts';
import { generator, linear, nearGenerator } from './families/generators.ts';
import { mix } from './families/mix.ts';
import { cancellation, nearSurface, onSurface } from './families/near-surface.ts';
import { familiesOfShape } from './families/of-shape.ts';
import { farOrigin, typical } from './families/ordinary.ts';
import { plane, planeFar, planeGrazing } from './families/planes.ts';
import { extremeParameter, outOfRange, scaleRay, scaleWorld } from './families/scales.ts';
import { exactTangent, nearTangent, nearTangentFar } from './families/tangents.ts';
import { vertex } from './families/vertex.ts';
import { lazily } from './lazily.ts';
import type { ShapeDefinition } from './shapes/define.ts';
import { SHAPES, type Shape } from './shapes/index.ts';

export type { Dial, Family, Question } from './families/define.ts';
export { type Random, seeded } from './rng.ts';

const DEFINITIONS = SHAPES as unknown as readonly ShapeDefinition<Shape>[];

/** By kind, of the shapes that have no families written for them. */
const ofShape = lazily((): ReadonlyMap<string, readonly Family[]> => {
  const without = DEFINITIONS.filter(({ ownFamilies }) => !ownFamilies);
  return new Map(without.map((definition) => [definition.kind, familiesOfShape(definition)]));
});

/**
 * Families made for one shape: those of that hardness; none for the shapes that have their own.
 *
 * @param kind a shape's `kind`.
 * @param hardness the group of Check's cases.
 * @example
 * madeFamilies('sphere', 'hard').length > 0; // → true
 * madeFamilies('cone', 'hard'); // → []
 */
export const madeFamilies = (kind: string, hardness: Hardness | 'invalid'): readonly Family[] =>
  (ofShape().get(kind) ?? []).filter((family) => family.hardness === hardness);

/**
 * The families that are not made from a shape's parameters: curved shapes easy ones first, then
 * flat ones. A new one is one word.
 *
 * @example
 * WRITTEN_FAMILIES().includes(findFamily('vertex')!); // → true
 */
export const WRITTEN_FAMILIES = lazily((): readonly Family[] => WRITTEN.map(family));

const WRITTEN: readonly FamilyParts<Setting>[] = [
  typical,
  mix,
  farOrigin,
  nearTangent,
  nearTangentFar,
  exactTangent,
  nearAxis,
  linear,
  generator,
  nearGenerator,
  vertex,
  onSurface,
  nearSurface,
  cancellation,
  linearCancellation,
  scaleRay,
  scaleWorld,
  outOfRange,
  extremeParameter,
  degenerate,
  flatDegenerate,
  plane,
  planeGrazing,
  planeFar,
  circle,
  circleRim,
  square,
  squareEdge,
];

/**
 * Every family there is: the written ones, then those made for single shapes.
 *
 * @example
 * const { shape, rays } = FAMILIES()[0]!.batch(seeded(7), 100);
 * rays.length; // → 100
 * intersect(shape, rays[0]!).method; // → 'certified'
 */
export const FAMILIES = lazily((): readonly Family[] => [
  ...WRITTEN_FAMILIES(),
  ...[...ofShape().values()].flat(),
]);

/**
 * The family with this `id`, or undefined.
 *
 * @param id any text.
 * @example
 * const { shape, ray } = findFamily('exact-tangent')!.make(seeded(7));
 * intersect(shape, ray).class; // → 'tangent'
 * findFamily('easy'); // → undefined
 */
export const findFamily = (id: string): Family | undefined =>
  FAMILIES().find((family) => family.id === id);
