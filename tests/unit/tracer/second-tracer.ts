import { seeded } from '../../../src/math/rng.ts';
import type { Light, Scene, Thing } from '../../../src/scene/types.ts';

/*
 * A second tracer, plain and slow: one ray at a time, by recursion, with formulas of its own, in
 * doubles. It knows of the first one only what a scene is, and which points of a lamp with a size
 * are asked from a hit: those are drawn by chance, from a seed that the path there decides.
 */

type V = readonly [number, number, number];
type Fields = Readonly<Record<string, V & number>>;

const add = (a: V, b: V, k = 1): V => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
const dot = (a: V, b: V): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const norm = (a: V): V => {
  const length = Math.sqrt(dot(a, a));
  return [a[0] / length, a[1] / length, a[2] / length];
};
const cross = (a: V, b: V): V => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const times = (a: V, b: V): V => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];

const decode = (s: number): number => (s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4);
const colours = new Map<string, V>();
const colour = (hex: string): V => {
  const part = (k: number): number => decode(Number.parseInt(hex.slice(k, k + 2), 16) / 255);
  const found = colours.get(hex) ?? [part(1), part(3), part(5)];
  colours.set(hex, found);
  return found;
};
const byte = (x: number): number => {
  const y = Math.min(x, 1);
  return Math.round(255 * (y <= 0.0031308 ? 12.92 * y : 1.055 * y ** (1 / 2.4) - 0.055));
};

/** A round shape, or a part of a plane. */
interface Surface {
  readonly thing: Thing;
  /** Roots in ascending order. */
  roots(E: V, d: V): readonly number[];
  normal(p: V): V;
  readonly flat: boolean;
  /** Heights outside of which it is cut off. */
  readonly between: readonly [number, number];
}

/** x² + z² + ky² + ly = c about a point: every round shape of the course. */
function round(thing: Thing, C: V, k: number, l: number, c: number): Surface {
  return {
    thing,
    flat: false,
    between: thing.between ?? [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY],
    normal: (p) => norm([p[0] - C[0], k * (p[1] - C[1]) + l / 2, p[2] - C[2]]),
    roots(E, d) {
      const p = add(E, C, -1);
      const a = d[0] ** 2 + d[2] ** 2 + k * d[1] ** 2;
      const b = d[0] * p[0] + d[2] * p[2] + k * d[1] * p[1] + (l * d[1]) / 2;
      // The nearest point of the line to the axis keeps the digits of the discriminant.
      const f = p[0] ** 2 + p[2] ** 2 + k * p[1] ** 2 + l * p[1] - c;
      if (a === 0) return b === 0 ? [] : [-f / (2 * b)];
      const m = add(p, d, -b / a);
      const rest = (m[0] ** 2 + m[2] ** 2 + k * m[1] ** 2 + l * m[1] - c) / a;
      if (rest > 0) return [];
      const half = Math.sqrt(-rest);
      return [-b / a - half, -b / a + half];
    },
  };
}

function flat(thing: Thing, N: V, P: V, inside: (p: V) => boolean): Surface {
  const n = norm(N);
  return {
    thing,
    flat: true,
    between: [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY],
    normal: () => n,
    roots(E, d) {
      const t = dot(add(P, E, -1), N) / dot(d, N);
      return Number.isFinite(t) && inside(add(E, d, t)) ? [t] : [];
    },
  };
}

const UNIT: Readonly<Record<string, V>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

