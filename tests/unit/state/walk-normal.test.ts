import { describe, expect, test } from 'vitest';
import { levelOf } from '../../../src/math/formula.ts';
import { type Hit, intersect, type Shape, type Vec3 } from '../../../src/math/index.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';
import { decode } from '../../../src/state/url.ts';
import { hitOfNormal, sceneAt } from '../../../src/state/walk-figures.ts';
import { type NormalFigure, normalFigure } from '../../../src/state/walk-normal.ts';
import { nudgeWords } from '../../../src/state/walk-words.ts';

const derive = createDerive(() => exploreDetails);
const modelOf = (link: string) => derive(decode(`#/explore?${link}`));

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** F by the trees, from a point where it is 0: far from the origin it keeps its digits so. */
function valueFrom(shape: Shape, zero: Vec3, at: Vec3): number {
  const away = at.map((x, i) => x - (zero[i] ?? 0)) as unknown as Vec3;
  const { A, B } = levelOf(shape).along(zero, away);
  return A + B;
}

const CASES = GALLERY.flatMap((entry) => {
  const model = derive(decode(entry.link));
  const about = hitOfNormal(model);
  const figure = about && normalFigure(model.shape, about.hit, model.scene.stage);
  return about && figure ? [[entry.id, model, about.hit, figure] as const] : [];
});

describe.each(CASES)('%s', (_, { shape }, hit, figure) => {
  const { k, levels, lines, nudges } = figure;
  const close = (value: number, to: number): boolean => Math.abs(value - to) <= 1e-6 * k;

  test('F is ±k on the level surfaces', () => {
    const values = levels.map((level) =>
      [0.1, 0.3, 0.5, 0.7, 0.9].flatMap((u) =>
        [0.05, 0.3, 0.5, 0.7, 0.95].flatMap((v) => {
          const point = level.at(u, v);
          return point.every(Number.isFinite) ? [valueFrom(shape, hit.point, point)] : [];
        }),
      ),
    );
    expect(values.flat().length).toBeGreaterThan(0);
    values.forEach((all, i) => {
      expect(all.filter((value) => !close(value, i === 0 ? k : -k))).toEqual([]);
    });
  });

  test('the tangent plane is at a right angle to N, and each nudge leads to F = k', () => {
    const plane = lines.find(({ ink }) => ink === 'normal');
    expect(plane === undefined).toBe(hit.singular);
    for (const corner of plane?.points ?? []) {
      const away = corner.map((x, i) => x - (hit.point[i] ?? 0)) as unknown as Vec3;
      const off = dot(away, hit.normal) / (Math.hypot(...away) * Math.hypot(...hit.normal));
      expect(Math.abs(off)).toBeLessThan(1e-7);
    }
    nudges.forEach((s, i) => {
      if (s === null) return;
      const there = hit.point.map((x, j) => x + (i === j ? s : 0)) as unknown as Vec3;
      expect(close(valueFrom(shape, hit.point, there), k), `${i}`).toBe(true);
      expect(Math.sign(s)).toBe(Math.sign(hit.normal[i] ?? 0));
    });
  });
});

const hitOf = (shape: Shape, origin: Vec3, direction: Vec3): Hit =>
  intersect(shape, { origin, direction }).hits[0] as Hit;
const STAGE = { center: [0, 0, 0], radius: 5, ground: -2, low: -2, high: 3 } as const;

test('by hand: on a sphere only x counts, at a vertex nothing does', () => {
  const sphere = { kind: 'sphere', center: [0, 0, 0], radius: 2 } as const;
  const side = hitOf(sphere, [4, 0, 0], [-1, 0, 0]);
  const figure = normalFigure(sphere, side, STAGE) as NormalFigure;
  expect(figure.k).toBe(1);
  expect(figure.nudges).toEqual([Math.sqrt(5) - 2, null, null].map((s) => s && expect.closeTo(s)));
  expect(nudgeWords(sphere, side, figure)).toBe(
    'Drawn: F = ±1. Nudged from there F is 1 after 0.236 along x; along y and z not at all',
  );
  const cone = { kind: 'cone', vertex: [0, 0, 0], slope: 0.5 } as const;
  const vertex = hitOf(cone, [4, 0, 0], [-1, 0, 0]);
  const there = normalFigure(cone, vertex, STAGE) as NormalFigure;
  expect(there.nudges).toEqual([null, null, null]);
  expect(nudgeWords(cone, vertex, there)).toBe(
    'Nudged by h from there F is h² along x, −0.25h² along y, h² along z: ' +
      'no term in h, so N is zero',
  );
});

test('beside N: that of length 1 in proportion, and −N only where N points along d', () => {
  for (const { id, link } of GALLERY) {
    const model = derive(decode(link));
    const { hits, arrows = [] } = sceneAt(model, 'normal', { unit: true, facing: true });
    const shown = hits.filter(({ normal, drawn }) => normal && drawn);
    const ones = arrows.filter(({ letter }) => letter === 'n');
    expect(ones.length, id).toBe(shown.length);
    for (const { index, length } of ones) {
      const { normal, normalLength } = shown.find((hit) => hit.index === index) ?? {};
      const ratio = (normalLength ?? 0) / (length ?? 1);
      expect(ratio, id).toBeCloseTo(Math.hypot(...(normal ?? [0, 0, 0])), 9);
    }
    const { direction: d } = model.ray;
    const back = shown.filter(({ normal: n }) => {
      return n && dot(n, d) > 1e-9 * Math.hypot(...n) * Math.hypot(...d);
    });
    const turned = arrows.filter(({ letter }) => letter === '−N');
    expect(
      turned.map(({ index }) => index),
      id,
    ).toEqual(back.map(({ index }) => index));
    for (const { direction } of turned) expect(dot(direction, d)).toBeLessThan(0);
    expect(sceneAt(model, 'normal').arrows, id).toEqual([]);
  }
});

test('nothing of it while the results are hidden, and nothing without a hit', () => {
  const hidden = modelOf('shape=cone&hide=1');
  expect(sceneAt(hidden, 'normal', { unit: true, facing: true })).toBe(hidden.scene);
  const missed = sceneAt(modelOf('shape=sphere&E=9,9,9&d=1,0,0'), 'normal');
  expect(missed.levels).toEqual([]);
});

test('a circle: from its centre to where the line meets its plane', () => {
  const model = modelOf('shape=circle&N=0,1,0&C=0,1,0&r=1&E=3,4,0&d=0,-1,0');
  expect(sceneAt(model, 'figure').figures).toEqual([
    {
      points: [
        [0, 1, 0],
        [3, 1, 0],
      ],
      closed: false,
      ink: 'ink3',
    },
  ]);
});
