// `npm run others`: the rays of graze-cases on other libraries, and docs/others.md with what each
// makes of them. The libraries are installed in this folder alone, by its own lockfile.
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { built, here, installed, root } from './built.mjs';

const { values } = parseArgs({
  options: {
    count: { type: 'string', default: '1000' },
    seed: { type: 'string', default: '1' },
    out: { type: 'string', default: 'docs/others.md' },
  },
});
const [COUNT, SEED] = [Number(values.count), Number(values.seed)];

installed();
const folder = built();
const door = (name) => import(pathToFileURL(`${folder}/lib/math/${name}.js`).href);
const { intersect } = await door('index');
const { findFamily, seeded } = await door('families');

const SPHERES = ['sphere', 'sphere-far', 'sphere-scale-ray', 'sphere-near-tangent'];
const PLANES = ['plane', 'plane-far', 'plane-grazing'];

const { Mesh: _, ...THREE } = await import('three');
const { MeshBVH } = await import('three-mesh-bvh');
const { Ray: BabylonRay } = await import('@babylonjs/core/Culling/ray.js');
const { Vector3: BabylonVector } = await import('@babylonjs/core/Maths/math.vector.js');
const { Plane: BabylonPlane } = await import('@babylonjs/core/Maths/math.plane.js');
const { default: IntersectionTests } = await import(
  '@cesium/engine/Source/Core/IntersectionTests.js'
);
const { default: CesiumRay } = await import('@cesium/engine/Source/Core/Ray.js');
const { default: Cartesian3 } = await import('@cesium/engine/Source/Core/Cartesian3.js');
const { default: BoundingSphere } = await import('@cesium/engine/Source/Core/BoundingSphere.js');
const { default: CesiumPlane } = await import('@cesium/engine/Source/Core/Plane.js');
const { intersectRayCircle } = await import('@thi.ng/geom-isec/ray-circle');
const { intersectRayPlane } = await import('@thi.ng/geom-isec/ray-plane');

const norm = (v) => Math.hypot(...v);
const unit = (v) => v.map((x) => x / norm(v));
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const away = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const xyz = ({ x, y, z }) => [x, y, z];
const cesium = (v) => Cartesian3.fromArray(v);
const babylon = (v) => new BabylonVector(...v);
const threeRay = ({ origin, direction }) =>
  new THREE.Ray(new THREE.Vector3(...origin), new THREE.Vector3(...direction));
const cesiumRay = ({ origin, direction }) => new CesiumRay(cesium(origin), cesium(direction));

/** A mesh of the sphere, as three.js' examples have it: 64 by 32. */
function meshOf({ center, radius }) {
  const geometry = new THREE.SphereGeometry(radius, 64, 32);
  geometry.translate(...center);
  return new MeshBVH(geometry);
}

/*
 * What a library answers: a t, true where it tells only that it is hit, null for a miss. Each is
 * used as its documentation says: with a direction of length 1, and a normal of length 1.
 */