function surfacesOf(thing: Thing): Surface[] {
  const s = thing.shape as unknown as Fields & { kind: string; axis: 'x' | 'y' | 'z' };
  const disc = (N: V, C: V, r: number): Surface =>
    flat(thing, N, C, (p) => dot(add(p, C, -1), add(p, C, -1)) <= r * r);
  const V0 = (s.center ?? s.vertex) as V;
  const whole: Readonly<Record<string, () => Surface>> = {
    plane: () => flat(thing, s.normal as V, s.point as V, () => true),
    circle: () => disc(s.normal as V, V0, s.radius as number),
    square: () => {
      const others = (['x', 'y', 'z'] as const).filter((axis) => axis !== s.axis);
      return flat(thing, UNIT[s.axis] as V, s.corner as V, (p) =>
        others.every((axis) => {
          const x = dot(add(p, s.corner as V, -1), UNIT[axis] as V);
          return x >= 0 && x <= (s.side as number);
        }),
      );
    },
    cylinder: () => round(thing, V0, 0, 0, (s.radius as number) ** 2),
    sphere: () => round(thing, V0, 1, 0, (s.radius as number) ** 2),
    cone: () => round(thing, V0, -((s.slope as number) ** 2), 0, 0),
    hyperboloid: () => round(thing, V0, -(s.flare as number), 0, (s.radius as number) ** 2),
    paraboloid: () => round(thing, V0, 0, -(s.width as number), 0),
  };
  const own = whole[s.kind]?.();
  if (!own) throw new Error(`no formula for ${s.kind}`);
  if (!thing.between || !thing.capped) return [own];
  const [low, high] = thing.between;
  const caps = (
    [
      [low, -1],
      [high, 1],
    ] as const
  ).flatMap(([y, up]) => {
    // Where the axis is at this height a line along x meets it at ± the radius.
    const reach = own.roots([V0[0], y, V0[2]], [1, 0, 0]).at(-1) ?? 0;
    return reach > 0 ? [disc([0, up, 0], [V0[0], y, V0[2]], reach)] : [];
  });
  return [own, ...caps];
}

const SETS = 64;

/** Points of a unit disc, one in each of side · side fields of the same area; 64 sets of them. */
function drawDiscs(side: number): readonly (readonly (readonly [number, number])[])[] {
  const random = seeded(2026);
  const field = (k: number): readonly [number, number] => {
    const ring = Math.floor(k / side) % side;
    const r = Math.sqrt((ring + random()) / side);
    const angle = (2 * Math.PI * ((k % side) + random())) / side;
    return [r * Math.cos(angle), r * Math.sin(angle)];
  };
  return Array.from({ length: SETS }, () =>
    Array.from({ length: side * side }, (_, k) => field(k)),
  );
}

/** The last step of MurmurHash3. */
function mixed(bits: number): number {
  const h = Math.imul(bits ^ (bits >>> 16), 0x85ebca6b);
  const g = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return (g ^ (g >>> 16)) >>> 0;
}

/** The seed of a path that goes on: mirrored or bent. */
function after(path: number, how: 'mirrored' | 'bent'): number {
  const next = Math.imul(path ^ (how === 'mirrored' ? 0x51ed270b : 0x2545f491), 0x85ebca6b);
  return next ^ (next >>> 13);
}

/** Two directions across a unit vector (Duff et al. 2017). */
function across(n: V): readonly [V, V] {
  const [x, y, z] = n;
  const s = z < 0 ? -1 : 1;
  const a = -1 / (s + z);
  return [
    [1 + s * x * x * a, s * x * y * a, -s * x],
    [x * y * a, s + y * y * a, -y],
  ];
}

/**
 * The picture's bytes, three a pixel, one ray through the middle of each; `side` · `side` rays to a
 * lamp with a size.
 */
