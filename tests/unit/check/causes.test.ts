import { describe, expect, test } from 'vitest';
import { type Course, courseOf, type Rules } from '../../../src/check/course.ts';
import { drawShape } from '../../../src/check/exercises/draw.ts';
import { MISCONCEPTIONS } from '../../../src/check/misconceptions/index.ts';
import { type Case, casesFor } from '../../../src/check/program/cases.ts';
import type { Output } from '../../../src/check/program/judge.ts';
import { reportOf } from '../../../src/check/program/report.ts';
import { programOf } from '../../../src/check/program/source.ts';
import { findings } from '../../../src/check/program/suspects.ts';
import { SHAPES } from '../../../src/math/index.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Shape, ShapeKind } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import { curved, exactly, flat, run } from './students.ts';

/*
 * A cause is named for a program if it explains all of its results, those that are right included.
 */

const SEED = 41;
const KINDS = SHAPES.map(({ kind }) => kind);
const known = new Map<ShapeKind, readonly Case[]>();
const casesOf = (kind: ShapeKind): readonly Case[] => {
  const found = known.get(kind) ?? casesFor([kind], SEED);
  known.set(kind, found);
  return found;
};

/** The causes named, each with the one that cannot be told from it. */
const named = (source: string, kind: ShapeKind): string[][] =>
  findings(casesOf(kind), run(source, casesOf(kind))).map(({ flaw, or }) =>
    or ? [flaw.id, or.id] : [flaw.id],
  );

const QUADRICS: readonly ShapeKind[] = ['cylinder', 'cone', 'hyperboloid'];
const WIDENING: readonly ShapeKind[] = ['cone', 'hyperboloid'];
const WITH_R: readonly ShapeKind[] = ['cylinder', 'hyperboloid'];
/** On the hyperboloid's cases −B² leaves no root at all, and that fits too much to be named. */
const SPREAD: readonly ShapeKind[] = ['cylinder', 'cone'];
const FLATS: readonly ShapeKind[] = ['plane', 'circle', 'square'];

const unit = 'const l = Math.hypot(dx, dy, dz); dx /= l; dy /= l; dz /= l;';
const twice = { tangent: '' };
const inward = { normal: '[-px - t * dx, k * (py + t * dy), -pz - t * dz]' };
const precedence = {
  t1: '(-b - s) / 2 * a',
  t2: '(-b + s) / 2 * a',
  tangent: 'if (disc === 0) return out([-b / 2 * a]);',
};

