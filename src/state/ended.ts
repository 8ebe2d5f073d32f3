import { type Arithmetic, evaluate, exact, float64, valuesOf, withPoint } from '../math/formula.ts';
import {
  type Fate,
  type Hit,
  type Intersection,
  intersect,
  type Ray,
  type Shape,
} from '../math/index.ts';
import { definitionOf } from '../math/shapes.ts';
import { display } from '../text/format.ts';
import { subscript } from '../text/scripts.ts';
import { CAP_NAMES, type End } from './ends.ts';
import { type Between, heightsText, whyCut } from './heights.ts';
import type { HitRole } from './scene-model.ts';
import { sidesOf } from './sides.ts';

/** A hit on a cap, in words as seen from E along the ray. */
export interface CapHit {
  readonly end: End;
  readonly hit: Hit;
  readonly role: HitRole;
  /** "first hit, enters" */
  readonly text: string;
}

/** The point where the line crosses the plane of a cap, on the cap or beside it. */
export interface CapLine {
  readonly end: End;
  readonly height: number;
  /** Null for a ray parallel to the caps. */
  readonly at: {
    readonly t: number;
    readonly point: readonly [number, number, number];
    /** Both sides of the surface's equation there: left ≤ right is within its circle. */
    readonly left: number;
    readonly right: number;
    /** The sign of left − right. */
    readonly side: number;
  } | null;
  readonly isHit: boolean;
  /** What becomes of it, in words. */
  readonly text: string;
}

/** The hits that remain of a curved shape with ends, and what became of each root. */
export interface Ended {
  readonly between: Between;
  readonly caps: boolean;
  /** All hits, ascending in t. */
  readonly hits: readonly Hit[];
  readonly fates: readonly { readonly t: number; readonly fate: Fate }[];
  /** By root: why it is cut off; null where it is not. */
  readonly cut: readonly (string | null)[];
  /** Which root is the first visible hit; null if a cap or nothing is. */
  readonly firstRoot: number | null;
  readonly capHits: readonly CapHit[];
  /** Empty where the ends are open. */
  readonly capLines: readonly CapLine[];
  /** t where the line is at the lower and at the upper end; null where it stays at one height. */
  readonly crossed: readonly [number, number] | null;
  /** Whether a line that stays at one height does so between the ends. */
  readonly isWithin: boolean;
  /** Whether anything is hit at t ≥ 0. */
  readonly isSeen: boolean;
  /** What is left, in a clause: "t₁ is cut off, first hit t₂". */
  readonly text: string;
  /** What exact arithmetic says, where the method says something else; null otherwise. */
  readonly contradicted: string | null;
}

interface EndHit {
  readonly root: number | null;
  readonly end: End | null;
  readonly hit: Hit;
  readonly side: number;
}

/** Which end a cap's normal belongs to. */
const endOf = ({ normal }: Hit): End => (normal[1] > 0 ? 'high' : 'low');

/** The hits in order of t, each with the exact sign of its t. */
function metBy(hits: readonly Hit[], whole: Intersection, ray: Ray, between: Between): EndHit[] {
  const sides = sidesOf(whole);
  let next = 0;
  return hits.map((hit) => {
    if (hit.fate !== 'cap') {
      const root = next++;
      return { root, end: null, hit, side: sides[root] ?? Math.sign(hit.t) };
    }
    const end = endOf(hit);
    const [, y] = ray.origin;
    // A difference of doubles has the sign of the exact one.
    const gap = between[end === 'low' ? 0 : 1] - y;
    return { root: null, end, hit, side: Math.sign(gap) * Math.sign(ray.direction[1]) };
  });
}

const isLeft = ({ hit }: EndHit): boolean => hit.fate !== 'cut';

/** Null for a flat shape, which has no ends. */
export function endedOf(
  shape: Shape,
  ray: Ray,
  found: Intersection,
  exactly: Intersection,
  between: Between | null,
  caps: boolean,
): Ended | null {
  if (between === null || found.details.family === 'flat') return null;
  const solid = { ...shape, between, caps };
  const met = metBy(intersect(solid, ray, found.method).hits, found, ray, between);
  const truly = metBy(intersect(solid, ray, 'exact').hits, exactly, ray, between);
  const first = met.find((one) => isLeft(one) && one.side >= 0) ?? null;
  const text = textOf(met, first, found, ray, between);
  const truth = textOf(
    truly,
    truly.find((one) => isLeft(one) && one.side >= 0) ?? null,
    exactly,
    ray,
    between,
  );
  const capHits = met.flatMap((one): CapHit[] => {
    if (one.end === null) return [];
    const role: HitRole = one === first ? 'first' : one.side < 0 ? 'behind' : 'other';
    return [{ end: one.end, hit: one.hit, role, text: capText(one, role, ray) }];
  });
  return {
    between,
    caps,
    hits: met.map(({ hit }) => hit),
    fates: met.map(({ hit: { t, fate = 'hit' } }) => ({ t, fate })),
    cut: met
      .filter(({ root }) => root !== null)
      .map(({ hit }) => (hit.fate === 'cut' ? whyCut(hit.point, between) : null)),
    firstRoot: first?.root ?? null,
    capHits,
    capLines: caps ? capLines(shape, ray, found.method, between, capHits) : [],
    crossed: crossedAt(ray, between),
    isWithin: ray.origin[1] >= between[0] && ray.origin[1] <= between[1],
    isSeen: first !== null,
    text,
    contradicted: truth === text || found.class === 'undecided' ? null : truth,
  };
}

