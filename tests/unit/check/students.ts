import type { Case } from '../../../src/check/program/cases.ts';
import type { Output } from '../../../src/check/program/judge.ts';
import { readValue } from '../../../src/check/program/protocol.ts';
import { intersect } from '../../../src/math/index.ts';

/**
 * Our own programs only: what a student writes runs in the sandbox, in the tests of the browser.
 */
export function run(source: string, cases: readonly Case[]): Output[] {
  const program = new Function(`${source}; return intersect;`)() as (
    s: unknown,
    r: unknown,
  ) => unknown;
  return cases.map(({ shape, ray }): Output => {
    try {
      return readValue(program(shape, ray));
    } catch (error) {
      return { type: 'threw', message: String(error), line: null };
    }
  });
}

export const exactly = (cases: readonly Case[]): Output[] =>
  cases.map(({ shape, ray }): Output => {
    try {
      const { hits } = intersect(shape, ray, 'exact');
      return { type: 'value', t: hits.map(({ t }) => t), normal: hits.map(({ normal }) => normal) };
    } catch (error) {
      return { type: 'threw', message: String(error), line: null };
    }
  });

/*
 * Programs as students write them, in another order than the project's own, and a place for each
 * mistake.
 */

const CURVED = {
  begin: '',
  k: "shape.kind === 'cone' ? shape.slope ** 2 : shape.kind === 'hyperboloid' ? shape.flare : 0",
  rr: 'shape.radius ** 2',
  a: 'dx * dx + dz * dz - k * dy * dy',
  b: '2 * (px * dx + pz * dz - k * py * dy)',
  c: 'px * px + pz * pz - k * py * py - rr',
  normal: '[px + t * dx, -k * (py + t * dy), pz + t * dz]',
  out: '',
  linear: 'if (a === 0) return out(b === 0 ? [] : [-c / b]);',
  disc: 'b * b - 4 * a * c',
  miss: 'if (disc < 0) return out([]);',
  tangent: 'if (disc === 0) return out([-b / (2 * a)]);',
  t1: '(-b - s) / (2 * a)',
  t2: '(-b + s) / (2 * a)',
  pair: '[Math.min(t1, t2), Math.max(t1, t2)]',
};

export function curved(parts: Partial<typeof CURVED>): string {
  const o = { ...CURVED, ...parts };
  return `function intersect(shape, ray) {
    let [ex, ey, ez] = ray.origin, [dx, dy, dz] = ray.direction;
    ${o.begin}
    const k = ${o.k};
    const rr = shape.kind === 'cone' ? 0 : ${o.rr};
    const [cx, cy, cz] = shape.vertex ?? shape.center;
    const px = ex - cx, py = ey - cy, pz = ez - cz;
    const a = ${o.a}, b = ${o.b}, c = ${o.c};
    const normal = (t) => ${o.normal};
    const out = (ts) => { ${o.out}; return { t: ts, normal: ts.map(normal) }; };
    ${o.linear}
    const disc = ${o.disc};
    ${o.miss}
    ${o.tangent}
    const s = Math.sqrt(disc), t1 = ${o.t1}, t2 = ${o.t2};
    return out(${o.pair});
  }`;
}

const FLAT = {
  begin: '',
  parallel: 'if (nd === 0) return { t: [] };',
  t: '(dot(n, p) - dot(n, e)) / nd',
  normal: 'n',
  out: '',
  circle: 'Math.hypot(x[0] - p[0], x[1] - p[1], x[2] - p[2]) > shape.radius',
  square: 'x[i] < p[i] || x[i] > p[i] + shape.side',
};

export function flat(parts: Partial<typeof FLAT>): string {
  const o = { ...FLAT, ...parts };
  return `function intersect(shape, ray) {
    const dot = (u, v) => u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    const e = ray.origin;
    let d = ray.direction;
    ${o.begin}
    const n = shape.normal ?? ['x', 'y', 'z'].map((w) => Number(w === shape.axis));
    const p = shape.point ?? shape.center ?? shape.corner;
    const nd = dot(n, d);
    ${o.parallel}
    const t = ${o.t};
    const x = [0, 1, 2].map((i) => e[i] + t * d[i]);
    if (shape.kind === 'circle' && (${o.circle})) return { t: [] };
    for (const i of [0, 1, 2]) {
      if (shape.kind === 'square' && n[i] === 0 && (${o.square})) return { t: [] };
    }
    let ts = [t];
    ${o.out}
    return { t: ts, normal: ts.map(() => ${o.normal}) };
  }`;
}
