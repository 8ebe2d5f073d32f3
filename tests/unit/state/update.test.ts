import { describe, expect, test } from 'vitest';
import { METHODS, SHAPES } from '../../../src/math/index.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import type { Action } from '../../../src/state/actions.ts';
import { NAMED_VIEWS } from '../../../src/state/camera-view.ts';
import {
  type AppState,
  INITIAL,
  initialShape,
  PAGES,
  paramValue,
  rayOf,
  shapeOf,
} from '../../../src/state/state.ts';
import { createStore } from '../../../src/state/store.ts';
import { update } from '../../../src/state/update.ts';

const having = (...actions: Action[]): AppState => actions.reduce(update, INITIAL);
const [NAN, INF] = [Number.NaN, Infinity];

/** Objects of this test are frozen through and through, so that a change in place would throw. */
function frozen<T>(value: T): T {
  if (typeof value === 'object' && value !== null && !Object.isFrozen(value)) {
    Object.freeze(value);
    Object.values(value).forEach(frozen);
  }
  return value;
}

describe('each action changes exactly its own part', () => {
  const E: Vec3 = [1, -0, 1e300];
  const CASES: [string, Action, Partial<AppState>][] = [
    ['shape', { type: 'shape', kind: 'circle' }, { kind: 'circle' }],
    ['origin', { type: 'origin', value: E }, { E }],
    ['direction', { type: 'direction', value: [0, 0, 5e-324] }, { d: [0, 0, 5e-324] }],
    ['unit', { type: 'unit', on: true }, { unit: true }],
    ['method', { type: 'method', id: 'textbook' }, { method: 'textbook' }],
    ['a named view', { type: 'view', view: 'top' }, { view: 'top' }],
    [
      'a free view',
      { type: 'view', view: { azimuth: 30, elevation: -90, zoom: 2 } },
      { view: { azimuth: 30, elevation: -90, zoom: 2 } },
    ],
    ['bead', { type: 'bead', t: -2.5 }, { bead: -2.5 }],
    [
      'param',
      { type: 'param', key: 'slope', value: -2 },
      { shapes: { ...INITIAL.shapes, cone: { kind: 'cone', vertex: [0, 2.5, 0], slope: -2 } } },
    ],
  ];
  test.each(CASES)('%s', (_, action, change) => {
    expect(update(frozen(INITIAL), frozen(action))).toEqual({ ...INITIAL, ...change });
  });

  test('the bead is sent back to where the picture is clearest', () => {
    expect(having({ type: 'bead', t: 3 }, { type: 'bead', t: null }).bead).toBeNull();
  });

  test('dismiss clears what was wrong with a link', () => {
    const told = update(INITIAL, { type: 'link', hash: '#/explore?E=x' });
    expect(told.problems).toHaveLength(1);
    expect(update(told, { type: 'dismiss' }).problems).toEqual([]);
  });

  test('a link replaces ray, shape, method and view', () => {
    const moved = having({ type: 'bead', t: 1 }, { type: 'origin', value: [9, 9, 9] });
    const linked = update(moved, { type: 'link', hash: '#/explore?shape=plane&N=0,1,0' });
    expect(linked).toMatchObject({ kind: 'plane', E: [3, 1, 1], bead: null });
    expect(shapeOf(linked)).toMatchObject({ normal: [0, 1, 0] });
  });
});

describe('what is not allowed leaves the state the very same object', () => {
  const REFUSED: [string, Action][] = [
    ['an unknown shape', { type: 'shape', kind: 'torus' }],
    ['a shape named like a property', { type: 'shape', kind: 'toString' }],
    ['a NaN in E', { type: 'origin', value: [NAN, 0, 0] }],
    ['an infinite E', { type: 'origin', value: [0, INF, 0] }],
    ['two numbers for E', { type: 'origin', value: [0, 1] as unknown as Vec3 }],
    ['a zero d', { type: 'direction', value: [0, -0, 0] }],
    ['an infinite d', { type: 'direction', value: [0, -INF, 0] }],
    ['a parameter that the shape has not', { type: 'param', key: 'radius', value: 1 }],
    ['the kind as a parameter', { type: 'param', key: 'kind', value: 'plane' }],
    ['a prototype as a parameter', { type: 'param', key: '__proto__', value: 1 }],
    ['text for a number', { type: 'param', key: 'slope', value: '1' }],
    ['NaN for a number', { type: 'param', key: 'slope', value: NAN }],
    ['a number for a vector', { type: 'param', key: 'vertex', value: 1 }],
    ['an unknown method', { type: 'method', id: 'magic' }],
    ['an unknown view', { type: 'view', view: 'back' as never }],
    ['a zoom of 0', { type: 'view', view: { azimuth: 0, elevation: 0, zoom: 0 } }],
    ['a zoom of NaN', { type: 'view', view: { azimuth: 0, elevation: 0, zoom: NAN } }],
    ['an azimuth without end', { type: 'view', view: { azimuth: INF, elevation: 0, zoom: 1 } }],
    ['looking past the pole', { type: 'view', view: { azimuth: 0, elevation: 91, zoom: 1 } }],
    ['an infinite bead', { type: 'bead', t: INF }],
    ['a bead of NaN', { type: 'bead', t: NAN }],
    ['a reset of something unknown', { type: 'reset', what: { param: 'radius' } }],
  ];
  test.each(REFUSED)('%s', (_, action) => {
    expect(update(INITIAL, action)).toBe(INITIAL);
  });

  test.each([
    ['cylinder', 'radius', -1],
    ['circle', 'normal', [0, 0, 0]],
    ['square', 'side', -1e-300],
    ['square', 'axis', 'w'],
  ] as const)('%s: %s = %j', (kind, key, value) => {
    const state = having({ type: 'shape', kind });
    expect(update(state, { type: 'param', key, value: value as never })).toBe(state);
  });
});