export function secondPicture(scene: Scene, width: number, height: number, side: number): number[] {
  const discs = drawDiscs(side);
  const surfaces = scene.things.flatMap(surfacesOf);
  const lights = scene.lights.map((light) => {
    const [r, g, b] = colour(light.colour);
    const strength: V = [r * light.strength, g * light.strength, b * light.strength];
    return { strength, light };
  });
  const shiniest = Math.max(0, ...scene.things.map(({ material }) => material.shine.strength));
  const all = lights.reduce((sum, { strength }) => sum + Math.max(...strength), 0);
  const brightest = Math.max(1, scene.ambient + (1 + shiniest) * all);
  // A ray that brings less than half a level where sRGB is steepest is not worth firing.
  const worth = (w: V, depth: number): boolean =>
    depth < 64 && Math.max(...w) > 0.5 / 255 / 12.92 / brightest;
  const [low, high] = [colour(scene.background.low), colour(scene.background.high)];

  /** The roots ahead; `from` is the surface that the ray starts on. */
  function allAhead(surface: Surface, E: V, d: V, from: Surface | null): readonly number[] {
    const roots = surface.roots(E, d);
    if (roots.length === 0) return roots;
    const [bottom, top] = surface.between;
    const start = Math.min(...roots.map(Math.abs));
    const skipped = surface === from ? roots.findLastIndex((t) => Math.abs(t) === start) : -1;
    return roots.filter((t, k) => {
      const y = E[1] + t * d[1];
      return k !== skipped && t > 0 && y >= bottom && y <= top;
    });
  }

  const ahead = (surface: Surface, E: V, d: V, from: Surface | null): number =>
    allAhead(surface, E, d, from)[0] ?? Number.POSITIVE_INFINITY;

  const paintAt = ({ thing, flat: isFlat, normal }: Surface, p: V): V => {
    const { paint } = thing.material;
    if (paint.pattern === 'plain') return colour(paint.colour);
    const n = normal(p).map(Math.abs);
    const skipped = isFlat ? n.indexOf(Math.max(...n)) : -1;
    const axes = paint.pattern === 'stripes' ? ['xyz'.indexOf(paint.axis)] : [0, 1, 2];
    const cubes = axes
      .filter((k) => paint.pattern === 'stripes' || k !== skipped)
      .map((k) => Math.floor((p[k] as number) / paint.size));
    const odd = cubes.reduce((sum, k) => sum + k, 0) % 2 !== 0;
    return colour(odd ? paint.other : paint.colour);
  };

  const coloured = surfaces.filter(({ thing }) =>
    (thing.material.glass?.absorption ?? []).some((sigma) => sigma > 0),
  );
  const dims = scene.effects?.['coloured-shadow']?.light === 'dimmed';

  const isBlocked = (from: Surface, p: V, L: V, far: number): boolean =>
    surfaces.some((other) => !other.thing.material.glass && ahead(other, p, L, from) < far);

  /** What the glass on the straight way leaves of each colour. */
  function leftBy(from: Surface, p: V, L: V, far: number): V {
    const crossings = coloured.flatMap((surface) =>
      allAhead(surface, p, L, from)
        .filter((t) => t < far)
        .map((t) => ({ t, surface })),
    );
    crossings.sort((a, b) => a.t - b.t);
    let left: V = [1, 1, 1];
    let before = 0;
    for (const { t, surface } of crossings) {
      const sigma = surface.thing.material.glass?.absorption as V;
      // Around glass is air: only where the ray leaves a thing was it in its glass.
      if (dot(surface.normal(add(p, L, t)), L) > 0) {
        const chord = t - before;
        left = times(left, sigma.map((x) => Math.exp(-x * chord)) as never as V);
      }
      before = t;
    }
    return left;
  }

  /** The share of the lamp's disc that is seen from p. */
  function seenOf(at: number, size: number, from: Surface, p: V, N: V, way: V, path: number) {
    const [u, v] = across(norm(way));
    const chance = mixed(Math.imul(path ^ 0x9e3779b9, at + 1));
    const turn = (2 * Math.PI * (chance >>> 6)) / 2 ** 26;
    const [c, s] = [size * Math.cos(turn), size * Math.sin(turn)];
    const points = discs[chance % SETS] ?? [];
    const free = points.filter(([x, y]) => {
      const to = add(add(way, u, c * x - s * y), v, s * x + c * y);
      const distance = Math.sqrt(dot(to, to));
      return dot(to, N) > 0 && !isBlocked(from, p, norm(to), distance);
    });
    return free.length / points.length;
  }

  /** The share of a light that arrives at p, but for what coloured glass takes. */
  function reach(light: Light, at: number, from: Surface, p: V, N: V, way: V, path: number) {
    const far = light.light === 'sun' ? Number.POSITIVE_INFINITY : Math.sqrt(dot(way, way));
    const full = Number(light.effects?.['fall-off']?.full ?? 0);
    const near = full > 0 && light.light !== 'sun' ? Math.min(1, full / far) ** 2 : 1;
    if (light.light === 'sphere') return near * seenOf(at, light.radius, from, p, N, way, path);
    return isBlocked(from, p, norm(way), far) ? 0 : near;
  }

  function lit(surface: Surface, p: V, N: V, d: V, path: number): readonly [matt: V, gloss: V] {
    let matt: V = [scene.ambient, scene.ambient, scene.ambient];
    let gloss: V = [0, 0, 0];
    const { shine, mirror } = surface.thing.material;
    for (const [at, { strength, light }] of lights.entries()) {
      const way = light.light === 'sun' ? light.towards : add(light.at, p, -1);
      const far = light.light === 'sun' ? Number.POSITIVE_INFINITY : Math.sqrt(dot(way, way));
      const L = norm(way);
      const cosine = dot(L, N);
      if (!(cosine > 0)) continue;
      const share = reach(light, at, surface, p, N, way, path);
      if (share === 0) continue;
      const arrives = dims ? times(strength, leftBy(surface, p, L, far)) : strength;
      matt = add(matt, arrives, share * cosine);
      const back = -dot(add(times(N, [2 * cosine, 2 * cosine, 2 * cosine]), L, -1), d);
      if (!(back > 0)) continue;
      const spot = shine.strength * (1 - mirror) * Math.min(back, 1) ** shine.exponent;
      gloss = add(gloss, arrives, share * spot);
    }
    return [matt, gloss];
  }

  /** A ray from `from`, in the glass of `inside`; its weight, its bounces so far, and its path. */
  function seen(
    E: V,
    d: V,
    from: Surface | null,
    inside: Surface | null,
    w: V,
    depth: number,
    path: number,
  ): V {
    let hit: Surface | null = null;
    let t = Number.POSITIVE_INFINITY;
    for (const surface of surfaces) {
      const found = ahead(surface, E, d, from);
      if (found < t) [hit, t] = [surface, found];
    }
    let weight = w;
    if (inside?.thing.material.glass) {
      const fade = inside.thing.material.glass.absorption.map((s) =>
        Math.exp(-s * Math.min(t, Number.MAX_VALUE)),
      );
      weight = times(w, fade as never as V);
    }
    if (!hit) {
      const up = Math.min(1, Math.max(0, (d[1] + 1) / 2));
      return times(weight, add(low, add(high, low, -1), up));
    }
    const p = add(E, d, t);
    const outer = hit.normal(p);
    const leaves = dot(outer, d) > 0;
    const N: V = leaves ? [-outer[0], -outer[1], -outer[2]] : outer;
    const { mirror, shine, glass } = hit.thing.material;
    const [matt, gloss] = lit(hit, p, N, d, path);
    const share = glass ? 0 : 1 - mirror;
    const paint = times(paintAt(hit, p), matt);
    let sum = times(weight, add(gloss, paint, share));
    const go = (
      way: V,
      part: number,
      medium: Surface | null,
      how: 'mirrored' | 'bent',
      colours: V = [1, 1, 1],
    ): void => {
      const next = times([weight[0] * part, weight[1] * part, weight[2] * part], colours);
      if (!worth(next, depth)) return;
      sum = add(sum, seen(p, way, hit, medium, next, depth + 1, after(path, how)));
    };
    const cosine = -dot(d, N);
    const mirrored = add(d, N, 2 * cosine);
    if (mirror > 0) go(mirrored, mirror, inside, 'mirrored');
    if (!glass) return sum;
    const through = (1 - mirror) * (1 - shine.strength);
    const spread = Number(hit.thing.material.effects?.dispersion?.spread ?? 0);
    // Each colour by its own index; with one index all of them together.
    const ways: readonly (readonly [number, V])[] =
      spread > 0
        ? [
            [Math.max(1, glass.index - spread / 2), [1, 0, 0]],
            [glass.index, [0, 1, 0]],
            [glass.index + spread / 2, [0, 0, 1]],
          ]
        : [[glass.index, [1, 1, 1]]];
    for (const [index, colours] of ways) {
      const eta = leaves ? index : 1 / index;
      const root = 1 - eta ** 2 * (1 - cosine ** 2);
      const other = Math.sqrt(Math.max(0, root));
      const rs = (eta * cosine - other) / (eta * cosine + other);
      const rp = (cosine - eta * other) / (cosine + eta * other);
      const back = root < 0 ? 1 : Math.min(1, (rs * rs + rp * rp) / 2);
      if (back > 0) go(mirrored, through * back, inside, 'mirrored', colours);
      const bent = add([eta * d[0], eta * d[1], eta * d[2]], N, eta * cosine - other);
      if (back < 1) go(bent, through * (1 - back), leaves ? null : hit, 'bent', colours);
    }
    return sum;
  }

  const { eye, target, angle } = scene.camera;
  const forward = norm(add(target, eye, -1));
  const right = norm(cross(forward, [0, 1, 0]));
  const up = cross(right, forward);
  const half = Math.tan((angle * Math.PI) / 360);
  const bytes: number[] = [];
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const u = ((2 * (x + 0.5)) / width - 1) * half * (width / height);
      const v = (1 - (2 * (y + 0.5)) / height) * half;
      const d = norm(add(add(forward, right, u), up, v));
      const path = Math.imul(y * width + x + 1, 0x9e3779b1);
      bytes.push(...seen(eye, d, null, null, [1, 1, 1], 0, path).map(byte));
    }
  }
  return bytes;
}
