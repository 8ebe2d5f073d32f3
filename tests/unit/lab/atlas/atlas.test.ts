import { describe, expect, test } from 'vitest';
import { axesOf, numberOn, withNumber } from '../../../../src/lab/atlas/axes.ts';
import { bordersOf, distancesFrom } from '../../../../src/lab/atlas/borders.ts';
import { mapOf, newMapFrame, paint, piecesOf } from '../../../../src/lab/atlas/frame.ts';
import { createMapper, signAt } from '../../../../src/lab/atlas/map.ts';
import { MARKS, markOf, PENDING, VERDICTS } from '../../../../src/lab/atlas/marks.ts';
import { probe, probeFor } from '../../../../src/lab/atlas/probe.ts';
import type { MapRequest } from '../../../../src/lab/atlas/request.ts';
import { summaryOf } from '../../../../src/lab/atlas/summary.ts';
import { casesAsTests, casesFile, casesOf } from '../../../../src/lab/atlas/test-cases.ts';
import {
  atAfterZoom,
  MEASURES,
  MIDDLE,
  PIXELS,
  SIDE,
  scaleOf,
  ZOOMS,
} from '../../../../src/lab/atlas/window.ts';
import { referenceOf } from '../../../../src/lab/reference.ts';
import { judge } from '../../../../src/lab/verdict.ts';
import { sign } from '../../../../src/math/exact.ts';
import { FAMILIES } from '../../../../src/math/families.ts';
import {
  DISCRIMINANT,
  evaluate,
  evaluateTriple,
  exact,
  valuesOf,
  withScalars,
} from '../../../../src/math/formula.ts';
import { type Ray, SHAPES, type Shape, ulpDistance } from '../../../../src/math/index.ts';
import { seeded } from '../../../../src/math/rng.ts';
import { definitionOf, findMethod, nextUp } from '../../../../src/math/shapes.ts';
import { initialShape } from '../../../../src/state/state.ts';
import { somePixels, tour, windowAround } from './tour.ts';

const RAY: Ray = { origin: [5, 0, 1], direction: [-1, 0, 0] };
const CYLINDER: Shape = { kind: 'cylinder', center: [0, 0, 0], radius: 1 };
/** A tangent in whole numbers, seen down to the doubles around it. */
const TORN: MapRequest = {
  ...{ shape: CYLINDER, ray: RAY, unit: false, axes: ['E.z', 'r'], at: [1, 1] },
  ...{ measure: 'ulps', zoom: 13, method: 'textbook' },
};

describe('axes', () => {
  test.each(SHAPES.map(({ kind }) => kind))(
    'every number of a %s is one, and is put in',
    (kind) => {
      const shape = initialShape(kind);
      for (const axis of axesOf(shape)) {
        const moved = withNumber(axis, { shape, ray: RAY }, 0.75);
        if (!moved) throw new Error(`${axis.id} refuses 0.75`);
        expect(numberOn(axis, moved)).toBe(0.75);
        const others = axesOf(shape).filter(({ id }) => id !== axis.id);
        for (const other of others) {
          expect(numberOn(other, moved)).toBe(numberOn(other, { shape, ray: RAY }));
        }
      }
    },
  );

  test('what is not allowed is no ray and no shape', () => {
    const [, radius] = [CYLINDER, axesOf(CYLINDER).find(({ id }) => id === 'r')];
    const x = axesOf(CYLINDER).find(({ id }) => id === 'd.x');
    if (!radius || !x) throw new Error('r and d.x were expected');
    expect(withNumber(radius, { shape: CYLINDER, ray: RAY }, -1)).toBeNull();
    expect(withNumber(radius, { shape: CYLINDER, ray: RAY }, Infinity)).toBeNull();
    expect(withNumber(x, { shape: CYLINDER, ray: RAY }, 0)).toBeNull();
  });
});

