import { ball, material, STONE } from '../scene/presets/define.ts';
import { surfacesOf } from '../scene/surfaces.ts';
import type { Light, Scene, Thing } from '../scene/types.ts';
import { BOXES_FROM } from './find.ts';
import type { TraceSettings } from './types.ts';
import { MOST_BOUNCES } from './weight.ts';

/*
 * How the price of a picture grows: pictures in which one number is varied, and what growth their
 * prices have. The page and the bench trace the same ones.
 */

/** A picture of a series; `x` is the number that is varied, bounces with the camera ray. */
interface GrowthPoint {
  readonly x: number;
  readonly scene: Scene;
  readonly settings: TraceSettings;
}

export interface GrowthSeries {
  readonly id: string;
  readonly title: string;
  /** One of what is counted: 'a bounce'. */
  readonly one: string;
  /** How its pictures differ from the one that is shown, but for their size. */
  readonly how: string;
  readonly points: readonly GrowthPoint[];
}

/** The sides of the pictures of one series, as parts of the whole picture's. */
const SIDES = [1 / 8, 1 / 4, 1 / 2, 3 / 4, 1] as const;
/** The sides of the others, and the least width in px that they have for it. */
const BASE_SIDE = 1 / 4;
const BASE_WIDTH = 96;
const SAMPLES = [1, 4, 9, 16] as const;
/** Sides of the square grid of balls that is added. */
const BALLS = [2, 3, 4, 6, 8, 11] as const;
const BOUNCES = [0, 1, 2, 3, 4, 6, 8, 16, 32, MOST_BOUNCES] as const;
const TIMES_LIGHTS = [1, 2, 3, 4, 6] as const;

/** The series of a picture; one whose number cannot be varied in it is left out. */
export function growthOf(scene: Scene, whole: TraceSettings): readonly GrowthSeries[] {
  const settings = { ...whole, samples: 1 };
  const part = Math.min(1, Math.max(BASE_SIDE, BASE_WIDTH / whole.width));
  const base = sized(settings, part);
  const size = `${base.width} × ${base.height}`;
  const all = [
    pixels(scene, settings),
    {
      id: 'samples',
      title: 'rays a pixel',
      one: 'a ray',
      how: size,
      points: SAMPLES.map((samples) => ({ x: samples, scene, settings: { ...base, samples } })),
    },
    lights(scene, base, size),
    bounces(scene, base, size),
    shapes(scene, base, {
      id: 'shapes',
      title: 'shapes',
      how: `${size}, balls added; boxes from ${BOXES_FROM} bounded shapes on`,
    }),
    shapes(
      scene,
      { ...base, boxless: true },
      {
        id: 'shapes.boxless',
        title: 'shapes, no boxes',
        how: `${size}, balls added; every ray asks every shape`,
      },
    ),
  ];
  return all.filter(({ points }) => points.length > 1);
}

/** What a point's number counts, for readers: bounces without the camera ray. */
export const numberOf = (id: string, x: number): number => (id === 'bounces' ? x - 1 : x);

function sized(settings: TraceSettings, part: number): TraceSettings {
  const side = (n: number): number => Math.max(1, Math.round(n * part));
  return { ...settings, width: side(settings.width), height: side(settings.height) };
}

function pixels(scene: Scene, settings: TraceSettings): GrowthSeries {
  const points = SIDES.map((part) => {
    const own = sized(settings, part);
    return { x: own.width * own.height, scene, settings: own };
  });
  return {
    id: 'pixels',
    title: 'pixels',
    one: 'a pixel',
    how: 'one ray a pixel',
    points: points.filter(({ x }, k) => x > (points[k - 1]?.x ?? 0)),
  };
}

function bounces(scene: Scene, base: TraceSettings, how: string): GrowthSeries {
  const most = base.bounces ?? MOST_BOUNCES;
  const counts = [...BOUNCES.filter((n) => n < most), most];
  return {
    id: 'bounces',
    title: 'bounces',
    one: 'a bounce',
    how,
    points: counts.map((n) => ({ x: n + 1, scene, settings: { ...base, bounces: n } })),
  };
}

/** Its own lights, and copies of them turned about what the camera looks at, as bright in all. */
function lights(scene: Scene, base: TraceSettings, size: string): GrowthSeries {
  const own = scene.lights;
  const points = TIMES_LIGHTS.map((times) => ({
    x: times * own.length,
    scene: {
      ...scene,
      lights: Array.from({ length: times }, (_, k) =>
        own.map((light) => turned(light, scene.camera.target, k, times)),
      ).flat(),
    },
    settings: base,
  }));
  return {
    id: 'lights',
    title: 'lights',
    one: 'a light',
    how: `${size}, copies of its lights around it`,
    points: own.length > 0 ? points : [],
  };
}

/** Of any number of angles no two are near each other. */
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