const MISTAKES: readonly [string, readonly string[], readonly ShapeKind[], string][] = [
  ['−B*B', ['minus-b2'], SPREAD, curved({ disc: '-b * b - 4 * a * c' })],
  ['−B² without D = 0', ['minus-b2'], SPREAD, curved({ disc: '-(b * b) - 4 * a * c', ...twice })],
  ['/2*a', ['half-times-a'], QUADRICS, curved(precedence)],
  ['d made a unit vector', ['distance'], QUADRICS, curved({ begin: unit })],
  [
    '|d| = 1 assumed',
    ['unit-assumed'],
    QUADRICS,
    curved({
      ...{ b: 'px * dx + pz * dz - k * py * dy', disc: 'b * b - c', t1: '-b - s', t2: '-b + s' },
      ...{ linear: '', tangent: 'if (disc === 0) return out([-b]);' },
    }),
  ],
  ['r/2', ['diameter'], WITH_R, curved({ rr: '(shape.radius / 2) ** 2' })],
  ['2r', ['double-radius'], WITH_R, curved({ rr: '4 * shape.radius * shape.radius' })],
  [
    'axis z',
    ['axis-z'],
    QUADRICS,
    curved({
      a: 'dx * dx + dy * dy - k * dz * dz',
      b: '2 * (px * dx + py * dy - k * pz * dz)',
      c: 'px * px + py * py - k * pz * pz - rr',
      normal: '[px + t * dx, py + t * dy, -k * (pz + t * dz)]',
    }),
  ],
  ['inward normals', ['normal-turned'], QUADRICS, curved(inward)],
  [
    'normals that face the ray',
    ['normal-facing'],
    QUADRICS,
    curved({
      normal:
        '((n) => n[0] * dx + n[1] * dy + n[2] * dz > 0 ? n.map((x) => -x) : n)([px + t * ' +
        'dx, -k * (py + t * dy), pz + t * dz])',
    }),
  ],
  [
    'radial normal',
    ['normal-radial'],
    WIDENING,
    curved({ normal: '[px + t * dx, 0, pz + t * dz]' }),
  ],
  ['t > 0', ['front-strict'], QUADRICS, curved({ out: 'ts = ts.filter((t) => t > 0)' })],
  ['t > 1e-4', ['front-strict'], QUADRICS, curved({ out: 'ts = ts.filter((t) => t > 1e-4)' })],
  ['t >= 0', ['front-only'], QUADRICS, curved({ out: 'ts = ts.filter((t) => t >= 0)' })],
  ['nearest only', ['nearest-only'], QUADRICS, curved({ out: 'ts = ts.slice(0, 1)' })],
  [
    'the first visible only',
    ['visible-only'],
    QUADRICS,
    curved({ out: 'ts = ts.filter((t) => t >= 0).slice(0, 1)' }),
  ],
  [
    'second nappe dropped where there are two roots',
    ['one-nappe'],
    ['cone'],
    curved({ pair: '[Math.min(t1, t2), Math.max(t1, t2)].filter((t) => ey + t * dy >= cy)' }),
  ],
  ['unsorted where A < 0', ['unsorted'], WIDENING, curved({ pair: '[t1, t2]' })],
  ['plus first', ['unsorted-plus'], QUADRICS, curved({ pair: '[t2, t1]' })],
  ['D <= 0', ['strict'], QUADRICS, curved({ miss: 'if (disc <= 0) return out([]);' })],
  ['no D = 0', ['tangent-twice'], QUADRICS, curved(twice)],
  ['no A = 0', ['a-zero'], QUADRICS, curved({ linear: '' })],
  ['r', ['r-for-r2'], WITH_R, curved({ rr: 'shape.radius' })],
  [
    'c',
    ['c-for-c2'],
    ['cone'],
    curved({ k: 'shape.slope', normal: '[px + t * dx, -(k ** 2) * (py + t * dy), pz + t * dz]' }),
  ],
  ['+ r²', ['plus-r2'], WITH_R, curved({ c: 'px * px + pz * pz - k * py * py + rr' })],
  ['B² − AC', ['b2-ac'], QUADRICS, curved({ disc: 'b * b - a * c' })],
  [
    '+B',
    ['lost-minus'],
    QUADRICS,
    curved({
      t1: '(b - s) / (2 * a)',
      t2: '(b + s) / (2 * a)',
      tangent: 'if (disc === 0) return out([b / (2 * a)]);',
    }),
  ],
  ['one-sided', ['one-sided'], FLATS, flat({ parallel: 'if (nd >= 0) return { t: [] };' })],
  [
    'one-sided, -eps',
    ['one-sided'],
    FLATS,
    flat({ parallel: 'if (!(nd < -1e-9)) return { t: [] };' }),
  ],
  [
    'other side',
    ['one-sided-back'],
    FLATS,
    flat({ parallel: 'if (nd <= 1e-9) return { t: [] };' }),
  ],
  ['facing normal', ['normal-facing'], FLATS, flat({ normal: 'nd > 0 ? n.map((x) => -x) : n' })],
  ['−N', ['flat-normal-turned'], FLATS, flat({ normal: 'n.map((x) => -x)' })],
  [
    't > 0, flat',
    ['front-strict'],
    ['plane', 'circle'],
    flat({ out: 'ts = ts.filter((t) => t > 0);' }),
  ],
  [
    'unit d, flat',
    ['flat-distance'],
    FLATS,
    flat({ begin: 'd = d.map((x) => x / Math.hypot(...d));' }),
  ],
  ['N·E', ['flat-no-P'], ['plane'], flat({ t: '-dot(n, e) / nd' })],
  ['lost minus', ['flat-lost-minus'], ['plane'], flat({ t: '(dot(n, e) - dot(n, p)) / nd' })],
  [
    'strict rim',
    ['strict-border'],
    ['circle'],
    flat({ circle: 'Math.hypot(x[0] - p[0], x[1] - p[1], x[2] - p[2]) >= shape.radius' }),
  ],
  [
    'strict edge',
    ['strict-border'],
    ['square'],
    flat({ square: '!(x[i] > p[i] && x[i] < p[i] + shape.side)' }),
  ],
  [
    'rim: r/2',
    ['diameter'],
    ['circle'],
    flat({ circle: 'Math.hypot(x[0] - p[0], x[1] - p[1], x[2] - p[2]) > shape.radius / 2' }),
  ],
  [
    'middle',
    ['corner-as-middle'],
    ['square'],
    flat({ square: 'Math.abs(x[i] - p[i]) > shape.side / 2' }),
  ],
  // Two or three at once.
  [
    'unit d, no D = 0',
    ['distance'],
    ['cylinder', 'hyperboloid'],
    curved({ begin: unit, ...twice }),
  ],
  [
    't·|d|, no D = 0',
    ['distance', 'tangent-twice'],
    QUADRICS,
    curved({
      ...twice,
      pair: '[Math.min(t1, t2), Math.max(t1, t2)].map((t) => t * Math.hypot(dx, dy, dz))',
      normal:
        '[px + t / Math.hypot(dx, dy, dz) * dx, -k * (py + t / Math.hypot(dx, dy, dz) * ' +
        'dy), pz + t / Math.hypot(dx, dy, dz) * dz]',
    }),
  ],
  [
    '/2*a with D <= 0',
    ['half-times-a', 'strict'],
    QUADRICS,
    curved({ ...precedence, miss: 'if (disc <= 0) return out([]);' }),
  ],
  [
    'inward normals, no A = 0, no D = 0',
    ['normal-turned', 'a-zero', 'tangent-twice'],
    QUADRICS,
    curved({ ...inward, ...twice, linear: '' }),
  ],
  [
    'r and inward',
    ['r-for-r2', 'normal-turned'],
    WITH_R,
    curved({ rr: 'shape.radius', ...inward }),
  ],
  [
    't > 0 and unit d',
    ['distance', 'front-strict'],
    QUADRICS,
    curved({ begin: unit, out: 'ts = ts.filter((t) => t > 0)' }),
  ],
  [
    'one-sided and −N',
    ['one-sided', 'flat-normal-turned'],
    FLATS,
    flat({ parallel: 'if (nd >= 0) return { t: [] };', normal: 'n.map((x) => -x)' }),
  ],
];