describe('windows', () => {
  const places = [1, -3.7, 0, 1e8, 5e-324, 1e300, -1e-200];

  test.each(MEASURES.map(({ id }) => id))(
    'in %s: the middle is the number, others ascend',
    (by) => {
      const [least, most] = ZOOMS[by];
      for (const at of places) {
        for (let zoom = least; zoom <= most; zoom += 1) {
          const scale = scaleOf(by, zoom, at);
          expect(scale.numberAt(MIDDLE)).toBe(at);
          const all = Array.from({ length: SIDE }, (_, i) => scale.numberAt(i));
          const back = all.findIndex((x, i) => i > 0 && x < (all[i - 1] as number));
          expect(back, `${by} ${zoom} ${at}`).toBe(-1);
          expect(scale.pixelOf(at)).toBe(MIDDLE);
        }
      }
    },
  );

  test('at the end a pixel is one double, whatever it was measured in', () => {
    for (const at of places) {
      const pixel = (by: 'ulps' | 'lengths' | 'decades', zoom: number, i: number): number =>
        scaleOf(by, zoom, at).numberAt(i);
      const steps = Array.from({ length: SIDE - 1 }, (_, i) =>
        ulpDistance(pixel('ulps', 13, i), pixel('ulps', 13, i + 1)),
      );
      expect(new Set(steps)).toEqual(new Set([1]));
      expect(pixel('ulps', 12, MIDDLE + 3)).toBe(pixel('ulps', 13, MIDDLE + 30));
    }
    expect(scaleOf('lengths', 20, 1).numberAt(MIDDLE + 1)).toBe(nextUp(1));
    expect(scaleOf('decades', 16, 1).numberAt(MIDDLE + 1)).toBe(nextUp(1));
    expect(scaleOf('lengths', 0, 1).numberAt(0)).toBe(-4);
    expect(scaleOf('decades', 0, 1).numberAt(0)).toBeCloseTo(1e-5, 15);
  });

  test('a number is found again at its pixel', () => {
    for (const by of MEASURES) {
      for (const at of [1, -3.7, 1e8]) {
        const scale = scaleOf(by.id, 5, at);
        for (const i of [0, 17, 128, 255]) expect(scale.pixelOf(scale.numberAt(i))).toBe(i);
      }
    }
  });

  test('zooming about a pixel keeps its number there', () => {
    for (const { id } of MEASURES) {
      for (const at of [1, -3.7, 1e8]) {
        for (const pixel of [0, 77, 255]) {
          const before = scaleOf(id, 4, at);
          const next = atAfterZoom(id, at, [4, 5], pixel);
          const after = scaleOf(id, 5, next);
          const off = Math.abs(after.numberAt(pixel) - before.numberAt(pixel));
          const size = Math.abs(after.numberAt(pixel + 1) - after.numberAt(pixel));
          expect(off, `${id} ${at} ${pixel}`).toBeLessThanOrEqual(size / 1000);
        }
      }
    }
  });
});