function turned(
  light: Light,
  [cx, , cz]: Scene['camera']['target'],
  copy: number,
  of: number,
): Light {
  if (of === 1) return light;
  const own = { id: `${light.id} ${copy + 1}`, strength: light.strength / of };
  const [cos, sin] = [Math.cos(copy * GOLDEN_ANGLE), Math.sin(copy * GOLDEN_ANGLE)];
  if (light.light === 'sun') {
    const [x, y, z] = light.towards;
    return { ...light, ...own, towards: [cos * x - sin * z, y, sin * x + cos * z] };
  }
  const [x, y, z] = [light.at[0] - cx, light.at[1], light.at[2] - cz];
  return { ...light, ...own, at: [cx + cos * x - sin * z, y, cz + sin * x + cos * z] };
}

/** Share of the picture's height, at what the camera looks at, that the grid of balls takes. */
const GRID = 0.9;
/** Radius of a ball, as a part of its place in the grid. */
const BALL = 0.35;

/** Balls that together always cover as much: what grows is the search for what a ray meets. */
function shapes(
  scene: Scene,
  base: TraceSettings,
  words: Pick<GrowthSeries, 'id' | 'title' | 'how'>,
): GrowthSeries {
  const own = surfacesOf(scene).length;
  return {
    ...words,
    one: 'a shape',
    points: BALLS.map((side) => ({
      x: own + side * side,
      scene: { ...scene, things: [...scene.things, ...balls(scene, side)] },
      settings: base,
    })),
  };
}

/** A square grid in the upright plane through what the camera looks at, side by side with it. */
function balls({ camera: { eye, target, angle } }: Scene, side: number): Thing[] {
  const [dx, dy, dz] = [0, 1, 2].map((k) => (target[k] ?? 0) - (eye[k] ?? 0)) as [
    number,
    number,
    number,
  ];
  const far = Math.hypot(dx, dy, dz);
  const level = Math.hypot(dx, dz);
  // Across the view: to the right in the horizontal, and upwards.
  const [rx, rz] = level > 0 ? [-dz / level, dx / level] : [1, 0];
  const place = (GRID * 2 * far * Math.tan((angle * Math.PI) / 360)) / side;
  return Array.from({ length: side * side }, (_, k) => {
    const across = ((k % side) - (side - 1) / 2) * place;
    const up = (Math.floor(k / side) - (side - 1) / 2) * place;
    const at = [target[0] + across * rx, target[1] + up, target[2] + across * rz] as const;
    return ball(`added ball ${k + 1}`, at, BALL * place, material(STONE));
  });
}

/** What growth a price has: the criterion is WITHIN. */
type Growth = 'constant' | 'linear' | 'logarithmic' | 'neither';

/**
 * A growth is called linear if a + b·x, and logarithmic if a + b·log x, is nowhere off by more than
 * this part of the price, and constant if no price is by more above the least; of two that fit the
 * simpler one, then the nearer one.
 */
export const WITHIN = 0.05;

/** Fewest points from which a growth is named: two numbers are fitted. */
export const FEWEST = 4;

export interface Slope {
  readonly growth: Growth;
  /** a + b·x or a + b·log x; the nearer one where neither is near enough. */
  readonly a: number;
  readonly b: number;
  /** Its largest distance, as a part of the price. */
  readonly off: number;
  /** Slope of the line through the points with both axes logarithmic. */
  readonly exponent: number;
}

export interface Priced {
  readonly x: number;
  readonly y: number;
  /** Quartiles of a price that was measured: within them it may be called anything. */
  readonly low?: number;
  readonly high?: number;
}

/** Null for fewer than FEWEST points, and where a price is 0. */
export function slopeOf(points: readonly Priced[]): Slope | null {
  if (points.length < FEWEST || points.some(({ x, y }) => !(x > 0 && y > 0))) return null;
  const linear = fitted(points, (x) => x);
  const logarithmic = fitted(points, Math.log);
  const nearer = logarithmic.off < linear.off ? logarithmic : linear;
  const named = nearer === linear ? 'linear' : 'logarithmic';
  const prices = points.map(({ y }) => y);
  const exponent = fitted(
    points.map(({ x, y }) => ({ x, y: Math.log(y) })),
    Math.log,
    () => 1,
  ).b;
  const spread = Math.max(...prices) / Math.min(...prices) - 1;
  if (spread <= WITHIN) {
    const mean = prices.reduce((sum, y) => sum + y, 0) / prices.length;
    return { growth: 'constant', a: mean, b: 0, off: spread, exponent };
  }
  return { growth: nearer.meets ? named : 'neither', ...nearer, exponent };
}

/** Least squares of the distances, as parts of the price. */
function fitted(
  points: readonly Priced[],
  of: (x: number) => number,
  unit: (y: number) => number = (y) => y,
) {
  let [s, sf, sff, sy, sfy] = [0, 0, 0, 0, 0];
  for (const { x, y } of points) {
    const [f, weight] = [of(x), unit(y) ** -2];
    s += weight;
    sf += weight * f;
    sff += weight * f * f;
    sy += weight * y;
    sfy += weight * f * y;
  }
  const b = (s * sfy - sf * sy) / (s * sff - sf * sf);
  const a = (sy - b * sf) / s;
  const distances = points.map(({ x, y }) => Math.abs(a + b * of(x) - y) / y);
  const meets = points.every(({ x, y, low = y, high = y }) => {
    const at = a + b * of(x);
    return Math.abs(at - y) <= WITHIN * y || (at >= low && at <= high);
  });
  return { a, b, off: Math.max(...distances), meets };
}
