import { Mesh, Plane, Ray as Ray3, Sphere, SphereGeometry, Vector3 } from 'three';
import { MeshBVH } from 'three-mesh-bvh';
import { measure, type Plan, type Task } from '../../src/lab/run.ts';
import { quartiles } from '../../src/lab/stats.ts';
import { batchOf, createAnswers, packRays, verdictsOfRoots } from '../../src/math/batch.ts';
import { exactMethod } from '../../src/math/exact.ts';
import { FAMILIES, type Family, findFamily, madeFamilies } from '../../src/math/families.ts';
import { createHit, intersect, prepare, type Ray, type Shape } from '../../src/math/index.ts';
import { seeded } from '../../src/math/rng.ts';
import { findMethod } from '../../src/math/shapes.ts';
import type { Compared } from './objects.ts';
import { clock, ratioOf } from './prices.ts';

/*
 * The price of textbook beside what is used elsewhere, on the same rays: three.js' own Ray against
 * a sphere and a plane, and three-mesh-bvh against a mesh of the sphere. All say whether the half
 * line t ≥ 0 hits; how often that is wrong is counted by `exact`. three.js wants d of length 1, and
 * has it before the clock runs.
 */

/** Of a sphere, as three.js' examples have it. */
const WIDTH = 64;
const HEIGHT = 32;

export interface Beside extends Compared {
  readonly wrong: number;
  readonly rays: number;
}

interface Rival {
  readonly id: string;
  readonly hits: (i: number) => boolean;
}

interface Batch {
  readonly shape: Shape;
  readonly rays: readonly Ray[];
}

function compare(
  title: string,
  { shape, rays }: Batch,
  rivals: readonly Rival[],
  plan: Plan,
): Beside[] {
  const packed = packRays(rays);
  const out = createAnswers(rays.length);
  const hitsOf = (id: string): boolean[] => {
    batchOf(findMethod(id) ?? exactMethod, shape, 'typescript').first(packed, 0, Infinity, out);
    return verdictsOfRoots(out, rays.length).map((verdict) => verdict !== 'none');
  };
  const truth = hitsOf('exact');
  const byTextbook = hitsOf('textbook');
  const kernel = batchOf(findMethod('textbook') ?? exactMethod, shape, 'typescript');
  let seen = 0;
  const tasks: Task[] = [
    { id: 'base', run: () => kernel.first(packed, 0, Infinity, out) },
    {
      id: 'textbook, one ray at a time',
      run() {
        for (const ray of rays) seen += intersect(shape, ray, 'textbook').hits.length;
      },
    },
    ...rivals.map(({ id, hits }) => ({
      id,
      run() {
        for (let i = 0; i < rays.length; i++) seen += hits(i) ? 1 : 0;
      },
    })),
  ];
  const times = measure(tasks, clock, { ...plan, warmUp: 10 });
  if (Number.isNaN(seen)) throw new Error('unreachable: a count is a number');
  const mistakes = (said: (i: number) => boolean): number =>
    truth.filter((hit, i) => hit !== said(i)).length;
  const line = (id: string, said: (i: number) => boolean): Beside => ({
    what: `${title}: ${id}`,
    ...(ratioOf(times, id, 'base') ?? quartiles([])),
    wrong: mistakes(said),
    rays: rays.length,
  });
  const textbook = (i: number): boolean => byTextbook[i] === true;
  return [
    line('textbook, one ray at a time', textbook),
    ...rivals.map(({ id, hits }) => line(id, hits)),
  ];
}

const inThree = (rays: readonly Ray[]): Ray3[] =>
  rays.map(
    ({ origin, direction }) =>
      new Ray3(new Vector3(...origin), new Vector3(...direction).normalize()),
  );

/** A sphere, and what meets it: three.js, and Graze one ray after the other, prepared. */
function spheres({ shape, rays }: Batch): { readonly sphere: Sphere; readonly rivals: Rival[] } {
  if (shape.kind !== 'sphere') throw new Error('the family is not of spheres');
  const at = new Vector3();
  const sphere = new Sphere(new Vector3(...shape.center), shape.radius);
  const own = inThree(rays);
  const prepared = prepare(shape);
  const room = createHit();
  const rivals = [
    {
      id: 'three.js Ray.intersectSphere',
      hits: (i: number) => own[i]?.intersectSphere(sphere, at) !== null,
    },
    {
      id: 'prepare, first: t, point and normal',
      hits: (i: number) => prepared.first(rays[i] as Ray, room) !== null,
    },
    { id: 'prepare, any', hits: (i: number) => prepared.any(rays[i] as Ray) },
  ];
  return { sphere, rivals };
}

/** What textbook's batch in TypeScript takes is 1. */
export function besideOthers(seed: number, count: number, plan: Plan): Beside[] {
  const random = seeded(seed);
  const at = new Vector3();
  const round = (madeFamilies('sphere', 'ordinary')[0] as Family).batch(random, count);
  const { sphere, rivals } = spheres(round);
  const { center, radius } = sphere;
  const grazing = (findFamily('sphere-near-tangent') as Family).batch(random, count);
  const mesh = new Mesh(new SphereGeometry(radius, WIDTH, HEIGHT).translate(...center.toArray()));
  const tree = new MeshBVH(mesh.geometry);
  const rays = inThree(round.rays);
  const flat = (FAMILIES().find(({ id }) => id === 'plane') as Family).batch(random, count);
  if (flat.shape.kind !== 'plane') throw new Error('the family is not of planes');
  const plane = new Plane().setFromNormalAndCoplanarPoint(
    new Vector3(...flat.shape.normal).normalize(),
    new Vector3(...flat.shape.point),
  );
  const lines = inThree(flat.rays);
  return [
    ...compare(
      'sphere',
      round,
      [
        ...rivals,
        {
          id: `three-mesh-bvh, a mesh of ${WIDTH} × ${HEIGHT}`,
          hits: (i) => tree.raycastFirst(rays[i] as Ray3, 2) !== null,
        },
      ],
      plan,
    ),
    ...compare('sphere, nearly tangent', grazing, spheres(grazing).rivals, plan),
    ...compare(
      'plane',
      flat,
      [
        {
          id: 'three.js Ray.intersectPlane',
          hits: (i) => lines[i]?.intersectPlane(plane, at) !== null,
        },
      ],
      plan,
    ),
  ];
}