describe('marks', () => {
  test('a mark is right where the verdict is judged right, and undecided where that is', () => {
    for (const said of VERDICTS) {
      for (const truth of VERDICTS.filter((one) => one !== 'undecided')) {
        const judged = judge(said, truth);
        const mark = markOf(said, truth);
        expect(mark === 'right').toBe(judged === 'right');
        expect(mark === 'undecided').toBe(judged === 'undecided');
        if (mark === 'misses') expect([judged, said]).toEqual(['misses', 'none']);
        if (mark === 'invents') expect([judged, truth]).toEqual(['invents', 'none']);
      }
    }
  });

  test('each pixel has what the method says of its ray, one by one', () => {
    const pixels = somePixels(12);
    for (const id of ['textbook32', 'textbook', 'interval', 'moment']) {
      const method = findMethod(id);
      for (const request of tour(7, FAMILIES().length, id)) {
        const mapper = createMapper(request);
        const part = mapper.part(pixels);
        pixels.forEach((pixel, i) => {
          const at = mapper.at(pixel % SIDE, Math.floor(pixel / SIDE));
          const mark = MARKS[part.marks[i] as number];
          if (!at) {
            expect(mark).toBe('nothing');
            return;
          }
          const said = method?.intersect(at.shape, at.ray).class;
          const truth = findMethod('certified')?.intersect(at.shape, at.ray).class ?? 'none';
          expect(VERDICTS[part.said[i] as number]).toBe(said);
          expect(VERDICTS[part.truth[i] as number]).toBe(truth);
          expect(mark).toBe(markOf(said ?? 'none', truth));
        });
      }
    }
  });

  test('the torn edge: textbook at a tangency, where moment and exact are whole', () => {
    const torn = mapOf(TORN);
    const { counts, wrong, along, borders } = summaryOf(TORN, torn);
    expect(wrong).toBeGreaterThan(1000);
    expect(counts.invents).toBeGreaterThan(0);
    expect(counts.count).toBeGreaterThan(0);
    expect(along?.title).toBe('D = 0');
    expect(along?.within).toBeLessThan(10);
    expect(borders).toEqual(['D = 0']);
    for (const method of ['moment', 'certified', 'exact']) {
      const request = { ...TORN, method };
      const summary = summaryOf(request, mapOf(request));
      expect([method, summary.wrong, summary.counts.right]).toEqual([method, 0, PIXELS]);
    }
  });

  test.each([
    ['E.q', 'r'],
    ['E.z', 'k'],
    ['r', 'r'],
  ])('axes %s and %s of a cylinder are refused', (x, y) => {
    expect(() => createMapper({ ...TORN, axes: [x, y] })).toThrow(/no number|both axes/);
  });
});

describe('borders', () => {
  /** Exact signs by the trees, of nothing that a map has computed. */
  function signs(shape: Shape, ray: Ray): readonly [leading: number, deciding: number] {
    const formula = definitionOf(shape).formula(shape);
    const values = valuesOf(shape, ray, exact);
    if (formula.family === 'flat') {
      const { found } = referenceOf(shape, ray);
      return [sign(evaluate(formula.rate, exact, values)), found.class === 'one' ? 1 : -1];
    }
    const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], exact, values);
    const D = evaluate(DISCRIMINANT, exact, withScalars(values, { A, B, C }));
    return [sign(A), sign(D)];
  }

  test('lie exactly where the exact sign changes from a pixel to the next', () => {
    const random = seeded(5);
    for (const id of ['exact-tangent', 'linear', 'near-generator', 'plane-grazing', 'circle-rim']) {
      const family = FAMILIES().find((one) => one.id === id);
      if (!family) throw new Error(`no family ${id}`);
      const question = family.make(random);
      const request: MapRequest = {
        ...windowAround(question, random, 'certified'),
        axes: ['E.z', 'd.y'],
        at: [question.ray.origin[2], question.ray.direction[1]],
      };
      const mapper = createMapper(request);
      const frame = mapOf(request);
      const borders = new Map(bordersOf(request.shape, frame).map((one) => [one.title, one]));
      for (const pixel of somePixels(24)) {
        const column = pixel % SIDE;
        const row = Math.floor(pixel / SIDE);
        const here = mapper.at(column, row);
        const there = column < SIDE - 1 ? mapper.at(column + 1, row) : null;
        if (!here || !there) continue;
        const [a, b] = [signs(here.shape, here.ray), signs(there.shape, there.ray)];
        const isFlat = definitionOf(here.shape).formula(here.shape).family === 'flat';
        const has = (title: string): boolean => borders.get(title)?.right.includes(pixel) ?? false;
        expect(has(isFlat ? 'N·d = 0' : 'A = 0'), JSON.stringify(here)).toBe(a[0] !== b[0]);
        if (!isFlat) expect(has('D = 0'), JSON.stringify(here)).toBe(a[1] !== b[1]);
        else if (a[0] * b[0] !== 0) expect(has('rim')).toBe(a[1] !== b[1]);
      }
    }
  });

  test('A and N·d are made of d and the shape alone', () => {
    const random = seeded(9);
    for (const family of FAMILIES()) {
      const { shape, ray } = family.make(random);
      const formula = definitionOf(shape).formula(shape);
      const tree = formula.family === 'curved' ? formula.A : formula.rate;
      const moved = { ...ray, origin: [3, -2, 7] as const };
      expect(signAt(tree, shape, moved)).toBe(signAt(tree, shape, ray));
      expect(signAt(tree, shape, ray)).toBe(
        sign(evaluate(tree, exact, valuesOf(shape, ray, exact))),
      );
    }
  });

  test('distances grow by one from pixel to pixel', () => {
    const [border] = bordersOf(CYLINDER, mapOf(TORN));
    if (!border) throw new Error('a border was expected');
    const steps = distancesFrom(border);
    for (const pixel of border.right) expect(steps[pixel]).toBe(0);
    const jump = steps.findIndex(
      (at, pixel) => pixel % SIDE > 0 && Math.abs(at - (steps[pixel - 1] as number)) > 1,
    );
    expect(jump).toBe(-1);
  });
});

