import { SHAPES, type Shape, type Vec3 } from '../../math/index.ts';
import { integer, pick, type Random, seeded } from '../../math/rng.ts';
import {
  AXES,
  type Axis,
  definitionOf,
  findShape,
  type Param,
  type ShapeKind,
} from '../../math/shapes.ts';
import { courseOf } from '../course.ts';
import type { Answers, Input } from '../types.ts';
import { roughCase, roughWork } from '../work.ts';
import type { Level } from './define.ts';

/** A whole number, or from level 3 on sometimes a half. */
const coordinate = (random: Random, size: number, level: Level): number =>
  integer(random, -size, size) + (level === 3 && random() < 0.2 ? 0.5 : 0);

const vector = (random: Random, size: number, level: Level): Vec3 => [
  coordinate(random, size, level),
  coordinate(random, size, level),
  coordinate(random, size, level),
];

const isZero = (v: Vec3): boolean => v.every((x) => x === 0);

function nonZero(random: Random, size: number, level: Level): Vec3 {
  for (;;) {
    const v = vector(random, size, level);
    if (!isZero(v)) return v;
  }
}

function paramValue(random: Random, param: Param, level: Level): Vec3 | number | Axis {
  if (param.type === 'axis') return pick(random, AXES as [Axis, ...Axis[]]);
  if (param.type === 'vector') {
    return param.nonZero ? nonZero(random, 2, 1) : vector(random, level + 1, level);
  }
  // Lengths are whole, ratios in halves; neither is 0.
  const [low, high] = param.range;
  for (;;) {
    const x =
      param.least === undefined ? integer(random, 2 * low, 2 * high) / 2 : integer(random, 1, 5);
    if (x !== 0) return x;
  }
}

/** The shape with small clean numbers. */
export function drawShape(random: Random, kind: ShapeKind, level: Level): Shape {
  const params = (findShape(kind)?.params ?? []).map(
    (param) => [param.key, paramValue(random, param, level)] as const,
  );
  return { kind, ...Object.fromEntries(params) } as unknown as Shape;
}

export function drawInput(random: Random, kind: ShapeKind, level: Level): Input {
  const origin = vector(random, 3 + 2 * level, level);
  const direction = nonZero(random, 1 + level, 1);
  return { shape: drawShape(random, kind, level), ray: { origin, direction } };
}

/** Fisher and Yates. */
export function shuffled<T>(random: Random, list: readonly T[]): T[] {
  const all = [...list];
  for (let i = all.length - 1; i > 0; i--) {
    const k = integer(random, 0, i);
    [all[i], all[k]] = [all[k] as T, all[i] as T];
  }
  return all;
}

/** Draws until `accept` holds; null after 4000 draws. */
export function drawUntil<T>(draw: () => T, accept: (drawn: T) => boolean): T | null {
  for (let i = 0; i < 4000; i++) {
    const drawn = draw();
    if (accept(drawn)) return drawn;
  }
  return null;
}

/** The kinds of all curved or all flat shapes, in the order of the menu. */
export function kindsOf(family: 'curved' | 'flat'): ShapeKind[] {
  return SHAPES.map(({ kind }) => kind).filter((kind) => {
    const params = findShape(kind)?.params ?? [];
    const initial = Object.fromEntries(params.map((p) => [p.key, p.initial] as const));
    return courseOf({ kind, ...initial } as unknown as Shape).family === family;
  });
}

/** Whether A may be 0 for some direction; not so for a sphere. */
export const mayBeStraight = (kind: ShapeKind): boolean => {
  const shape = drawShape(seeded(1), kind, 1);
  return definitionOf(shape).named(shape).straight !== null;
};

const DENOMINATORS = [1, 2, 3, 4, 5, 6, 8, 10];

/**
 * Tolerance in the test for a fraction that is easy on paper: rounding errors are far below it,
 * other fractions far above.
 */
const NOISE = 1e-9;

export function isClean(x: unknown): boolean {
  if (typeof x === 'object' && Array.isArray(x)) return x.every(isClean);
  if (typeof x !== 'number' || Math.abs(x) > 500) return false;
  return DENOMINATORS.some((k) => Math.abs(x * k - Math.round(x * k)) < NOISE);
}

export const allClean = (answers: Answers, ids: readonly string[]): boolean =>
  ids.every((id) => isClean(answers[id]));

/** A number among the answers, NaN if it is not there. */
export const numberOf = (answers: Answers, id: string): number => {
  const x = answers[id];
  return typeof x === 'number' ? x : Number.NaN;
};

export const chosen = (answers: Answers, ids: readonly string[]): Answers =>
  Object.fromEntries(
    ids.flatMap((id) => {
      const answer = answers[id];
      return answer === undefined ? [] : [[id, answer] as const];
    }),
  );

/** Whether |d| = 1, where a t taken for a distance cannot be noticed. */
export const hasUnitLength = ([x, y, z]: Vec3): boolean => x * x + y * y + z * z === 1;

/** All answers for an input with two clean roots; null for others, mostly by A, B and C alone. */
export function withTwoCleanRoots(input: Input): Answers | null {
  const course = courseOf(input.shape);
  const letters = roughCase(course, input);
  if (letters.case !== 'two') return null;
  const [A, B, D] = [numberOf(letters, 'A'), numberOf(letters, 'B'), numberOf(letters, 'D')];
  const root = Math.sqrt(D);
  if (!isClean((-B - root) / (2 * A)) || !isClean((root - B) / (2 * A))) return null;
  const found = roughWork(course, input);
  return found.case === 'two' && allClean(found, ['A', 'B', 'C', 't1', 't2']) ? found : null;
}
