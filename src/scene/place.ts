import type { Box, Heights } from '../math/drawing.ts';
import { intersect, type Shape, type Solid, type Vec3 } from '../math/index.ts';
import { type Axis, axisIndex, definitionOf, withComponent } from '../math/shapes.ts';
import { cameraNumbers } from './camera-ray.ts';
import { isPlace, moved } from './edit.ts';
import { boxOf, type Surface, surfacesOf } from './surfaces.ts';
import type { Camera, Scene, Thing } from './types.ts';

/*
 * Where a new thing goes: onto the floor, beside what is there, and where the camera sees it. The
 * floor is any surface that is level and wide enough; boxes and heights come from the registry.
 */

/** Places are tried on a grid of half a size, so many steps to each side of the target. */
const STEPS = 14;
/** A floor is so many times as wide as a thing of the usual size, and as what stands on it. */
const WIDE = 2.5;
/** Least cosine of a floor's normal with the vertical. */
const LEVEL = 0.95;
/** A floor is at most so many sizes above or below the target. */
const FAR = 16;
/** Room between two things, in sizes. */
const GAP = 0.15;
/** Of the picture's height; and its width over its height, for a narrow one. */
const MARGIN = 0.95;
const ASPECT = 1.4;

/**
 * The thing where it stands on the floor beside the others; it may be anywhere before. One without
 * a box is a floor below all else, or where there is one, a wall behind all else.
 */
export function placed(scene: Scene, thing: Thing): Thing {
  const box = boxOf(thing);
  return box ? placedOnFloor(scene, thing, box) : asFloorOrWall(scene, thing);
}

function placedOnFloor(scene: Scene, thing: Thing, box: Box): Thing {
  const size = viewSize(scene);
  const foot = footprintOf(box, size);
  const floors = surfacesOf(scene).filter((surface) => isWide(surface, foot, size));
  const frameFor = frameIn(scene.camera);
  const boxes = scene.things.map((one) => boxOf(one));
  const frames = boxes.map((one) => one && frameFor(one));
  const places = placesAbout(scene, size);
  const { target } = scene.camera;
  let best = { at: target, cost: Number.POSITIVE_INFINITY };
  /** Beside a floor too things stand as high as on it. */
  let level = target[1] - foot.high / 2;
  for (const [far, place] of places.entries()) {
    // Those that follow are farther away.
    if (best.cost <= far) break;
    const floor = floorAt(scene, floors, place, foot, size);
    if (floor) level = floor.height;
    const at: Vec3 = [place[0], level, place[1]];
    const there = boxAt(at, foot);
    const others = scene.things.flatMap((one, i) =>
      i === floor?.thing
        ? []
        : {
            thing: one,
            box: boxes[i] ?? boxWithin(one, heightsOf(there)),
            frame: frames[i] ?? null,
          },
    );
    if (others.some((other) => overlaps(other, there, scene.camera, size))) continue;
    const frame = frameFor(there);
    const hides = ({ frame: other, thing: one }: Other): boolean =>
      isOver(frame, other) || (!other && crosses(one, scene.camera.eye, middleOf(there)));
    const lacks =
      (floor ? 0 : NO_FLOOR) + (isInPicture(frame) ? 0 : UNSEEN) + (others.some(hides) ? HIDES : 0);
    const cost = far + lacks * places.length;
    if (cost < best.cost) best = { at, cost };
  }
  const { at } = best;
  return moved(thing, [at[0] - foot.x, at[1] - foot.low, at[2] - foot.z]);
}

function asFloorOrWall(scene: Scene, thing: Thing): Thing {
  const size = viewSize(scene);
  const { eye, target } = scene.camera;
  const foot: Footprint = { x: 0, z: 0, low: 0, wide: 0, deep: 0, high: 0 };
  const surfaces = surfacesOf(scene);
  const floors = surfaces.filter((surface) => isWide(surface, foot, size));
  const floor = floorAt(scene, floors, [target[0], target[2]], foot, size);
  const boxes = scene.things.flatMap((one, i) => (i === floor?.thing ? [] : (boxOf(one) ?? [])));
  const axis = axisIndex(facingAxis(scene.camera));
  const side = Math.sign(eye[axis] - target[axis]) || 1;
  const short = (x: number): number => shortest(x, size);
  if (floor) {
    const ends = boxes.map(({ low, high }) => (side > 0 ? low[axis] : high[axis]) * side);
    const behind = side * (Math.min(target[axis] * side, ...ends) - size);
    return moved(thing, minus(withComponent(target, axis, short(behind)), anchorOf(thing)));
  }
  const lowest = Math.min(...boxes.map(({ low }) => low[1]));
  const y = short(Number.isFinite(lowest) ? lowest : target[1] - size);
  const upright = turned(thing, [0, 1, 0]);
  return moved(upright, minus(withComponent(target, 1, y), anchorOf(upright)));
}

const anchorOf = ({ shape }: Thing): Vec3 => definitionOf(shape).anchor(shape).at;