describe('pieces', () => {
  test.each([1, 2, 3, 4])('of %d workers are every pixel once, coarse before fine', (parts) => {
    const seen = new Uint8Array(PIXELS);
    for (let part = 0; part < parts; part++) {
      let last = Number.POSITIVE_INFINITY;
      for (const { block, pixels } of piecesOf(part, parts)) {
        expect(block).toBeLessThanOrEqual(last);
        last = block;
        for (const pixel of pixels) seen[pixel] = (seen[pixel] as number) + 1;
      }
    }
    expect(seen.every((times) => times === 1)).toBe(true);
  });

  test('arrive in any order: the frame is the same', () => {
    const mapper = createMapper(TORN);
    const all = [0, 1].flatMap((part) => [...piecesOf(part, 2)]);
    const frame = newMapFrame();
    for (const { block, pixels } of all.reverse()) paint(frame, mapper.part(pixels), block);
    const straight = mapOf(TORN);
    expect(frame.marks).toEqual(straight.marks);
    expect(frame.lost).toEqual(straight.lost);
    expect(frame.done).toBe(PIXELS);
  });

  test('the coarsest make a whole picture', () => {
    const mapper = createMapper(TORN);
    const frame = newMapFrame();
    for (const { block, pixels } of piecesOf(0, 1)) {
      if (block === 8) paint(frame, mapper.part(pixels), block);
    }
    expect(frame.marks.includes(PENDING)).toBe(false);
    expect(frame.done).toBe(PIXELS / 64);
  });
});

describe('a closer look', () => {
  const looked = (request: MapRequest) => probe(probeFor(request, mapOf(request)));

  test('reads from the traces which line tears', () => {
    const { torn, looked: seen, agreed, asked } = looked(TORN);
    expect(torn).toEqual([{ line: 'D', how: 'wrong', pixels: seen }]);
    expect([agreed, asked]).toEqual([asked, 256]);
    const open = looked({ ...TORN, method: 'interval' });
    expect(open.torn[0]).toMatchObject({ line: 'D', how: 'unknown' });
  });

  test('A tears where a line is nearly parallel to a generator', () => {
    // 3-4-5: on the cone of slope 3/4 this direction is a generator's, exactly.
    const shape: Shape = { kind: 'cone', vertex: [0, 0, 0], slope: 0.1 };
    const ray: Ray = { origin: [1, 2, 3], direction: [0.06, 1, 0.08] };
    const request: MapRequest = {
      ...{ shape, ray, unit: false, axes: ['d.x', 'd.z'], at: [0.06, 0.08] },
      ...{ measure: 'ulps', zoom: 13, method: 'textbook' },
    };
    const summary = summaryOf(request, mapOf(request));
    expect(summary.borders).toContain('A = 0');
    expect(summary.along?.title).toBe('A = 0');
    expect(looked(request).torn[0]).toMatchObject({ line: 'A', how: 'wrong' });
  });

  test('the rim tears of a circle', () => {
    const shape: Shape = { kind: 'circle', normal: [1, 0.5, 0], center: [0, 1, 0], radius: 2 };
    const ray: Ray = { origin: [3, 1, 2], direction: [-1, 0, 0] };
    const request: MapRequest = {
      ...{ shape, ray, unit: false, axes: ['E.z', 'E.y'], at: [2, 1] },
      ...{ measure: 'ulps', zoom: 13, method: 'textbook' },
    };
    expect(looked(request).torn[0]).toMatchObject({ line: 'rim', how: 'wrong' });
    expect(summaryOf(request, mapOf(request)).along?.title).toBe('rim');
  });
});