const LIBRARIES = [
  {
    name: 'three.js',
    version: 'three',
    sphere: {
      call: '`Ray.intersectSphere`',
      promises: 'the first point at t ≥ 0, or null; direction of length 1',
      ask: ({ center, radius }, ray) => {
        const sphere = new THREE.Sphere(new THREE.Vector3(...center), radius);
        const point = threeRay(ray).intersectSphere(sphere, new THREE.Vector3());
        return point && away(xyz(point), ray.origin);
      },
    },
    plane: {
      call: '`Ray.distanceToPlane`',
      promises: 't ≥ 0, or null; 0 where the ray is in the plane',
      ask: ({ normal, point }, ray) =>
        threeRay(ray).distanceToPlane(
          new THREE.Plane().setFromNormalAndCoplanarPoint(
            new THREE.Vector3(...normal),
            new THREE.Vector3(...point),
          ),
        ),
    },
  },
  {
    name: 'three-mesh-bvh',
    version: 'three-mesh-bvh',
    sphere: {
      call: '`MeshBVH.raycastFirst`, a mesh of 64 × 32',
      promises: 'the first hit of the mesh, whose corners are 32-bit numbers: not of the sphere',
      mesh: true,
      ask: (_, ray, bvh) => bvh.raycastFirst(threeRay(ray), THREE.DoubleSide)?.distance ?? null,
    },
  },
  {
    name: 'Babylon.js',
    version: '@babylonjs/core',
    sphere: {
      call: '`Ray.intersectsSphere`',
      promises: 'whether it is hit at t ≥ 0; direction of length 1',
      ask: ({ center, radius }, { origin, direction }) =>
        new BabylonRay(babylon(origin), babylon(direction)).intersectsSphere({
          center: babylon(center),
          radius,
        }) || null,
    },
    plane: {
      call: '`Ray.intersectsPlane`',
      promises: 't ≥ 0, or null; N·d within 9.99e-7 of 0 counts as parallel',
      ask: ({ normal, point }, { origin, direction }) =>
        new BabylonRay(babylon(origin), babylon(direction)).intersectsPlane(
          BabylonPlane.FromPositionAndNormal(babylon(point), babylon(normal)),
        ),
    },
  },
  {
    name: 'Cesium',
    version: '@cesium/engine',
    sphere: {
      call: '`IntersectionTests.raySphere`',
      promises: 'the interval of t ≥ 0 inside, or undefined; of its end where E is inside',
      ask: ({ center, radius }, ray) => {
        const sphere = new BoundingSphere(cesium(center), radius);
        const found = IntersectionTests.raySphere(cesiumRay(ray), sphere);
        if (!found) return null;
        return found.start > 0 ? found.start : found.stop;
      },
    },
    plane: {
      call: '`IntersectionTests.rayPlane`',
      promises: 'the point at t ≥ 0, or undefined; N·d within 1e-15 of 0 counts as parallel',
      ask: ({ normal, point }, ray) => {
        const plane = CesiumPlane.fromPointNormal(cesium(point), cesium(normal));
        const found = IntersectionTests.rayPlane(cesiumRay(ray), plane);
        return found ? away(xyz(found), ray.origin) : null;
      },
    },
  },
  {
    name: '@thi.ng/geom-isec',
    version: '@thi.ng/geom-isec',
    sphere: {
      call: '`intersectRayCircle`, in three dimensions',
      promises: 'both t, those that are ≥ 0; direction of length 1',
      ask: ({ center, radius }, { origin, direction }) =>
        intersectRayCircle(origin, direction, center, radius).alpha ?? null,
    },
    plane: {
      call: '`intersectRayPlane`',
      promises: 't > 0; N·d and distance within 1e-6 of 0 count as 0',
      ask: ({ normal, point }, { origin, direction }) => {
        const w = dot(normal, point);
        const { alpha, type } = intersectRayPlane(origin, direction, normal, w);
        return alpha ?? (type === 1 ? 0 : null);
      },
    },
  },
];

/** The questions of a family: what everybody gets, and the exact answer to just that. */
function questions(id) {
  const family = findFamily(id);
  const random = seeded(SEED);
  const all = [];
  for (let i = 0; i < COUNT; i++) {
    const { shape, ray } = family.make(random);
    const direction = unit(ray.direction);
    const given = shape.normal ? { ...shape, normal: unit(shape.normal) } : shape;
    if (!isUsable([...ray.origin, ...direction, ...Object.values(given).flat()])) continue;
    const asked = { origin: ray.origin, direction };
    const { class: verdict, hits } = intersect(given, asked, 'exact');
    const first = hits.find(({ t }) => t >= 0)?.t ?? null;
    all.push({ given, asked, verdict, first });
  }
  return all;
}

/** Where doubles have room for squares: beyond it, no library promises anything. */
const isUsable = (numbers) =>
  numbers.every((x) => typeof x !== 'number' || (Math.abs(x) < 1e150 && !Number.isNaN(x)));

