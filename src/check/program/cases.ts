import type { Family } from '../../math/families/define.ts';
import { FAMILIES, findFamily } from '../../math/families.ts';
import { intersect } from '../../math/intersect.ts';
import type { Intersection } from '../../math/intersection.ts';
import { type Random, seeded } from '../../math/rng.ts';
import type { ShapeKind } from '../../math/shapes/index.ts';
import { findShape } from '../../math/shapes/lookup.ts';
import type { Vec3 } from '../../math/vec3.ts';
import type { Input } from '../types.ts';

/** What a right program returns: every root of the whole line, ascending, a tangent's once. */
export interface Expected {
  readonly class: Intersection['class'];
  readonly t: readonly number[];
  readonly normal: readonly Vec3[];
}

export interface Case extends Input {
  /** Stays the same for the same shapes and seed: results from elsewhere are matched by it. */
  readonly id: string;
  readonly group: GroupId;
  /** What is special about it, in a few words. */
  readonly family: string;
  /** Null for an invalid input: the program must throw, or return no t. */
  readonly expected: Expected | null;
}

/** Each group is graded by itself. A family of src/math/families belongs to one. */
export const GROUPS = [
  {
    id: 'ordinary',
    title: 'ordinary',
    families: ['typical', 'plane', 'circle', 'square'],
    each: 14,
  },
  {
    id: 'special',
    title: 'special',
    families: [
      ...['exact-tangent', 'linear', 'generator', 'vertex', 'on-surface', 'degenerate'],
      ...['flat-degenerate', 'circle-rim', 'square-edge'],
    ],
    each: 6,
  },
  {
    id: 'hard',
    title: 'hard',
    families: [
      ...['far-origin', 'near-tangent', 'near-axis', 'near-generator', 'near-surface'],
      ...['cancellation', 'scale-ray', 'plane-grazing', 'plane-far'],
    ],
    each: 6,
  },
  { id: 'invalid', title: 'invalid', families: [], each: 0 },
] as const;

export type GroupId = (typeof GROUPS)[number]['id'];

/** A family may be about other shapes: this many draws without one of the wanted kind, and it is. */
const MAX_DRAWS = 60;

/** The exact cases for these shapes, the same for the same seed everywhere. */
export function casesFor(kinds: readonly ShapeKind[], seed: number): readonly Case[] {
  return kinds.flatMap((kind) => [
    ...GROUPS.flatMap((group) =>
      group.families.flatMap((id) => {
        const family = findFamily(id);
        return family ? familyCases(kind, group.id, family, group.each, seed) : [];
      }),
    ),
    ...invalidCases(kind),
  ]);
}

function familyCases(
  kind: ShapeKind,
  group: GroupId,
  family: Family,
  count: number,
  seed: number,
): Case[] {
  const random = seeded(Math.imul(seed + 1, 0x9e3779b1) ^ (FAMILIES.indexOf(family) * 0x85ebca6b));
  const found: Case[] = [];
  for (let misses = 0; found.length < count && misses < MAX_DRAWS; ) {
    const input = drawn(family, random);
    if (!Object.is(input.shape.kind, kind)) {
      misses++;
      continue;
    }
    const { class: verdict, hits } = intersect(input.shape, input.ray, 'exact');
    // Beyond the doubles there is nothing that a program could return.
    if (hits.some(({ t }) => !Number.isFinite(t))) {
      misses++;
      continue;
    }
    found.push({
      ...input,
      id: `${kind}/${family.id}/${found.length + 1}`,
      group,
      family: family.title,
      expected: {
        class: verdict,
        t: hits.map(({ t }) => t),
        normal: hits.map(({ normal }) => normal),
      },
    });
  }
  return found;
}

/** Rims and edges exactly, moved by 2^-2000, that is by no double: to which side a rounding falls is no fair question. */
const NOT_NUDGED = -2000;

function drawn(family: Family, random: Random): Input {
  return /rim|edge/.test(family.id) ? family.make(random, NOT_NUDGED) : family.make(random);
}

/** One wrong number at a time, all else in order. */
function invalidCases(kind: ShapeKind): Case[] {
  const params = findShape(kind)?.params ?? [];
  const initial = Object.fromEntries(
    params.map(({ key, initial: value }) => [key, value] as const),
  );
  const ray = { origin: [3, 1, 1] as Vec3, direction: [-1, 0, 0] as Vec3 };
  const wrong: [string, Record<string, unknown>, unknown][] = [
    ['d = (0, 0, 0)', {}, { ...ray, direction: [0, 0, 0] }],
    ['d with NaN', {}, { ...ray, direction: [Number.NaN, 0, 1] }],
    ['E with an infinity', {}, { ...ray, origin: [Number.POSITIVE_INFINITY, 0, 0] }],
  ];
  for (const param of params) {
    if (param.type === 'number' && param.least !== undefined) {
      wrong.push([`${param.symbol} = −1`, { [param.key]: -1 }, ray]);
    }
    if (param.type === 'vector' && param.nonZero) {
      wrong.push([`${param.symbol} = (0, 0, 0)`, { [param.key]: [0, 0, 0] }, ray]);
    }
    if (param.type === 'number') {
      wrong.push([`${param.symbol} not a number`, { [param.key]: Number.NaN }, ray]);
    }
  }
  return wrong.map(([family, own, itsRay], i) => ({
    id: `${kind}/invalid/${i + 1}`,
    group: 'invalid',
    family,
    shape: { kind, ...initial, ...own } as unknown as Case['shape'],
    ray: itsRay as Case['ray'],
    expected: null,
  }));
}
