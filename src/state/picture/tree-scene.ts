import type { Figure, Patch, Stage } from '../../math/drawing.ts';
import type { Vec3 } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import { nameIn } from '../../scene/names.ts';
import { surfacesOf } from '../../scene/surfaces.ts';
import type { Light, Scene, Thing } from '../../scene/types.ts';
import type { RayKind, RayNode } from '../../tracer/types.ts';

/** A ray of the tree, clipped to the part of the world that the view in space shows. */
export interface TreeLine {
  readonly path: string;
  readonly kind: RayKind;
  readonly from: Vec3;
  readonly to: Vec3;
  readonly weight: number;
  /** What is at its end: a hit, a blocking surface, a light; 'background' if nothing ends it. */
  readonly end: 'hit' | 'blocked' | 'light' | 'background';
  readonly light: string | null;
}

/** A light, where the rays to it end; one that is far is shown nearer in its direction. */
export interface TreeLight {
  readonly id: string;
  readonly name: string;
  readonly at: Vec3;
  /** How much farther it moves than the place where it is shown. */
  readonly per: number;
}

/** The pixel's rays among the scene's shapes, in world coordinates. */
export interface TreeScene {
  readonly stage: Stage;
  /** The shapes that the rays touch, and the others. */
  readonly touched: Figure;
  readonly others: Figure;
  readonly lines: readonly TreeLine[];
  readonly lights: readonly TreeLight[];
  /** Initial azimuth in degrees: to the side of the camera, so that its ray is seen as a line. */
  readonly azimuth: number;
  readonly description: string;
}

const BESIDE_CAMERA = 50;
/** Drawn length, in stage radii, of rays that nothing ends or whose end is farther away. */
const LONG = 1.9;
const OPEN_END = 1.1;

/** `held`: the stage to keep to while something is dragged. */
export function treeScene(scene: Scene, root: RayNode, held: Stage | null = null): TreeScene {
  const surfaces = surfacesOf(scene);
  const nodes = flat(root, '0');
  const things = new Set(
    nodes.flatMap(({ node: { end } }) =>
      'surface' in end ? (surfaces[end.surface]?.thing ?? []) : [],
    ),
  );
  const near = scene.things.filter((_, i) => things.has(i));
  const stage = held ?? stageOf(scene, nodes, near);
  const { eye, target } = scene.camera;
  return {
    stage,
    touched: figureOf(near, stage),
    others: figureOf(
      scene.things.filter((_, i) => !things.has(i)),
      stage,
    ),
    lines: nodes.map(({ node, path }) => lineOf(node, path, stage)),
    lights: scene.lights.map((light) => lightOf(light, scene, nodes, stage)),
    azimuth: (180 / Math.PI) * Math.atan2(eye[0] - target[0], eye[2] - target[2]) + BESIDE_CAMERA,
    description: `${nodes.length} rays of one pixel in space`,
  };
}

interface Named {
  readonly node: RayNode;
  readonly path: string;
}

const flat = (node: RayNode, path: string): Named[] => [
  { node, path },
  ...node.children.flatMap((child, i) => flat(child, `${path}.${i}`)),
];

/**
 * A stage about the hit points. It holds the hit shapes whole if they are no larger than a few
 * times the spread of the points.
 */
function stageOf(scene: Scene, nodes: readonly Named[], near: readonly Thing[]): Stage {
  const hits = nodes.flatMap(({ node: { end, ray } }) =>
    end.end === 'hit' ? [end.point] : end.end === 'blocked' ? [along(ray, end.t)] : [],
  );
  const { eye, target } = scene.camera;
  const far = Math.hypot(...minus(eye, target));
  const points = hits.filter((p) => p.every(Number.isFinite));
  const all = points.length > 0 ? points : [target];
  const sizes = near.map(({ shape, between }) => {
    const { size } = definitionOf(shape).anchor(shape);
    return Math.max(
      Math.min(size, far),
      between ? Math.min((between[1] - between[0]) / 2, far) : 0,
    );
  });
  const low = all[0] as Vec3;
  const box = all.reduce(
    ([least, most], p) => [pick(Math.min, least, p), pick(Math.max, most, p)] as const,
    [low, low] as readonly [Vec3, Vec3],
  );
  const center = pick((a, b) => (a + b) / 2, box[0], box[1]);
  const spread = Math.hypot(...minus(box[1], box[0])) / 2;
  // A shape that is large beside the rays, as a floor or a wall, is not shown whole.
  const size = Math.max(0, ...sizes);
  const wanted = spread > 0 ? Math.min(1.5 * size, 2.4 * spread) : 1.5 * size;
  const radius = Math.max(1.4 * spread, wanted, far / 50) || 1;
  const floor = Math.min(box[0][1], center[1] - radius / 3);
  return { center, radius, ground: floor, low: center[1] - radius, high: center[1] + radius };
}

