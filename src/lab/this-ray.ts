import { fromNumber, type Surd, sub, toNumber } from '../math/exact.ts';
import type { Triple } from '../math/formula.ts';
import {
  type Hit,
  type Intersection,
  METHODS,
  type Ray,
  type Shape,
  ulpDistance,
  type Vec3,
} from '../math/index.ts';
import type { Method } from '../math/shapes.ts';
import { digitCount, type Marked, markDigits, rightDigits } from './digits.ts';
import { type ExactHit, type Reference, referenceOf } from './reference.ts';
import { type Judgement, judge } from './verdict.ts';

/** A root of a method beside the exact one. */
export interface RootRow {
  readonly t: number;
  /** Right digits, 0 … 15.95; null if there is no exact root to compare with. */
  readonly digits: number | null;
  readonly count: number;
  readonly marked: Marked;
  /** Error in ulps: doubles between this root and the correctly rounded one. */
  readonly ulps: number | null;
  /** How far the point lies from the exact one, in the unit of the coordinates. */
  readonly pointError: number | null;
}

export interface MethodRow {
  readonly method: Method;
  readonly found: Intersection;
  readonly judgement: Judgement;
  readonly roots: readonly RootRow[];
  /** Right digits of the worse root; null if there is none to compare. */
  readonly digits: number | null;
}

export interface ThisRay {
  readonly reference: Reference;
  readonly rows: readonly MethodRow[];
}

/** One ray by every method, each answer beside the exact one. */
export function thisRay(shape: Shape, ray: Ray): ThisRay {
  const reference = referenceOf(shape, ray);
  return { reference, rows: METHODS.map((method) => rowOf(method, shape, ray, reference)) };
}

function rowOf(method: Method, shape: Shape, ray: Ray, reference: Reference): MethodRow {
  const found = method.intersect(shape, ray);
  const judgement = judge(found.class, reference.found.class);
  const roots = found.hits.map((hit) => rootRow(hit, partnerOf(hit, found, reference), reference));
  const known = roots.flatMap(({ digits }) => (digits === null ? [] : [digits]));
  return { method, found, judgement, roots, digits: known.length ? Math.min(...known) : null };
}

/**
 * Index of the exact root to compare a root with: the one of the same rank if there are as many,
 * else the nearest; −1 if there is none.
 */
function partnerOf(hit: Hit, found: Intersection, { hits }: Reference): number {
  if (hits.length === found.hits.length) return found.hits.indexOf(hit);
  const gaps = hits.map(({ t }) => Math.abs(toNumber(t) - hit.t));
  return gaps.indexOf(Math.min(...gaps));
}

function rootRow(hit: Hit, partner: number, { found, hits }: Reference): RootRow {
  const exact = hits[partner];
  const nearest = found.hits[partner];
  const digits = exact ? rightDigits(hit.t, exact.t) : null;
  const count = digits === null ? 0 : digitCount(digits);
  return {
    t: hit.t,
    digits,
    count,
    marked: markDigits(hit.t, count),
    ulps: nearest ? ulpDistance(hit.t, nearest.t) : null,
    pointError: exact ? distance(hit.point, exact) : null,
  };
}

/** Distance of a point from the exact one; differences are exact, so that half an ulp shows. */
function distance(point: Vec3, { point: exact }: ExactHit): number {
  const off = (x: number, y: Surd): number =>
    Number.isFinite(x) ? toNumber(sub(fromNumber(x), y)) : Number.POSITIVE_INFINITY;
  const [x, y, z]: Triple<Surd> = exact;
  return Math.hypot(off(point[0], x), off(point[1], y), off(point[2], z));
}
