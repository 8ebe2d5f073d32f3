import { type Family, madeFamilies, WRITTEN_FAMILIES } from '../../math/families.ts';
import { type Intersection, intersect, type Vec3 } from '../../math/index.ts';
import { pick, type Random, seeded } from '../../math/rng.ts';
import { findShape, type ShapeKind } from '../../math/shapes.ts';
import type { Input } from '../types.ts';

/** What a right program returns: all roots of the whole line, ascending; a double root once. */
interface Expected {
  readonly class: Intersection['class'];
  readonly t: readonly number[];
  readonly normal: readonly Vec3[];
}

export interface Case extends Input {
  /** Depends on shape and seed only, so that files of results can be matched by it. */
  readonly id: string;
  readonly group: GroupId;
  /** Title of the family, or of the kind of invalid input. */
  readonly family: string;
  /** Null for an invalid input, for which a program has to throw or return no t. */
  readonly expected: Expected | null;
}

/** Groups of cases, each with a score of its own; a family says in which one its rays are. */
export const GROUPS = [
  { id: 'ordinary', title: 'ordinary', each: 14 },
  { id: 'special', title: 'special', each: 6 },
  { id: 'hard', title: 'hard', each: 6 },
  { id: 'invalid', title: 'invalid', each: 0 },
] as const;

export type GroupId = (typeof GROUPS)[number]['id'];

/**
 * Cases of a family that was made from a shape's parameters: more, since there are fewer families.
 */
const MADE_EACH = 14;

/** Draws without the wanted shape after which a family counts as one about other shapes. */
const MAX_DRAWS = 60;

/** The exact cases for these shapes, the same for the same seed everywhere. */
export function casesFor(kinds: readonly ShapeKind[], seed: number): readonly Case[] {
  return kinds.flatMap((kind) => [
    ...GROUPS.flatMap((group) =>
      sourcesOf(group.id).flatMap((source) => familyCases(kind, group, source, seed)),
    ),
    ...GROUPS.flatMap(({ id }) =>
      madeFamilies(kind, id).flatMap((family) =>
        familyCases(kind, { id, each: MADE_EACH }, sourceOf(family), seed),
      ),
    ),
    ...invalidCases(kind),
  ]);
}

/** The seed of the cases that everybody gets, so that reports can be compared. */
export const CASES_SEED = 41;

/**
 * The cases of a seed as a program or a file gets them. For another seed than the common one they
 * are shuffled, under ids that tell nothing: a table of known answers gets nowhere.
 */
export function gradedCases(kinds: readonly ShapeKind[], seed: number): readonly Case[] {
  const all = casesFor(kinds, seed);
  if (seed === CASES_SEED) return all;
  const random = seeded(seed ^ 0x3c6ef372);
  return all
    .map((one) => ({ one, key: random() }))
    .sort((a, b) => a.key - b.key)
    .map(({ one }, i) => ({ ...one, id: `case/${i + 1}` }));
}

interface Source {
  readonly id: string;
  readonly title: string;
  draw(random: Random): Input;
}

const sourceOf = ({ id, title, make }: Family): Source => ({
  id,
  title,
  draw: (random) => make(random),
});

/** Families of this group that are not made for one shape, and the borders of others. */
function sourcesOf(group: GroupId): readonly Source[] {
  const borders = WRITTEN_FAMILIES().filter(({ border }) => border !== undefined);
  const exactly = ({ id, title, make, border }: Family): Source => ({
    id: `${id} exactly`,
    title: `${title}, exactly`,
    draw: (random) => make(random, border),
  });
  return [
    ...WRITTEN_FAMILIES()
      .filter(({ hardness }) => hardness === group)
      .map(sourceOf),
    ...(group === 'special' ? borders.map(exactly) : []),
  ];
}

function familyCases(
  kind: ShapeKind,
  { id: group, each }: { readonly id: GroupId; readonly each: number },
  { id: family, title, draw }: Source,
  seed: number,
): Case[] {
  const random = seeded(Math.imul(seed + 1, 0x9e3779b1) ^ hash(`${kind}/${family}`));
  const found: Case[] = [];
  for (let misses = 0; found.length < each && misses < MAX_DRAWS; ) {
    const input = group === 'ordinary' ? stretched(draw(random), random) : draw(random);
    if (!Object.is(input.shape.kind, kind)) {
      misses++;
      continue;
    }
    const { class: verdict, hits } = intersect(input.shape, input.ray, 'exact');
    // A root out of the doubles' range cannot be returned.
    if (hits.some(({ t }) => !Number.isFinite(t))) {
      misses++;
      continue;
    }
    found.push({
      ...input,
      id: `${kind}/${family.replace(' ', '-')}/${found.length + 1}`,
      group,
      family: title,
      expected: {
        class: verdict,
        t: hits.map(({ t }) => t),
        normal: hits.map(({ normal }) => normal),
      },
    });
  }
  return found;
}

/** The input with d times a power of two, which is exact: with |d| = 1, t would be a distance. */
function stretched({ shape, ray }: Input, random: Random): Input {
  const k = pick(random, [0.5, 2, 4]);
  const [x, y, z] = ray.direction;
  return { shape, ray: { origin: ray.origin, direction: [k * x, k * y, k * z] } };
}

/** FNV-1a hash of a family's name, so that its numbers do not depend on other families. */
const hash = (text: string): number =>
  [...text].reduce((h, c) => Math.imul(h ^ (c.codePointAt(0) ?? 0), 0x01000193), 0x811c9dc5);

/** Invalid inputs, each with one wrong number. */
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