describe('rays that leave their surface', () => {
  const CONE: Shape = { kind: 'cone', vertex: [0, 3, 0], slope: 0.5 };
  const LEAVING: MapRequest = {
    ...{ shape: CONE, ray: { origin: [3, 1, 1], direction: [-0.8, -0.2, -0.3] }, unit: false },
    ...{ axes: ['E.z', 'E.y'], at: [1, 1], measure: 'lengths', zoom: 0, method: 'textbook' },
  };
  const marks = (start: NonNullable<MapRequest['start']>, more: Partial<MapRequest> = {}) => {
    const request = { ...LEAVING, ...more, start };
    return summaryOf(request, mapOf(request)).counts;
  };

  test('meet it again without the rule, and not with it', () => {
    const none = marks({ rule: 'none' });
    expect(none.invents).toBeGreaterThan(1000);
    const from = marks({ rule: 'from' });
    expect([from.invents, from.misses]).toEqual([0, 0]);
    expect(from.right).toBe(none.right + none.invents + none.misses);
  });

  test('an epsilon is too small for what is far, and too large for what is near', () => {
    expect(marks({ rule: 'epsilon', epsilon: 1e-17 }).invents).toBeGreaterThan(1000);
    // From inside a sphere every ray that leaves meets it again.
    const shape: Shape = { kind: 'sphere', center: [0, 0, 0], radius: 1 };
    const ray: Ray = { origin: [0, 0, 0.5], direction: [1, 0, 0] };
    const inside = { shape, ray, at: [0.5, 0] as const, zoom: 1 };
    expect(marks({ rule: 'epsilon', epsilon: 1e-9 }, inside)).toMatchObject({ misses: 0 });
    expect(marks({ rule: 'epsilon', epsilon: 1.9 }, inside).misses).toBeGreaterThan(1000);
  });
});

describe('rays of a rectangle as test cases', () => {
  const frame = mapOf(TORN);
  const corners = [
    [100, 100],
    [140, 140],
  ] as const;
  const cases = casesOf(TORN, frame, corners);

  test('are its failing rays', () => {
    expect(cases.length).toBeGreaterThan(20);
    for (const { id, shape, ray } of cases) {
      const [column = 0, row = 0] = (id.split('/')[1] ?? '').split('-').map(Number);
      expect(column >= 100 && column <= 140 && row >= 100 && row <= 140).toBe(true);
      const said = findMethod('textbook')?.intersect(shape, ray).class;
      expect(said).not.toBe(findMethod('exact')?.intersect(shape, ray).class);
    }
  });

  test('in the kit’s format, and as tests that hold', () => {
    const file = JSON.parse(casesFile(cases)) as { graze: string; cases: { class: string }[] };
    expect(file.graze).toBe('hard-cases');
    expect(file.cases.map((one) => one.class)).toEqual(
      cases.map(({ shape, ray }) => findMethod('exact')?.intersect(shape, ray).class),
    );
    const text = casesAsTests(cases);
    for (const { id } of cases) expect(text).toContain(`id: '${id}'`);
    expect(text).toContain("kind: 'cylinder'");
  });
});
