import { type Intersection, intersect } from '../../../src/math/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { SHAPES, type Shape } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import type { Example } from '../../../src/state/gallery/define.ts';
import { paramValue, rayOf, shapeOf } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';
import { hitWords } from '../../../src/state/verdict-words.ts';
import { display } from '../../../src/text/format.ts';
import { curvedDetails, flatDetails, planeHit } from '../math/shorthand.ts';
import { at, dot, f, figurePlace, flatOf, less, quadricOf } from './ray-oracle.ts';

/** What a claim is about: a shape, a ray, and what a method finds. */
export interface Subject {
  readonly shape: Shape;
  readonly ray: Ray;
  readonly found: Intersection;
}

type Check = (subject: Subject, ...parts: string[]) => boolean;

export function subjectOf({ link }: Example, method: string): Subject {
  const state = decode(link);
  const [shape, ray] = [shapeOf(state), rayOf(state)];
  return { shape, ray, found: intersect(shape, ray, method) };
}

/** Whether a claim holds of a subject; throws at a claim that no check knows. */
export function holds(claim: string, subject: Subject): boolean {
  const changed = claim.match(/^with (\S+) (\S+): (.+)$/);
  if (changed)
    return holds(changed[3] ?? '', variant(subject, changed[1] ?? '', Number(changed[2])));
  for (const [pattern, check] of CHECKS) {
    const match = claim.match(pattern);
    if (match) return check(subject, ...match.slice(1));
  }
  throw new Error(`no check for the claim ${JSON.stringify(claim)}`);
}

/** The same with one number changed: a parameter by its symbol, or a coordinate of E or d. */
function variant({ shape, ray, found }: Subject, what: string, value: number): Subject {
  const [symbol = '', axis] = what.split('.');
  const moved = (v: Vec3): Vec3 =>
    [0, 1, 2].map((i) => ('xyz'[i] === axis ? value : (v[i] ?? 0))) as unknown as Vec3;
  const next = {
    origin: symbol === 'E' ? moved(ray.origin) : ray.origin,
    direction: symbol === 'd' ? moved(ray.direction) : ray.direction,
  };
  const param = SHAPES.find(({ kind }) => kind === shape.kind)?.params.find(
    (p) => p.symbol === symbol,
  );
  const changed = param && !axis ? ({ ...shape, [param.key]: value } as Shape) : shape;
  return { shape: changed, ray: next, found: intersect(changed, next, found.method) };
}

const compare: Readonly<Record<string, (x: number, y: number) => boolean>> = {
  '=': (x, y) => x === y,
  '≠': (x, y) => x !== y,
  '<': (x, y) => x < y,
  '>': (x, y) => x > y,
};

const t = ({ found }: Subject, n: string): number => found.hits[Number(n) - 1]?.t ?? Number.NaN;
const point = (subject: Subject, n: string): Vec3 =>
  subject.found.hits[Number(n) - 1]?.point ?? [Number.NaN, Number.NaN, Number.NaN];
const normal = ({ found }: Subject, n: string): Vec3 =>
  found.hits[Number(n) - 1]?.normal ?? [Number.NaN, 0, 0];
const quadric = ({ shape }: Subject) =>
  quadricOf(shape) ?? { C: [0, 0, 0] as Vec3, a: Number.NaN, rho: Number.NaN };
const value = (subject: Subject, s: number): number => f(quadric(subject), at(subject.ray, s));
const axisOf = (letter: string): number => 'xyz'.indexOf(letter);
const number = (subject: Subject, symbol: string): number => {
  const param = definitionOf(subject.shape).params.find((p) => p.symbol === symbol);
  return param ? (paramValue(subject.shape, param.key) as number) : Number.NaN;
};
const within = (x: number, size: number, factor: number): boolean =>
  x > size / factor && x < size * factor;
/** Distance of R(s) from the axis. */
const fromAxis = (subject: Subject, s: number): number => {
  const [x, , z] = less(at(subject.ray, s), quadric(subject).C);
  return Math.hypot(x, z);
};
const TS = Array.from({ length: 401 }, (_, i) => (i - 200) / 16);
/** The t at which the line is nearest to the axis. */
const nearest = (subject: Subject): number => {
  const { origin: E, direction: d } = subject.ray;
  const [x, , z] = less(E, quadric(subject).C);
  return -(x * d[0] + z * d[2]) / (d[0] ** 2 + d[2] ** 2);
};
const inFigure = (subject: Subject, s: number): boolean =>
  figurePlace(subject.shape, at(subject.ray, s)).off === 0;