describe('shapes', () => {
  test('each remembers its parameters while another one is shown', () => {
    const state = having(
      { type: 'shape', kind: 'cylinder' },
      { type: 'param', key: 'radius', value: 3 },
      { type: 'shape', kind: 'hyperboloid' },
      { type: 'param', key: 'radius', value: 0.5 },
      { type: 'shape', kind: 'cylinder' },
    );
    expect(shapeOf(state)).toMatchObject({ kind: 'cylinder', radius: 3 });
    expect(state.shapes.hyperboloid).toMatchObject({ radius: 0.5 });
    expect(state.shapes.cone).toBe(INITIAL.shapes.cone);
  });

  test('the ray stays when the shape changes', () => {
    const moved = having({ type: 'origin', value: [7, 7, 7] }, { type: 'unit', on: true });
    for (const { kind } of SHAPES) {
      const other = update(moved, { type: 'shape', kind });
      expect(other).toEqual({ ...moved, kind });
      expect([other.E, other.d]).toEqual([moved.E, moved.d]);
    }
  });

  test('every one of them starts as its parameters say', () => {
    for (const { kind, params } of SHAPES) {
      for (const { key, initial } of params) {
        expect(paramValue(INITIAL.shapes[kind], key)).toEqual(initial);
      }
    }
  });
});

describe('resets', () => {
  const moved = having(
    { type: 'origin', value: [7, 7, 7] },
    { type: 'direction', value: [1, 1, 1] },
    { type: 'param', key: 'slope', value: 2 },
    { type: 'param', key: 'vertex', value: [1, 1, 1] },
    { type: 'unit', on: true },
    { type: 'bead', t: 4 },
    { type: 'view', view: 'side' },
    { type: 'method', id: 'stable' },
  );

  test.each([
    ['E', { ...moved, E: INITIAL.E }],
    ['d', { ...moved, d: INITIAL.d }],
  ] as const)('%s alone', (what, expected) => {
    expect(update(moved, { type: 'reset', what })).toEqual(expected);
  });

  test('one parameter alone', () => {
    const state = update(moved, { type: 'reset', what: { param: 'slope' } });
    expect(shapeOf(state)).toEqual({ kind: 'cone', vertex: [1, 1, 1], slope: 1 });
    expect(state.E).toBe(moved.E);
  });

  test('all of the shape that is shown; the others stay, and so does the method', () => {
    const two = [
      { type: 'shape', kind: 'circle' },
      { type: 'param', key: 'radius', value: 1 },
      { type: 'shape', kind: 'cone' },
      { type: 'reset', what: 'all' },
    ] as const satisfies readonly Action[];
    const state = [...two].reduce<AppState>(update, moved);
    expect(shapeOf(state)).toEqual(initialShape('cone'));
    expect(state.shapes.circle).toMatchObject({ radius: 1 });
    expect(state).toMatchObject({
      E: INITIAL.E,
      d: INITIAL.d,
      unit: false,
      bead: null,
      view: 'iso',
      method: 'stable',
    });
  });
});

describe('the ray that the kernel gets', () => {
  test('d as it is given, or its rounded unit vector', () => {
    const state = having({ type: 'direction', value: [3, 0, -4] });
    expect(rayOf(state).direction).toBe(state.d);
    const unit = update(state, { type: 'unit', on: true });
    expect(rayOf(unit)).toEqual({ origin: INITIAL.E, direction: [0.6, 0, -0.8] });
    expect(unit.d).toEqual([3, 0, -4]);
  });
});

describe('the store', () => {
  test('tells of a change, not of an action that changed nothing', () => {
    const store = createStore(INITIAL);
    const heard: AppState[] = [];
    const stop = store.subscribe((state) => heard.push(state));
    store.dispatch({ type: 'bead', t: NAN });
    expect(heard).toEqual([]);
    store.dispatch({ type: 'bead', t: 2 });
    expect(heard).toEqual([store.get()]);
    expect(store.get().bead).toBe(2);
    stop();
    store.dispatch({ type: 'bead', t: 3 });
    expect(heard).toHaveLength(1);
  });
});

test('the initial state is allowed by its own rules', () => {
  expect(PAGES.map(({ id }) => id)).toContain(INITIAL.page);
  expect(METHODS.map(({ id }) => id as string)).toContain(INITIAL.method);
  expect(NAMED_VIEWS.map(({ id }) => id)).toContain(INITIAL.view);
  expect(update(INITIAL, { type: 'origin', value: INITIAL.E })).toEqual(INITIAL);
  expect(update(INITIAL, { type: 'direction', value: INITIAL.d })).toEqual(INITIAL);
});
