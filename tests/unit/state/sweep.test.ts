import { describe, expect, test } from 'vitest';
import { intersect, SHAPES } from '../../../src/math/index.ts';
import { AXES, definitionOf, nextDown, nextUp } from '../../../src/math/shapes.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { type AppState, INITIAL, RAY_PARAMS, rayOf, shapeOf } from '../../../src/state/state.ts';
import {
  playedAt,
  stepOfNumber,
  sweepOf,
  toNumber,
  valueAt,
  withNumber,
} from '../../../src/state/sweep.ts';
import { graphTrail, sceneTrail, sweepFrame } from '../../../src/state/sweep-frame.ts';
import { update } from '../../../src/state/update.ts';
import { decode } from '../../../src/state/url.ts';

const stateOf = (link: string): AppState => decode(`#/explore?${link}`);

/** Every number that has a slider, of every shape on an empty visit. */
const NUMBERS = SHAPES.flatMap(({ kind }) => {
  const state = { ...INITIAL, kind };
  const params = [RAY_PARAMS.E, RAY_PARAMS.d, ...definitionOf(shapeOf(state)).params];
  const labels = params.flatMap(({ symbol, type }) =>
    type === 'vector' ? AXES.map((axis) => `${symbol}.${axis}`) : type === 'number' ? [symbol] : [],
  );
  return labels.map((label) => [kind, label, state] as const);
});

/** What a sweep is cut at: the class, and the sign of A or N·d. */
function caseAt(state: AppState, label: string, value: number): string {
  const there = withNumber(state, label, value);
  if (!there) return 'refused';
  const { class: verdict, details } = intersect(shapeOf(there), rayOf(there));
  return `${verdict} ${details.family === 'flat' ? details.signs.rate : details.signs.A}`;
}

describe.each(NUMBERS)('%s: %s', (_, label, state) => {
  const sweep = sweepOf(state, label);

  test('has a way that leads through where it is', () => {
    expect(sweep).not.toBeNull();
    if (!sweep) return;
    expect(sweep.low).toBeLessThanOrEqual(sweep.home);
    expect(sweep.high).toBeGreaterThanOrEqual(sweep.home);
    expect(sweep.low).toBeLessThan(sweep.high);
    expect(caseAt(state, label, sweep.home)).toBe(
      sweep.samples.find(({ value }) => value === sweep.home)?.key,
    );
  });

  test('changes its case at each boundary, to the last bit, and nowhere between two', () => {
    if (!sweep) return;
    for (const { value } of sweep.boundaries) {
      const cases = [nextDown(value), value, nextUp(value)].map((x) => caseAt(state, label, x));
      expect(new Set(cases).size, `${value}`).toBeGreaterThan(1);
    }
    const ends = [sweep.low, ...sweep.boundaries.map(({ value }) => value), sweep.high];
    for (const [i, to] of ends.slice(1).entries()) {
      const from = ends[i] ?? to;
      const within = [0.25, 0.5, 0.75].map((share) => from + share * (to - from));
      const cases = within.map((value) => caseAt(state, label, value));
      if (to > from) expect(new Set(cases).size, `${from} … ${to}`).toBe(1);
    }
  });

  test('begins and ends where it is, and shows every boundary exactly', () => {
    if (!sweep) return;
    const played: number[] = [];
    const step = stepOfNumber(state, label);
    for (let time = 0; ; time += 100) {
      const value = valueAt(sweep, time);
      if (value === null) break;
      played.push(playedAt(sweep, value, step));
    }
    expect(played[0]).toBe(sweep.home);
    expect(played.at(-1)).toBeCloseTo(sweep.home, 0);
    expect(Math.min(...played)).toBeGreaterThanOrEqual(sweep.low);
    expect(Math.max(...played)).toBeLessThanOrEqual(sweep.high);
    for (const { value } of sweep.boundaries) expect(played).toContain(value);
  });

  test('stopped, the number is what was shown', () => {
    if (!sweep) return;
    const action = toNumber(state, label, sweep.high);
    const stopped = action && update(state, action);
    expect(stopped).toEqual(withNumber(state, label, sweep.high));
  });

  test('its trail are hits, drawn in the part of the world that is held', () => {
    if (!sweep) return;
    const { stage, window } = sweepFrame(state, sweep);
    const own = createDerive(() => exploreDetails)(state);
    expect(stage.radius).toBeGreaterThanOrEqual(own.scene.stage.radius);
    expect(window.from).toBeLessThanOrEqual(own.graph.from);
    expect(window.high).toBeGreaterThanOrEqual(own.graph.high);
    const all = new Set(sweep.samples.flatMap(({ hits }) => hits.map(({ point }) => `${point}`)));
    for (const { points } of sceneTrail(sweep, [sweep.low, sweep.high], stage)) {
      expect(points.length).toBeGreaterThan(1);
      expect(points.every((point) => all.has(`${point}`))).toBe(true);
    }
    const { roots } = graphTrail(sweep, [sweep.low, sweep.home], sweep.home);
    expect(roots.every(({ above }) => above <= 0)).toBe(true);
  });
});