/** The axis along which the camera looks most, of those that are level. */
export const facingAxis = ({ eye, target }: Camera): Axis =>
  Math.abs(eye[0] - target[0]) > Math.abs(eye[2] - target[2]) ? 'x' : 'z';

/** The thing with this direction in place of its own. */
function turned(thing: Thing, direction: Vec3): Thing {
  const own = definitionOf(thing.shape).params.filter(
    (param) => param.type === 'vector' && !isPlace(param),
  );
  const values = own.map(({ key }) => [key, direction] as const);
  return { ...thing, shape: { ...thing.shape, ...Object.fromEntries(values) } as Shape };
}

/** Size of new things: a quarter of half the height that the camera sees at its target. */
export function viewSize({ camera: { eye, target, angle } }: Scene): number {
  const distance = Math.hypot(...eye.map((x, i) => x - (target[i] ?? 0)));
  const half = distance * Math.tan((angle * Math.PI) / 360);
  return Number((half / 4).toPrecision(1));
}

/** The box of a thing's part between the heights; null where it has none. */
export function boxWithin({ shape, between }: Thing, heights: Heights): Box | null {
  const [least, most] = between ?? heights;
  const low = Math.max(least, heights[0]);
  return boxOf({ shape, between: [low, Math.max(low, Math.min(most, heights[1]))] });
}

const heightsOf = ({ low, high }: Box): Heights => [low[1], high[1]];

/** What a thing takes up: the middle of its box, its lowest height, and half its extents. */
interface Footprint {
  readonly x: number;
  readonly z: number;
  readonly low: number;
  readonly wide: number;
  readonly deep: number;
  readonly high: number;
}

/** Numbers of a box are a little larger than the thing: each is the shortest one that is near. */
function footprintOf({ low, high }: Box, size: number): Footprint {
  const all = [...low, ...high].map(Math.abs);
  const short = (x: number): number => shortest(x, Math.max(size, ...all));
  return {
    x: short((low[0] + high[0]) / 2),
    z: short((low[2] + high[2]) / 2),
    low: short(low[1]),
    wide: (high[0] - low[0]) / 2,
    deep: (high[2] - low[2]) / 2,
    high: high[1] - low[1],
  };
}

/** The shortest decimal that is as near as boxes are to what they hold. */
function shortest(x: number, size: number): number {
  const near = 2 ** -36 * size;
  if (Math.abs(x) <= near) return 0;
  for (let digits = 1; digits < 17; digits++) {
    const rounded = Number(x.toPrecision(digits));
    if (Math.abs(rounded - x) <= near) return rounded;
  }
  return x;
}

/** Points of a level grid about the target, the nearest first. */
function placesAbout({ camera: { target } }: Scene, size: number): (readonly [number, number])[] {
  const step = size / 2;
  const grid = (x: number): number => Math.round(x / step);
  const short = (n: number): number => Number((n * step).toPrecision(12));
  const [i0, j0] = [grid(target[0]), grid(target[2])];
  const found: { readonly place: readonly [number, number]; readonly far: number }[] = [];
  for (let i = -STEPS; i <= STEPS; i++) {
    for (let j = -STEPS; j <= STEPS; j++) {
      found.push({ place: [short(i0 + i), short(j0 + j)], far: Math.hypot(i, j) });
    }
  }
  return found.sort((a, b) => a.far - b.far).map(({ place }) => place);
}

/** What a place lacks; the sum orders places, among equals the nearest is best. */
const [HIDES, UNSEEN, NO_FLOOR] = [1, 2, 4];

interface Floor {
  readonly height: number;
  /** Index of the thing that it belongs to. */
  readonly thing: number;
}

/** The highest floor below the eye that is under all of a footprint. */
function floorAt(
  { camera: { eye, target } }: Scene,
  floors: readonly Surface[],
  [x, z]: readonly [number, number],
  foot: Footprint,
  size: number,
): Floor | null {
  let best: Floor | null = null;
  for (const surface of floors) {
    const height = heightUnder(surface, x, z, foot);
    if (height === null || height >= eye[1] || Math.abs(height - target[1]) > FAR * size) continue;
    if (!best || height > best.height) best = { height, thing: surface.thing };
  }
  return best;
}

/** Whether a surface could be a floor: wide, or endless. */
function isWide(surface: Surface, { wide, deep }: Footprint, size: number): boolean {
  const box = boxOf(surface);
  const least = WIDE * 2 * Math.max(wide, deep, size);
  return !box || (box.high[0] - box.low[0] >= least && box.high[2] - box.low[2] >= least);
}

/** The largest height of a level surface under a footprint; null where it is not level. */
function heightUnder({ shape, between }: Surface, x: number, z: number, foot: Footprint) {
  const solid = (between ? { ...shape, between } : shape) as Solid;
  const { wide, deep } = foot;
  let most = -Infinity;
  for (const [i, j] of [
    [0, 0],
    [-1, -1],
    [-1, 1],
    [1, -1],
    [1, 1],
  ] as const) {
    const origin: Vec3 = [x + i * wide, 0, z + j * deep];
    // From height 0 upwards: t is the height, without another rounding.
    const { hits } = intersect(solid, { origin, direction: [0, 1, 0] });
    const level = hits.filter(({ normal, fate }) => fate !== 'cut' && isLevel(normal));
    const height = level.at(-1)?.t;
    if (height === undefined) return null;
    most = Math.max(most, height);
  }
  return most;
}