describe.each(MISTAKES)('%s', (_, ids, kinds, source) => {
  test.each(kinds)('on a %s', (kind) => {
    const found = named(source, kind);
    for (const id of ids) expect(found.flat(), JSON.stringify(found)).toContain(id);
    // Nothing else is named than what is there, or what cannot be told from it.
    for (const names of found)
      expect(
        ids.some((id) => names.includes(id)),
        names.join(),
      ).toBe(true);
  });
});

const STABLE = {
  b: 'px * dx + pz * dz - k * py * dy',
  disc: 'b * b - a * c',
  tangent: 'if (disc === 0) return out([-b / a]);',
  t1: '(-b - Math.sign(b || 1) * s) / a',
  t2: 'c / (-b - Math.sign(b || 1) * s)',
};
const RIGHT: readonly [string, readonly ShapeKind[], string][] = [
  ['another order of operations', QUADRICS, curved({})],
  ['half of B', QUADRICS, curved({ ...STABLE, t1: '(-b - s) / a', t2: '(-b + s) / a' })],
  ['the stable formula', QUADRICS, curved(STABLE)],
  [
    'unit normals',
    QUADRICS,
    curved({
      normal:
        '((n) => n.map((x) => x / Math.hypot(...n)))([px + t * dx, -k * (py + t * dy), ' +
        'pz + t * dz])',
    }),
  ],
  ['the minus sign first, where A > 0 always', ['cylinder'], curved({ pair: '[t1, t2]' })],
  ['flat shapes', FLATS, flat({})],
];
describe.each(RIGHT)('%s', (_, kinds, source) => {
  test.each(kinds)('is no mistake on a %s', (kind) => expect(named(source, kind)).toEqual([]));
});

