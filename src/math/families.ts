import { linearCancellation, nearAxis } from './families/asymptotes.ts';
import type { Family } from './families/define.ts';
import { circle, circleRim, square, squareEdge } from './families/figures.ts';
import { generator, linear, nearGenerator } from './families/generators.ts';
import { mix } from './families/mix.ts';
import { farOrigin, typical } from './families/ordinary.ts';
import { plane, planeFar, planeGrazing } from './families/planes.ts';
import { extremeParameter, outOfRange, scaleRay, scaleWorld } from './families/scales.ts';
import { cancellation, nearSurface, onSurface } from './families/starts.ts';
import { exactTangent, nearTangent, nearTangentFar } from './families/tangents.ts';
import { vertex } from './families/vertex.ts';
import { degenerate, flatDegenerate } from './families/whole.ts';

export type { Dial, Family, Question } from './families/define.ts';

/** Every family there is, easy ones first and flat ones last. A new one is one entry. */
export const FAMILIES: readonly Family[] = [
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

export const findFamily = (id: string): Family | undefined =>
  FAMILIES.find((family) => family.id === id);