test.each([-2, -1.7, 0])(
  'rests at a boundary at %d, be it within its way or at an end',
  (value) => {
    const boundaries = [{ value, what: 'A = 0', isExact: true }];
    const played = Array.from({ length: 60 }, (_, i) =>
      valueAt({ home: -1, low: -2, high: 0, boundaries }, 100 * i),
    );
    expect(played.filter((one) => one === value).length).toBeGreaterThan(3);
  },
);

test('r goes through tangency, and both ways of the hits meet there', () => {
  const state = stateOf('shape=cylinder&C=0,1,0&r=1.5&E=4,1,1&d=-1,0,0');
  const sweep = sweepOf(state, 'r');
  expect(sweep?.boundaries).toEqual([{ value: 1, what: 'D = 0', isExact: true }]);
  expect(sweep?.text).toBe('r from 0.8 to 1.5: D = 0 at r = 1');
  if (!sweep) return;
  const ways = sceneTrail(sweep, [sweep.low, sweep.high], sweepFrame(state, sweep).stage);
  expect(ways.map(({ points }) => points[0])).toEqual([
    [0, 1, 1],
    [0, 1, 1],
  ]);
});

test('the trail is what the chosen method shows at each value', () => {
  // Far away, where the textbook formula has other roots than there are.
  const link = 'shape=cylinder&C=0,0,0&r=1.5&E=1e8,1,5e7&d=-1,0,-0.5&method=textbook';
  const state = stateOf(link);
  const sweep = sweepOf(state, 'r');
  expect(sweep?.samples.length).toBeGreaterThan(2);
  for (const { value, verdict, hits, f } of sweep?.samples ?? []) {
    const there = withNumber(state, 'r', value) ?? state;
    const found = intersect(shapeOf(there), rayOf(there), 'textbook');
    expect(verdict).toBe(found.class);
    expect(hits.map(({ t }) => t)).toEqual(found.hits.map(({ t }) => t));
    const { details } = found;
    expect(f).toEqual(details.family === 'curved' ? [details.A, details.B, details.C] : []);
  }
  const certified = sweepOf({ ...state, method: 'certified' }, 'r');
  expect(sweep?.boundaries).toEqual(certified?.boundaries);
  const roots = (of: typeof sweep) =>
    of?.samples.flatMap(({ hits }) => hits.map(({ t }) => t)) ?? [];
  expect(roots(sweep)).not.toEqual(roots(certified));
});

test('a goes through 0, c through a generator, N·d through 0', () => {
  const turns = (link: string, label: string) =>
    sweepOf(stateOf(link), label)?.boundaries.map(({ what, value }) => `${what} ${value}`);
  expect(turns('shape=hyperboloid&C=0,0,0&a=0.25&r=1&E=3,0,0&d=0,1,0', 'a')).toContain('A = 0 0');
  expect(turns('shape=cone&V=0,0,0&c=0.75&E=3,1,0&d=-1,1,0', 'c')).toContain('A = 0 1');
  expect(turns('shape=plane&N=0,1,0&P=0,0,0&E=0,2,0&d=1,-0.25,0', 'd.y')).toEqual(['N·d = 0 0']);
  expect(turns('shape=circle&N=0,1,0&C=0,0,0&r=1&E=0.5,2,0&d=0,-1,0', 'E.x')).toContain(
    'the edge 1',
  );
});

test('what is no number, or an axis, does not play', () => {
  for (const label of ['axis', 'N', 'E', 'q', 'E.w']) {
    expect(sweepOf(stateOf('shape=square'), label)).toBeNull();
  }
});