function judged(kind, { ask, mesh }, asked) {
  const told = { wrong: 0, missed: 0, invented: 0, tangent: 0, off: [], first: null };
  for (const { given, asked: ray, verdict, first } of asked) {
    // Touching is no promise of any of them.
    if (verdict === 'tangent' || verdict === 'contained') {
      told.tangent += 1;
      continue;
    }
    const answer = ask(given, ray, mesh ? meshOf(given) : null);
    const isHit = answer !== null && answer !== undefined && !Number.isNaN(answer);
    if (isHit !== (first !== null)) {
      told.wrong += 1;
      told[isHit ? 'invented' : 'missed'] += 1;
      told.first ??= JSON.stringify({ shape: given, ray, exact: first, hit: isHit });
    } else if (typeof answer === 'number' && first > 0) {
      told.off.push(Math.abs(answer - first) / first);
    }
  }
  const cases = asked.length - told.tangent;
  return { kind, cases, ...told, off: told.off.sort((a, b) => a - b) };
}

const percent = (part, of) => (part === 0 ? '0' : `${((100 * part) / of).toPrecision(2)} %`);
const at = (list, share) => list[Math.min(list.length - 1, Math.floor(share * list.length))];
const size = (x) => (x === undefined ? '–' : x === 0 ? '0' : x.toExponential(1));

function row({ name }, family, { cases, wrong, missed, invented, off }) {
  const errors = off.length > 0 ? [size(at(off, 0.5)), size(at(off, 0.99))] : ['–', '–'];
  const cells = [name, family, cases, percent(wrong, cases), missed, invented, ...errors];
  return `| ${cells.join(' | ')} |`;
}

const versionOf = (name) =>
  JSON.parse(readFileSync(here(`node_modules/${name}/package.json`), 'utf8')).version;

const HEAD = `| library | family | rays | wrong | hits missed | hits invented | t off by: median | 99 % |
| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: |`;

const shortest = [];
function table(kind, families) {
  const lines = families.flatMap((family) => {
    const asked = questions(family);
    const own = {
      name: 'Graze, `first` by certified',
      [kind]: { ask: grazeFirst },
    };
    return [...LIBRARIES, own].flatMap((library) => {
      if (!library[kind]) return [];
      const told = judged(kind, library[kind], asked);
      if (told.first && !library[kind].mesh) shortest.push([library.name, family, told.first]);
      return [row(library, family, told)];
    });
  });
  return [HEAD, ...lines].join('\n');
}

const grazeFirst = (given, ray) => intersect(given, ray).hits.find(({ t }) => t >= 0)?.t ?? null;

const [spheres, planes] = [table('sphere', SPHERES), table('plane', PLANES)];
const seen = new Set();
const examples = shortest.filter(([name]) => !seen.has(name) && seen.add(name));
const promises = LIBRARIES.flatMap(({ name, version, sphere, plane }) =>
  [sphere, plane]
    .filter(Boolean)
    .map(
      ({ call, promises: promised }) =>
        `| ${name} | ${versionOf(version)} | ${call} | ${promised} |`,
    ),
).join('\n');

const date = new Date().toISOString().slice(0, 10);
writeFileSync(
  `${root}/${values.out}`,
  `# The hard cases on other libraries

Written by \`npm run others\` on ${date}; each family ${COUNT} rays from seed ${SEED}. The command
installs the libraries in \`tools\`, apart from Graze's own installation, by a lockfile, and asks each
one about the same rays.

What is asked: is the half line t ≥ 0 hit, and where first? Directions and normals have length 1, as
they all want, as nearly as doubles can; exact arithmetic answers about just those doubles. A plane is
given by N and a point, through each library's own constructor where it has one. A ray that exactly
touches, or lies in the surface, is left out: no library promises anything about it. So are numbers
beyond 1e150. A library that compares with a tolerance does as it says, and is counted all the same:
the table says what a caller gets. "t off by" is relative, of those that are right. These functions
are made for pictures and picking, are short, and cost a fraction of what exact answers do; the
families are made of rays that are hard.

| library | version | function | what it promises |
| --- | --- | --- | --- |
${promises}

## Spheres

${spheres}

three-mesh-bvh answers about a mesh: what it counts as wrong here is how far the mesh is from the sphere.

## Planes

${planes}

## A ray of each that is wrong

With the first t ≥ 0 of exact arithmetic, null for none, and whether the library says that it is hit.

${examples.map(([name, family, text]) => `* ${name}, ${family}: \`${text}\``).join('\n')}
`,
);