const failing = (subject: Subject): number =>
  planeHit(subject.found).holds.filter((h) => h === false).length;
const signOf = (subject: Subject, letter: string): number | null => {
  const { details } = subject.found;
  if (letter === 'N.d') return flatDetails(subject.found).signs.rate;
  if (letter === 'N.(E-P)') return flatDetails(subject.found).signs.offset;
  return details.family === 'curved' ? details.signs[letter as 'A' | 'B' | 'C' | 'D'] : null;
};
const NEAR = 1e-6;

/** Of the exact answer, or of the textbook's where the claim says so. */
const CHECKS: readonly (readonly [RegExp, Check])[] = [
  [
    /^textbook t1: (\d+) digits right$/,
    (s, n) => {
      const error = Math.abs(t(textbook(s), '1') / t(exact(s), '1') - 1);
      return -Math.log10(error) >= Number(n) && -Math.log10(error) < Number(n) + 1;
    },
  ],
  [
    /^(textbook|exact) shows t1 (\S+)$/,
    (s, method, shown) =>
      display(t({ ...s, found: intersect(s.shape, s.ray, method) }, '1')) === shown,
  ],
  [/^textbook (.*)$/, (s, claim = '') => holds(claim, textbook(s))],
  [/^exact (.*)$/, (s, claim = '') => holds(claim, exact(s))],
  [/^class (\w+)$/, ({ found }, name) => found.class === name],
  [
    /^(A|B|C|D|N\.d|N\.\(E-P\)) ([=≠<>]) 0$/,
    (s, letter = '', relation = '') =>
      compare[relation]?.(signOf(s, letter) ?? Number.NaN, 0) ?? false,
  ],
  [
    /^([ark]) ([=<>]) (\S+)$/,
    (s, symbol = '', relation = '', x = '') =>
      compare[relation]?.(number(s, symbol), Number(x)) ?? false,
  ],
  [/^named (\w+)$/, ({ shape }, name) => definitionOf(shape).named(shape).name === name],
  [/^E (inside|outside)$/, (s, side) => Math.sign(value(s, 0)) === (side === 'inside' ? -1 : 1)],
  [/^E beyond (\S+)$/, ({ ray }, far) => Math.hypot(...ray.origin) > Number(far)],
  [/^E below V$/, (s) => s.ray.origin[1] < quadric(s).C[1]],
  [/^E at the height of the waist$/, (s) => s.ray.origin[1] === quadric(s).C[1]],
  [/^d level$/, ({ ray }) => ray.direction[1] === 0],
  [/^d upwards$/, ({ ray }) => ray.direction[1] > 0],
  [/^d along the axis$/, ({ ray: { direction: d } }) => d[0] === 0 && d[2] === 0],
  [/^d along a generator$/, (s) => along(s) === 0 && quadric(s).a > 0],
  [/^d within (\S+) of a generator$/, (s, by) => along(s) !== 0 && Math.abs(along(s)) < Number(by)],
  [
    /^t(\d) = (\S+)$/,
    (s, n = '', x = '') =>
      t(s, n) === (x === '-C/B' ? -curvedDetails(s.found).C / curvedDetails(s.found).B : Number(x)),
  ],
  [/^t(\d) behind E$/, (s, n = '') => t(s, n) < 0],
  [/^t(\d) ahead$/, (s, n = '') => t(s, n) > 0],
  [/^t2 beyond (\S+)$/, (s, far) => t(s, '2') > Number(far)],
  [
    /^t(\d) (enters|leaves|touches)$/,
    (s, n = '', how) => {
      const signs = [-1, 1].map((side) => Math.sign(value(s, t(s, n) * (1 + side * NEAR))));
      const forward = t(s, n) < 0 ? signs.reverse() : signs;
      const expected = { enters: [1, -1], leaves: [-1, 1], touches: [1, 1] }[how as 'enters'];
      return forward.join() === expected.join() && saidOf(s, n, how ?? '');
    },
  ],
  [/^f straight$/, (s) => isStraight(s) && !isConstant(s)],
  [/^f constant$/, (s) => isConstant(s)],
  [/^f opens downwards$/, (s) => curvedDetails(s.found).A < 0],
  [/^f > 0 everywhere$/, (s) => s.found.class === 'none' && TS.every((x) => value(s, x) > 0)],
  [/^f > 0 elsewhere$/, (s) => TS.every((x) => x === t(s, '1') || value(s, x) > 0)],
  [
    /^f < 0 between$/,
    (s) => [0.01, 0.5, 0.99].every((k) => value(s, t(s, '1') + k * (t(s, '2') - t(s, '1'))) < 0),
  ],
  [
    /^f lowest where nearest to the axis$/,
    (s) => {
      const { A, B } = curvedDetails(s.found);
      return nearest(s) === -B / (2 * A);
    },
  ],
  [
    /^angle to the plane < (\S+)°$/,
    (s, degrees) => {
      const { N } = flatOf(s.shape) ?? { N: [0, 0, 0] };
      const d = s.ray.direction;
      const sine = Math.abs(dot(N as Vec3, d)) / Math.hypot(...N) / Math.hypot(...d);
      return (Math.asin(sine) * 180) / Math.PI < Number(degrees);
    },
  ],
  [
    /^P(\d)\.([xyz]) = P\.\2 \+ L$/,
    (s, n = '', axis = '') =>
      s.shape.kind === 'square' &&
      point(s, n)[axisOf(axis)] === (s.shape.corner[axisOf(axis)] ?? 0) + s.shape.side,
  ],
  [
    /^P(\d)\.([xyz]) = (\S+)$/,
    (s, n = '', axis = '', x = '') => point(s, n)[axisOf(axis)] === Number(x),
  ],
  [
    /^P(\d) (below|above) (?:V|the waist)$/,
    (s, n = '', side) => {
      const h = point(s, n)[1] - quadric(s).C[1];
      return side === 'below' ? h < 0 : h > 0;
    },
  ],
  [/^P1 at V$/, (s) => less(point(s, '1'), quadric(s).C).every((x) => x === 0)],
  [
    /^P(\d) within (\S+) of the waist$/,
    (s, n = '', by) => Math.abs(point(s, n)[1] - quadric(s).C[1]) <= Number(by),
  ],
  [
    /^N1 is zero$/,
    (s) => s.found.hits[0]?.singular === true && normal(s, '1').every((x) => x === 0),
  ],
  [
    /^N1 at a right angle to d$/,
    (s) => dot(normal(s, '1'), s.ray.direction) === 0 && normal(s, '1').some((x) => x !== 0),
  ],
  [
    /^V ahead on the ray$/,
    (s) => {
      const { origin: E, direction: d } = s.ray;
      const k = (quadric(s).C[1] - E[1]) / d[1];
      return k > 0 && less(at(s.ray, k), quadric(s).C).every((x) => x === 0);
    },
  ],
  [
    /^line farther from the axis than the wall$/,
    (s) =>
      fromAxis(s, nearest(s)) >
      Math.sqrt(quadric(s).a) * Math.abs(at(s.ray, nearest(s))[1] - quadric(s).C[1]),
  ],
  [/^axis missed by < (\S+)$/, (s, by) => fromAxis(s, nearest(s)) < Number(by) && nearest(s) > 0],
  [
    /^D below the last digit of B²$/,
    (s) => {
      const { B, D } = curvedDetails(exact(s).found);
      return D < 2 ** (Math.floor(Math.log2(B * B)) - 52);
    },
  ],
  [/^A about (\S+)$/, (s, size) => within(Math.abs(curvedDetails(s.found).A), Number(size), 1.5)],
  [
    /^lengths about (\S+)$/,
    (s, size) =>
      [number(s, 'r'), Math.hypot(...s.ray.origin)].every((x) => within(x, Number(size), 4)),
  ],
  [
    /^roots about (\S+)$/,
    (s, size) => s.found.hits.every((hit) => within(hit.t, Number(size), 4.5)),
  ],
  [/^no root above (\S+)$/, (s, bound) => s.found.hits.every((hit) => hit.t < Number(bound))],
  [
    /^radius r at the waist$/,
    (s) => {
      const { C, rho } = quadric(s);
      return f(quadric(s), [C[0] + Math.sqrt(rho), C[1], C[2]]) === 0;
    },
  ],
  [
    /^distance r from C$/,
    (s) => {
      const { C, rho } = quadric(s);
      const r = Math.sqrt(rho);
      return [
        [r, 0, 0],
        [0, r, 0],
        [0, 0, -r],
        [0.6 * r, 0.8 * r, 0],
      ].every(
        ([x = 0, y = 0, z = 0]) => Math.abs(f(quadric(s), [C[0] + x, C[1] + y, C[2] + z])) < 1e-12,
      );
    },
  ],
  [
    /^ruled$/,
    ({ shape, found }) =>
      [0, 1, 2].every((k) => {
        const [cos = 0, sin = 0] =
          [
            [1, 0],
            [0, 1],
            [0.6, 0.8],
          ][k] ?? [];
        if (shape.kind !== 'hyperboloid') return false;
        const { center: C, flare, radius } = shape;
        const origin: Vec3 = [C[0] + radius * cos, C[1], C[2] + radius * sin];
        const direction: Vec3 = [-sin, 1 / Math.sqrt(flare), cos];
        return [-2, 1, 3].every(
          (x) =>
            Math.abs(
              f(
                quadric({ shape, found, ray: { origin, direction } }),
                at({ origin, direction }, x),
              ),
            ) < 1e-12,
        );
      }),
  ],
  [/^bounded$/, (s) => quadric(s).a < 0],
  [
    /^A > 0 for every d$/,
    (s) =>
      [
        [1, 0, 0],
        [0, 1, 0],
        [0, 0, 1],
        [1, -9, 2],
        [0.01, 5, 0],
      ].every((d) => {
        const [x = 0, y = 0, z = 0] = d;
        return x * x + z * z - quadric(s).a * y * y > 0;
      }),
  ],
  [
    /^P1 inside the figure$/,
    (s) =>
      s.found.class === 'one' &&
      planeHit(s.found).inside === true &&
      figurePlace(s.shape, point(s, '1')).limits === 0,
  ],
  [/^P1 on (\d) limit$/, (s, n) => figurePlace(s.shape, point(s, '1')).limits === Number(n)],
  [/^(\d) conditions?$/, (s, n) => planeHit(s.found).holds.length === Number(n)],
  [/^(\d) conditions fail$/, (s, n) => failing(s) === Number(n)],
  [/^figure missed by (\S+)$/, (s, by) => planeHit(s.found).distance === Number(by)],
  [
    /^1\.25 from a corner$/,
    (s) => {
      if (s.shape.kind !== 'square') return false;
      const { corner: P, side: L } = s.shape;
      const x = planeHit(s.found).point;
      return Math.hypot(x[1] - P[1] - L, x[2] - P[2] - L) === 1.25;
    },
  ],
  [
    /^crosses the figure ahead$/,
    (s) =>
      flatDetails(s.found).meetsFigure === true &&
      TS.filter((x) => x > 0 && inFigure(s, x)).length > 5,
  ],
  [
    /^passes beside the figure$/,
    (s) => flatDetails(s.found).meetsFigure === false && !TS.some((x) => inFigure(s, x)),
  ],
  [/^normal along y$/, ({ shape }) => shape.kind === 'square' && shape.axis === 'y'],
  [
    /^x and z compared$/,
    (s) =>
      JSON.stringify(definitionOf(s.shape).formula(s.shape)).includes('"≤"') &&
      [0, 2].every((i) => failing(variantE(s, i)) === 1),
  ],
];

/** E moved by 9 along one axis: the point leaves the figure there. */
function variantE(s: Subject, i: number): Subject {
  return variant(s, `E.${'xyz'[i]}`, (s.ray.origin[i] ?? 0) + 9);
}

const by =
  (method: string) =>
  (s: Subject): Subject => ({ ...s, found: intersect(s.shape, s.ray, method) });
const textbook = by('textbook');
const exact = by('exact');

/** sin² of the direction against the asymptotic cone's, 0 on a generator. */
function along(s: Subject): number {
  const [x, y, z] = s.ray.direction;
  return x * x + z * z - quadric(s).a * y * y;
}

const isConstant = (s: Subject): boolean => {
  const { details } = s.found;
  return details.family === 'flat' ? details.rate === 0 : details.A === 0 && details.B === 0;
};
const isStraight = ({ found: { details } }: Subject): boolean =>
  details.family === 'flat' || details.A === 0;

/** The page's own word for the same hit. */
function saidOf(s: Subject, n: string, how: string): boolean {
  const words = hitWords(s.found)[Number(n) - 1]?.text ?? '';
  return words === 'behind E' || words.includes(how);
}