const isLevel = (normal: Vec3): boolean => Math.abs(normal[1]) >= LEVEL * Math.hypot(...normal);

const boxAt = ([x, y, z]: Vec3, { wide, deep, high }: Footprint): Box => ({
  low: [x - wide, y, z - deep],
  high: [x + wide, y + high, z + deep],
});

interface Other {
  readonly thing: Thing;
  readonly box: Box | null;
  readonly frame: Frame | null;
}

/** Whether a box meets a thing, or has less than a gap to it at its sides. */
function overlaps({ thing, box: other }: Other, box: Box, { eye }: Camera, size: number): boolean {
  const [gap, slack] = [GAP * size, 1e-6 * size];
  const grown: Box = {
    low: [box.low[0] - gap, box.low[1] + slack, box.low[2] - gap],
    high: [box.high[0] + gap, box.high[1] - slack, box.high[2] + gap],
  };
  const isCut = (): boolean => edgesOf(grown).some(([from, to]) => crosses(thing, from, to));
  if (!other) return isCut();
  if ([0, 1, 2].some((k) => isApart(grown, other, k as 0))) return false;
  // In a room that the eye is in, too, only its wall is in the way.
  return contains(other, eye) && contains(other, grown.low) ? isCut() : true;
}

/** A rectangle that a box fills in the picture, in halves of the picture's height. */
interface Frame {
  readonly low: readonly [number, number];
  readonly high: readonly [number, number];
}

/** Where a box is seen by the camera; null if it is not all ahead. */
function frameIn(camera: Camera): (box: Box) => Frame | null {
  const { g = [], R = [], U = [] } = cameraNumbers(camera, 1, 1).vectors;
  return (box) => {
    const spots = cornersOf(box).map((corner) => {
      const from = minus(corner, camera.eye);
      const depth = dot(from, g);
      const along = (side: readonly number[]): number => dot(from, side) / dot(side, side) / depth;
      return { depth, x: along(R), y: along(U) };
    });
    if (!spots.every(({ depth }) => depth > 0)) return null;
    const [xs, ys] = [spots.map(({ x }) => x), spots.map(({ y }) => y)];
    return {
      low: [Math.min(...xs), Math.min(...ys)],
      high: [Math.max(...xs), Math.max(...ys)],
    };
  };
}

/** Whether all of it is in a picture of any width that is usual. */
function isInPicture(frame: Frame | null): boolean {
  if (!frame) return false;
  const { low, high } = frame;
  const [x, y] = [Math.max(-low[0], high[0]), Math.max(-low[1], high[1])];
  return y <= MARGIN && x <= ASPECT * MARGIN;
}

const isOver = (a: Frame | null, b: Frame | null): boolean =>
  a !== null &&
  b !== null &&
  [0, 1].every((k) => a.low[k as 0] < b.high[k as 0] && b.low[k as 0] < a.high[k as 0]);

const isApart = (a: Box, b: Box, k: 0 | 1 | 2): boolean =>
  a.low[k] > b.high[k] || b.low[k] > a.high[k];

const contains = ({ low, high }: Box, p: Vec3): boolean =>
  p.every((x, k) => x > (low[k] as number) && x < (high[k] as number));

function cornersOf({ low, high }: Box): Vec3[] {
  return Array.from({ length: 8 }, (_, n): Vec3 => {
    const of = (k: 0 | 1 | 2): number => (((n >> k) & 1) === 0 ? low[k] : high[k]);
    return [of(0), of(1), of(2)];
  });
}

/** The edges of a box, and its diagonals. */
function edgesOf(box: Box): (readonly [Vec3, Vec3])[] {
  const corners = cornersOf(box);
  return corners.flatMap((from, n) =>
    corners.slice(n + 1).flatMap((to, m) => {
      const differing = n ^ (n + 1 + m);
      const isEdge = (differing & (differing - 1)) === 0;
      return isEdge || differing === 7 ? [[from, to] as const] : [];
    }),
  );
}

/** Whether a thing's surface is met between two points. */
function crosses({ shape, between }: Thing, from: Vec3, to: Vec3): boolean {
  const direction = minus(to, from);
  if (direction.every((x) => x === 0)) return false;
  const solid = (between ? { ...shape, between } : shape) as Solid;
  const { hits } = intersect(solid, { origin: from, direction });
  return hits.some(({ t, fate }) => fate !== 'cut' && t > 0 && t < 1);
}

const middleOf = ({ low, high }: Box): Vec3 => [
  (low[0] + high[0]) / 2,
  (low[1] + high[1]) / 2,
  (low[2] + high[2]) / 2,
];

const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a: readonly number[], b: readonly number[]): number =>
  a.reduce((sum, x, k) => sum + x * (b[k] as number), 0);