function lineOf(node: RayNode, path: string, stage: Stage): TreeLine {
  const { kind, ray, weight, end } = node;
  const unit = scaled(ray.direction, 1 / (Math.hypot(...ray.direction) || 1));
  const reach = stage.radius;
  const from = kind === 'camera' ? null : ray.origin;
  const atEnd = end.end === 'hit' ? end.point : end.end === 'background' ? null : along(ray, end.t);
  const start =
    from ?? (atEnd ? plus(atEnd, unit, -LONG * reach) : nearest(ray.origin, unit, stage));
  // A camera ray is drawn from a point near its end; any other may end outside of the stage.
  const isNear =
    atEnd !== null && (from === null || Math.hypot(...minus(atEnd, start)) <= LONG * reach);
  const length = kind === 'camera' ? 2 * LONG * reach : OPEN_END * reach;
  const to = isNear ? atEnd : plus(start, unit, length);
  const light = 'light' in end ? end.light : null;
  const what = isNear || end.end === 'light' ? end.end : 'background';
  return { path, kind, from: start, to, weight, end: what, light };
}

/** From the start of the first ray to it. */
function lightOf(light: Light, scene: Scene, nodes: readonly Named[], stage: Stage): TreeLight {
  const { id } = light;
  const first = nodes.find(({ node: { end } }) => 'light' in end && end.light === id);
  const from = first?.node.ray.origin ?? stage.center;
  const way = light.light === 'sun' ? light.towards : minus(light.at, from);
  const length = Math.hypot(...way) || 1;
  const isNear = light.light !== 'sun' && length <= LONG * stage.radius;
  const per = isNear ? 1 : length / (OPEN_END * stage.radius);
  return { id, name: nameIn(scene, id), at: plus(from, way, 1 / per), per };
}

/** The drawn start of a camera ray without a hit: before its point nearest to the centre. */
function nearest(origin: Vec3, unit: Vec3, { center, radius }: Stage): Vec3 {
  const [x, y, z] = minus(center, origin);
  const t = x * unit[0] + y * unit[1] + z * unit[2];
  return plus(origin, unit, t - LONG * radius);
}

function figureOf(things: readonly Thing[], stage: Stage): Figure {
  const patches = things.flatMap(({ shape, between }) => {
    const own = between ? { ...stage, low: between[0], high: between[1] } : stage;
    const drawn = definitionOf(shape).draw(shape, own).patches;
    return between ? drawn.map(cut) : drawn;
  });
  return { patches, lines: [], marks: [], normals: [] };
}

/** The patch with rims at both ends: a cut shape does not go on. */
const cut = (patch: Patch): Patch => ({
  ...patch,
  start: patch.start === 'goes-on' ? 'rim' : patch.start,
  end: patch.end === 'goes-on' ? 'rim' : patch.end,
});

const along = ({ origin, direction }: RayNode['ray'], t: number): Vec3 =>
  plus(origin, direction, t);
const plus = (a: Vec3, b: Vec3, s: number): Vec3 => [
  a[0] + s * b[0],
  a[1] + s * b[1],
  a[2] + s * b[2],
];
const minus = (a: Vec3, b: Vec3): Vec3 => plus(a, b, -1);
const scaled = (a: Vec3, s: number): Vec3 => [s * a[0], s * a[1], s * a[2]];
const pick = (f: (a: number, b: number) => number, a: Vec3, b: Vec3): Vec3 => [
  f(a[0], b[0]),
  f(a[1], b[1]),
  f(a[2], b[2]),
];