function crossedAt({ origin, direction }: Ray, [low, high]: Between) {
  const dy = direction[1];
  if (dy === 0) return null;
  return [(low - origin[1]) / dy, (high - origin[1]) / dy] as const;
}

function capText({ end, side }: EndHit, role: HitRole, { direction }: Ray): string {
  if (role === 'behind') return 'behind E';
  const outwards = direction[1] > 0 === (end === 'high');
  const start = side === 0 ? 'E itself' : role === 'first' ? 'first hit' : '';
  return [start, outwards ? 'leaves' : 'enters'].filter(Boolean).join(', ');
}

/** "t₁ is cut off, first hit at t = 1.25 on the upper cap" */
function textOf(
  met: readonly EndHit[],
  first: EndHit | null,
  found: Intersection,
  { origin, direction }: Ray,
  between: Between,
): string {
  if (found.class === 'contained') {
    const isWithin = origin[1] >= between[0] && origin[1] <= between[1];
    if (direction[1] !== 0) return 'of the line that part is left';
    return isWithin ? 'all of the line is left' : 'nothing of the line is left';
  }
  const names = met.flatMap(({ root, hit }) =>
    root !== null && hit.fate === 'cut' ? [nameOf(root, found)] : [],
  );
  const gone =
    names.length === 0 ? [] : [`${names.join(' and ')} ${names.length > 1 ? 'are' : 'is'} cut off`];
  return [...gone, hitClause(met, first, found)].join(', ');
}

const nameOf = (root: number, { hits }: Intersection): string =>
  hits.length > 1 ? `t${subscript(root + 1)}` : 'the root';

function hitClause(met: readonly EndHit[], first: EndHit | null, found: Intersection): string {
  if (first?.end) return `first hit at ${atT(first)} on the ${CAP_NAMES[first.end]}`;
  if (first) return `first hit ${nameOf(first.root ?? 0, found)}`;
  return met.some(isLeft) ? 'all that is left is behind E' : 'nothing is hit';
}

const atT = ({ hit }: EndHit): string => `t = ${display(hit.t)}`;

/** Exact where the method's answers are, else by doubles, as the method itself. */
function capLines(
  shape: Shape,
  ray: Ray,
  method: string,
  between: Between,
  hits: readonly CapHit[],
): CapLine[] {
  const sides = definitionOf(shape).surface;
  const isExact = method === 'exact' || method === 'certified';
  const at = (height: number): CapLine['at'] =>
    isExact
      ? placeAt(shape, ray, height, sides, exact)
      : placeAt(shape, ray, height, sides, float64);
  return (['low', 'high'] as const).map((end, i) => {
    const height = between[i] ?? 0;
    const hit = hits.find((one) => one.end === end);
    const there = ray.direction[1] === 0 ? null : at(height);
    const text = hit?.text ?? besideText(there?.side ?? null);
    return { end, height, at: there, isHit: hit !== undefined, text };
  });
}

function besideText(side: number | null): string {
  if (side === null) return 'the ray is parallel to it';
  return side === 0 ? 'on its rim, where the root counts' : 'beside it';
}

function placeAt<T>(
  shape: Shape,
  ray: Ray,
  height: number,
  { left, right }: ReturnType<typeof definitionOf>['surface'],
  arithmetic: Arithmetic<T>,
): CapLine['at'] {
  const values = valuesOf(shape, ray, arithmetic);
  const { E, d } = values.vectors;
  if (!E || !d) return null;
  const y = arithmetic.of(height);
  const t = arithmetic.div(arithmetic.sub(y, E[1]), d[1]);
  const along = (i: 0 | 2): T => arithmetic.add(E[i], arithmetic.mul(t, d[i]));
  const point = [along(0), y, along(2)] as const;
  const there = withPoint(values, point);
  const number = (x: T): number => arithmetic.toNumber(x);
  const sides = [left, right].map((side) => evaluate(side, arithmetic, there)) as [T, T];
  return {
    t: number(t),
    point: [number(point[0]), height, number(point[2])],
    left: number(sides[0]),
    right: number(sides[1]),
    side: arithmetic.sign(arithmetic.sub(...sides)),
  };
}

/** A note for a flat shape that was opened with heights from a scene, which would cut it. */
export function flatNote(name: string, between: Between, found: Intersection): string {
  const cuts = found.hits.flatMap(({ point }) => {
    const [low, high] = between;
    const isCut = point[1] < low || point[1] > high;
    return isCut ? [` There t is cut off: ${whyCut(point, between)}.`] : [];
  });
  return `A scene may keep this ${name} between ${heightsText(between)}; here it is whole.${cuts}`;
}