describe('no cause', () => {
  test('for exact answers', () => {
    for (const kind of KINDS) expect(findings(casesOf(kind), exactly(casesOf(kind)))).toEqual([]);
  });

  test('for results that no formula gives', () => {
    const random = seeded(7);
    for (let i = 0; i < 24; i++) {
      const cases = casesOf(KINDS[i % KINDS.length] as ShapeKind);
      const factor = 0.5 + random();
      const share = random();
      const outputs = exactly(cases).map((output): Output => {
        if (output.type !== 'value' || random() > share) return output;
        return { ...output, t: output.t.map((t) => t * factor + random() - 0.5) };
      });
      const found = findings(cases, outputs);
      // A few noisy results among the hard or special ones leave the rest as it was, and nothing is
      // to be said.
      expect(found.map(({ flaw, branch }) => `${flaw.id} ${branch} ${share}`)).toEqual([]);
    }
  });

  test('for a program that mixes two', () => {
    const edit = MISCONCEPTIONS.find(({ id }) => id === 'b2-ac')?.edit;
    const cases = casesOf('cylinder');
    const right = exactly(cases);
    const wrong = run(programOf('cylinder', edit) ?? '', cases);
    expect(findings(cases, wrong)[0]?.flaw.id).toBe('b2-ac');
    const mixed = cases.map((_, i) => (i % 10 < 7 ? wrong : right)[i] as Output);
    expect(findings(cases, mixed)).toEqual([]);
  });

  test('for a special branch while the general one is unexplained', () => {
    const source = curved({ disc: 'b * b - 3 * a * c', miss: 'if (disc <= 0) return out([]);' });
    for (const kind of QUADRICS) expect(named(source, kind)).toEqual([]);
  });
});

const isRoot = (output: Output | undefined): boolean =>
  output?.type === 'value' && output.t.some(Number.isFinite);

/** The same results as without the mistake, for every valid input. */
const isHarmless = (kind: ShapeKind, outputs: readonly Output[]): boolean =>
  changedOf(kind, outputs).length === 0;

/** The valid cases in which the program says something else than the right one. */
function changedOf(kind: ShapeKind, outputs: readonly Output[]): readonly Case[] {
  const cases = casesOf(kind);
  const right = run(programOf(kind) ?? '', cases);
  return cases.filter(
    ({ expected }, i) => expected && JSON.stringify(outputs[i]) !== JSON.stringify(right[i]),
  );
}

const shapeOf = (kind: ShapeKind): Shape => drawShape(seeded(1), kind, 1);
const straightOf = (kind: ShapeKind): string | null => {
  const shape = shapeOf(kind);
  return definitionOf(shape).named(shape).straight;
};
const rulesOf = (kind: ShapeKind, edit: (course: Course) => Course | null): Rules => {
  const course = courseOf(shapeOf(kind));
  return (edit(course) ?? course).rules;
};

describe('what the questions know', () => {
  const RULES_OF_PAGES = [
    ...['behind', 'far-root', 'no-light-bound'],
    ...['parallel-misses', 'parallel-lies-in', 'loss-always-t'],
  ];
  const edits = MISCONCEPTIONS.filter(({ id }) => !RULES_OF_PAGES.includes(id));
  test.each(edits.map((one) => [one.id, one] as const))('%s is found in a program', (id, one) => {
    let tried = 0;
    for (const kind of KINDS) {
      const source = programOf(kind, one.edit);
      if (!source || source === programOf(kind)) continue;
      const cases = casesOf(kind);
      const outputs = run(source, cases);
      const report = reportOf(cases, outputs);
      const found = report.findings.map(({ flaw, or }) => [flaw.id, or?.id]);
      if (isHarmless(kind, outputs)) {
        expect(found, kind).toEqual([]);
        // What is done where A = 0 cannot show on a shape on which A is 0 for no ray.
        expect([kind, rulesOf(kind, one.edit).linear]).not.toEqual([kind, 'handled']);
        expect([kind, straightOf(kind)]).toEqual([kind, null]);
        continue;
      }
      tried++;
      // If no root is left but those that rounding makes, nothing tells one mistake from another.
      const telling = cases.some(({ group }, i) => group !== 'hard' && isRoot(outputs[i]));
      // A mistake that shows in one or two cases only is not named: they are no evidence.
      const shows = changedOf(kind, outputs).filter(({ group }) => group !== 'hard').length >= 3;
      if (!report.silent && telling && shows) expect(found.flat(), kind).toContain(id);
      expect(found.length, JSON.stringify(found)).toBeLessThan(2);
      expect(report.groups.some(({ passed, total }) => passed < total)).toBe(true);
    }
    expect(tried).toBeGreaterThan(0);
  });
});
