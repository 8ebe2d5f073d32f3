import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { setOf } from '../../../src/check/sets.ts';
import { intersect, SHAPES } from '../../../src/math/index.ts';
import type { Stage } from '../../../src/math/shapes/drawing.ts';
import type { ShapeKind } from '../../../src/math/shapes/index.ts';
import { definitionOf } from '../../../src/math/shapes/lookup.ts';
import type { Param } from '../../../src/math/shapes/params.ts';
import type { Vec3 } from '../../../src/math/vec3.ts';
import type { Action } from '../../../src/state/actions.ts';
import { createDerive, type FullModel } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import {
  type AppState,
  INITIAL,
  paramValue,
  RAY_PARAMS,
  shapeOf,
} from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode } from '../../../src/state/url.ts';
import { many } from '../many.ts';
import { anyPicture, PICTURED } from './random-state.ts';

const open = (query: string): FullModel =>
  createDerive(() => exploreDetails)(decode(`#/explore?${query}`));
const having = (...actions: Action[]): AppState => actions.reduce(update, INITIAL);
const KINDS: readonly ShapeKind[] = SHAPES.map(({ kind }) => kind);

describe('the ray of an empty visit', () => {
  // A shape that no question set asks about yet may have its parameters chosen later.
  test.each(setOf('2').shapes)('%s: it meets it ahead, all numbers short decimals', (kind) => {
    const { derivation, found } = createDerive(() => exploreDetails)({ ...INITIAL, kind });
    const steps = derivation.steps.flatMap(({ value }) => (value === null ? [] : [value]));
    const numbers = [
      ...steps,
      ...found.hits.flatMap(({ t, point, normal }) => [t, ...point, ...normal]),
    ];
    // A, B and C of a paraboloid's 8.25 have the most digits.
    for (const x of numbers) expect(Math.abs(x * 1000 - Math.round(x * 1000))).toBeLessThan(1e-9);
    expect(found.hits.length).toBeGreaterThan(0);
    expect(found.hits.every(({ t }) => t > 0)).toBe(true);
  });
});

describe('what did not change keeps its identity', () => {
  const derive = createDerive(() => exploreDetails);
  const before = derive(INITIAL);
  const moved = derive(having({ type: 'origin', value: [2.4, 3, 2] }));

  test('E moved within the stage: the stage and the drawing stay', () => {
    expect(moved.found).not.toBe(before.found);
    expect(moved.scene.stage).toBe(before.scene.stage);
    expect(moved.scene.drawing).toBe(before.scene.drawing);
  });

  test('the very same state: everything costly stays', () => {
    const again = createDerive(() => exploreDetails);
    const first = again(INITIAL);
    const second = again(INITIAL);
    expect(second.found).toBe(first.found);
    expect(second.ray).toBe(first.ray);
    expect(second.derivation).toBe(first.derivation);
    expect(second.graph).toBe(first.graph);
    expect(second.scene.drawing).toBe(first.scene.drawing);
  });

  test('another view or bead: nothing is computed anew but the picture', () => {
    const own = createDerive(() => exploreDetails);
    const first = own(INITIAL);
    const looked = own(having({ type: 'view', view: 'top' }));
    expect(looked.found).toBe(first.found);
    expect(looked.graph).toBe(first.graph);
    const beaded = own(having({ type: 'bead', t: 1 }));
    expect(beaded.found).toBe(first.found);
    expect(beaded.scene.drawing).toBe(first.scene.drawing);
    expect(beaded.graph.bead.t).toBe(1);
  });

  test('another slope: another drawing, and back again the numbers of before', () => {
    const own = createDerive(() => exploreDetails);
    const first = own(INITIAL);
    const wide = own(having({ type: 'param', key: 'slope', value: 1.1 }));
    expect(wide.scene.drawing).not.toBe(first.scene.drawing);
    expect(wide.found).not.toEqual(first.found);
    expect(own(INITIAL).found).toEqual(first.found);
  });

  test('two derives do not share a memory', () => {
    expect(createDerive(() => exploreDetails)(INITIAL).found).not.toBe(
      createDerive(() => exploreDetails)(INITIAL).found,
    );
  });
});

describe('the model is the math module’s answer', () => {
  test.each(KINDS)('%s', (kind) => {
    const state = having({ type: 'shape', kind });
    const model = createDerive(() => exploreDetails)(state);
    expect(model.found).toEqual(intersect(shapeOf(state), model.ray, state.method));
    expect(model.ray).toEqual({ origin: state.E, direction: state.d });
    expect(model.shape).toBe(shapeOf(state));
    expect(model.contradicted).toBeNull();
    expect(model.title).toBe(definitionOf(model.shape).named(model.shape).name);
  });

  test('unit d: the kernel gets the rounded unit vector, t is a length', () => {
    const model = open('d=-3,0,-4&unit=1&shape=cylinder');
    expect(model.ray.direction).toEqual([-0.6, 0, -0.8]);
  });

  test('where a method gives another class, the exact one is told', () => {
    // A grazing miss by 2⁻⁵⁰ that doubles take for a touch.
    const query = 'shape=cylinder&C=0,0,0&r=1&E=100000000,0,1.0000000000000002&d=-1,0,0';
    const model = open(`${query}&method=textbook`);
    expect(model.found.class).not.toBe('none');
    expect(model.contradicted).toBe('none');
    expect(open(`${query}&method=exact`)).toMatchObject({
      contradicted: null,
      found: { class: 'none' },
    });
  });

  test('the verdict and the hits are those of verdict-words.ts', () => {
    const model = open('shape=cylinder&C=0,0,0&r=1&E=3,0,0&d=-1,0,0');
    expect(model.verdict.text).toBe('two points: the ray enters, then leaves');
    expect(model.hits.map(({ role }) => role)).toEqual(['first', 'other']);
    expect(model.scene.description).toBe(
      'A ray from E (3, 0, 0) in direction d (−1, 0, 0) and a cylinder: ' +
        'two points: the ray enters, then leaves. ' +
        't₁ = 2, first hit, enters, at (1, 0, 0). t₂ = 4, leaves, at (−1, 0, 0).',
    );
  });
});

describe('hits in the scene', () => {
  test('roles, points and normals', () => {
    const { hits } = open('shape=cylinder&C=0,0,0&r=1&E=0.5,0,0&d=-1,0,0').scene;
    expect(hits).toEqual([
      { index: 1, role: 'behind', t: -0.5, point: [1, 0, 0], normal: [1, 0, 0], drawn: true },
      { index: 2, role: 'first', t: 1.5, point: [-1, 0, 0], normal: [-1, 0, 0], drawn: true },
    ]);
  });

  test('a vertex has no normal to draw', () => {
    const { hits } = open('shape=cone&V=0,0,0&c=1&E=3,0,0&d=-1,0,0').scene;
    expect(hits).toEqual([
      { index: 1, role: 'first', t: 3, point: [0, 0, 0], normal: null, drawn: true },
    ]);
  });

  test('a figure that is missed shows where its plane is met, without a normal', () => {
    const { hits } = open('shape=circle&N=0,1,0&C=0,0,0&r=1&E=3,3,0&d=0,-1,0').scene;
    expect(hits).toEqual([
      { index: 1, role: 'outside', t: 3, point: [3, 0, 0], normal: null, drawn: true },
    ]);
  });

  test('what lies outside the drawn part is said', () => {
    const far = open('shape=plane&N=0,1,0&P=0,0,0&E=3,1,0&d=1,-2^-10,0').scene;
    expect(far.hits[0]?.drawn).toBe(false);
    expect(far.notes).toEqual(['P₁ (1.03 · 10³, 0, 0) lies outside the drawn part']);
    const beyond = open('shape=plane&N=0,1,0&P=0,0,0&E=0,1e300,0&d=1e10,-1e-10,0').scene;
    expect(beyond.notes).toContain('P₁ lies beyond the doubles');
    const { notes, ray } = open('shape=cylinder&E=1e6,1,0&d=-1,0,0').scene;
    expect(ray.originDrawn).toBe(false);
    expect(notes).toEqual(['E (10⁶, 1, 0) lies outside the drawn part']);
  });

  test('the stretches of the ray follow one another without gaps', () => {
    const { segments } = open('shape=cylinder&C=0,0,0&r=1&E=3,0,0&d=-1,0,0').scene.ray;
    expect(segments.map(({ stretch }) => stretch)).toEqual(['behind', 'before', 'inside', 'after']);
    expect(segments.slice(1).map(({ from }) => from)).toEqual([0, 2, 4]);
    expect(segments.slice(0, -1).map(({ to }) => to)).toEqual([0, 2, 4]);
  });

  test('between the nappes of a cone the ray is outside, beyond them inside', () => {
    const { stretches } = open('shape=cone&V=0,0,0&c=1&E=1,-5,0&d=0,1,0').graph;
    expect(stretches.map(({ stretch }) => stretch)).toEqual([
      'behind',
      'inside',
      'before',
      'inside',
    ]);
  });
});

describe('the graph', () => {
  const QUERIES = [
    ...KINDS.map((kind) => `shape=${kind}`),
    'shape=cylinder&C=0,0,0&r=1&E=1e7,0,0&d=-1,0,0',
    'shape=cylinder&C=0,0,0&r=1&E=-1e7,0,0&d=-1,0,0',
    'shape=cylinder&C=0,0,0&r=1&E=0.5,0,0&d=-1,0,0',
    'shape=cylinder&C=0,0,0&r=1e-9&E=3,0,0&d=-1,0,0',
    'shape=cone&V=0,0,0&c=1&E=3,1,0&d=1,1,0',
    'shape=circle&N=0,1,0&C=0,0,0&r=1&E=3,-3,0&d=0,-1,0',
  ];
  test.each(QUERIES)('%s: every root and the bead are within its window', (query) => {
    const { graph, found } = open(query);
    expect(graph.from).toBeLessThan(graph.to);
    expect(graph.low).toBeLessThan(0);
    expect(graph.high).toBeGreaterThan(0);
    const inside = (t: number) => t > graph.from && t < graph.to;
    expect(graph.roots.map(({ t }) => [t, inside(t)])).toEqual(
      graph.roots.map(({ t }) => [t, true]),
    );
    expect(inside(graph.bead.t)).toBe(true);
    expect(graph.roots.length).toBeGreaterThanOrEqual(found.hits.length);
    const { stretches } = graph;
    expect([stretches[0]?.from, stretches.at(-1)?.to]).toEqual([graph.from, graph.to]);
    expect(stretches.slice(1).map(({ from }) => from)).toEqual(
      stretches.slice(0, -1).map(({ to }) => to),
    );
  });

  test('f and R at the bead are the polynomial’s and the ray’s', () => {
    const { graph } = open('shape=cylinder&C=0,0,0&r=1&E=3,0,0&d=-1,0,0&t=2.5');
    expect(graph).toMatchObject({ A: 1, B: -6, C: 8 });
    expect(graph.bead).toEqual({ t: 2.5, f: -0.75, point: [0.5, 0, 0] });
  });

  test('a flat shape’s f is a line: N·d and N·(E − P)', () => {
    const { graph } = open('shape=plane&N=0,2,0&P=0,0,0&E=0,3,0&d=0,-1,0');
    expect(graph).toMatchObject({ A: 0, B: -2, C: 6, contained: false });
    expect(graph.description).toBe('f(t) is a straight line, f(0) = 6; t₁ = 3, first hit.');
  });

  test('a ray that was kept has its own f there, unless the results are hidden', () => {
    const derive = createDerive(() => exploreDetails);
    const first = decode('#/explore?shape=cylinder&C=0,0,0&r=1&E=3,0,0&d=-1,0,0');
    const kept = update(first, { type: 'ghost', on: true });
    const moved = update(kept, { type: 'origin', value: [5, 0, 0] });
    const { graph } = derive(moved);
    expect(graph.ghost).toEqual({ A: 1, B: -6, C: 8, roots: [2, 4] });
    expect([graph.B, graph.C]).toEqual([-10, 24]);
    expect(derive(moved).before).toMatchObject({ A: 1, B: -6, C: 8, D: 4, t1: 2, t2: 4 });
    expect(derive(first).before).toEqual({});
    expect(derive(update(moved, { type: 'reveal', lines: 0 })).graph.ghost).toBeNull();
    expect(derive(update(moved, { type: 'ghost', on: false })).graph.ghost).toBeNull();
  });

  test('a double root, a ray in the surface, E far away', () => {
    const touching = open('shape=cylinder&C=0,0,0&r=1&E=3,0,1&d=-1,0,0').graph;
    expect(touching.roots).toEqual([{ index: 1, t: 3, role: 'first', double: true }]);
    const within = open('shape=cylinder&C=0,0,0&r=1&E=1,0,0&d=0,1,0').graph;
    expect(within).toMatchObject({
      contained: true,
      roots: [],
      description: 'f(t) is zero for every t.',
    });
    const far = open('shape=cylinder&C=0,0,0&r=1&E=1000,0,0&d=-1,0,0').graph;
    expect(far.note).toBe('E, at t = 0, is far to the left');
  });
});

/** What the stages of two states have apart, as a share of the larger one. */
function jump(a: Stage, b: Stage): number {
  const apart = [
    Math.hypot(...a.center.map((c, i) => c - (b.center[i] ?? 0))),
    a.radius - b.radius,
    a.low - b.low,
    a.high - b.high,
    a.ground - b.ground,
  ];
  return Math.max(...apart.map(Math.abs)) / Math.max(a.radius, b.radius);
}

interface Slider {
  readonly name: string;
  readonly range: readonly [number, number];
  at(x: number): AppState;
}

function slidersOf(kind: ShapeKind): Slider[] {
  const base = having({ type: 'shape', kind });
  const along = (name: string, param: Param, value: unknown, set: (v: never) => Action) => {
    if (param.type === 'axis') return [];
    const { range } = param;
    if (param.type === 'number') {
      return [{ name, range, at: (x: number) => update(base, set(x as never)) }];
    }
    return [0, 1, 2].map((i) => ({
      name: `${name}.${'xyz'[i]}`,
      range,
      at: (x: number) =>
        update(base, set((value as Vec3).map((c, k) => (k === i ? x : c)) as never)),
    }));
  };
  const own = SHAPES.find((shape) => shape.kind === kind)?.params ?? [];
  return [
    ...along('E', RAY_PARAMS.E, base.E, (value) => ({ type: 'origin', value })),
    ...along('d', RAY_PARAMS.d, base.d, (value) => ({ type: 'direction', value })),
    ...own.flatMap((param) =>
      along(param.key, param, paramValue(shapeOf(base), param.key), (value) => ({
        type: 'param',
        key: param.key,
        value,
      })),
    ),
  ];
}

describe('the stage', () => {
  test.each([
    ...KINDS.map((kind) => `shape=${kind}`),
    'shape=cylinder&E=20,1,0&d=-1,0,0',
    'shape=cylinder&E=3,30,0&d=0,-1,0',
    'shape=plane&N=0,1,0&P=0,0,0&E=-20,1,5&d=1,-0.125,0',
    'shape=circle&C=4,4,4&r=4',
  ])('%s: contains E and the hits', (query) => {
    const { scene, state } = open(query);
    const { center, radius, low, high, ground } = scene.stage;
    const far = (p: Vec3) => Math.hypot(...p.map((c, i) => c - (center[i] ?? 0)));
    for (const p of [state.E, ...scene.hits.map(({ point }) => point)]) {
      expect(far(p)).toBeLessThanOrEqual(radius);
      expect(p[1]).toBeGreaterThan(low);
      expect(p[1]).toBeLessThan(high);
    }
    expect(low).toBeLessThanOrEqual(ground);
    expect(scene.hits.every(({ drawn }) => drawn)).toBe(true);
    expect(scene.ray.originDrawn).toBe(true);
    expect(scene.notes).toEqual([]);
  });

  test.each(KINDS)('%s: no slider makes it jump', (kind) => {
    const derive = createDerive(() => exploreDetails);
    const steps = many(60);
    for (const { name, range, at } of slidersOf(kind)) {
      const stageAt = (x: number): Stage => derive(at(x)).scene.stage;
      const [low, high] = range;
      const stages = Array.from({ length: steps + 1 }, (_, k) => {
        const x = low + ((high - low) * k) / steps;
        return { x, stage: stageAt(x) };
      });
      for (let k = 0; k < steps; k++) {
        let [a, b] = stages.slice(k, k + 2) as [(typeof stages)[0], (typeof stages)[0]];
        // Steep is allowed, a step is not: the half with the larger change is halved again until
        // nothing is left of it.
        for (let n = 0; n < 40 && jump(a.stage, b.stage) > 0.03; n++) {
          const x = (a.x + b.x) / 2;
          const middle = { x, stage: stageAt(x) };
          const inFirst = jump(a.stage, middle.stage) > jump(middle.stage, b.stage);
          [a, b] = inFirst ? [a, middle] : [middle, b];
        }
        if (jump(a.stage, b.stage) > 0.03) expect({ name, a, b }).toBe('without a jump');
      }
    }
  });

  test('is centred on the shape when that is far from the origin, or everything is tiny', () => {
    const far = open('shape=cylinder&C=1e6,0,0&r=2&E=1000003,0,0&d=-1,0,0').scene.stage;
    expect(far.center).toEqual([1e6, 0, 0]);
    expect(far.radius).toBeLessThan(10);
    const tiny = open('shape=cylinder&C=0,0,0&r=1e-9&E=3e-9,0,0&d=-1,0,0').scene.stage;
    expect(tiny.center).toEqual([0, 0, 0]);
    expect(tiny.radius).toBeLessThan(1e-8);
    expect(tiny.radius).toBeGreaterThan(1e-9);
  });
});

/** Where in a model a number is NaN, or infinite where that is not allowed; patches are sampled. */
function brokenNumbers(model: unknown, mayBeInfinite: (path: string) => boolean): string[] {
  const broken: string[] = [];
  const walk = (value: unknown, path: string): void => {
    if (value === undefined) broken.push(`${path} is undefined`);
    if (typeof value === 'number' && !Number.isFinite(value)) {
      if (Number.isNaN(value) || !mayBeInfinite(path)) broken.push(`${path} = ${value}`);
    }
    if (typeof value === 'string' && /NaN|undefined/.test(value)) broken.push(`${path}: ${value}`);
    if (typeof value === 'object' && value !== null) {
      for (const [key, part] of Object.entries(value)) walk(part, `${path}.${key}`);
    }
    if (isPatch(value)) {
      for (const [u, v] of [0, 0.3, 0.5, 1].flatMap((a) => [0, 0.4, 1].map((b) => [a, b]))) {
        walk(value.at(u ?? 0, v ?? 0), `${path}.at(${u}, ${v})`);
        walk(value.normal(u ?? 0, v ?? 0), `${path}.normal(${u}, ${v})`);
      }
    }
  };
  walk(model, '');
  return broken;
}

interface Sampled {
  at(u: number, v: number): Vec3;
  normal(u: number, v: number): Vec3;
}
const isPatch = (value: unknown): value is Sampled =>
  typeof value === 'object' &&
  value !== null &&
  'normal' in value &&
  typeof value.normal === 'function';

/** A root, a point, f itself may lie beyond the doubles: that is told, not hidden. */
const TOLD = /^\.(hits\.\d+\.(t|point|normal)|roots\.\d+\.t|bead\.(f|point)|[ABC]$|low$|high$)/;

const WORLDS = [1e-300, 1e-150, 1e-9, 1, 1e7, 1e20, 1e150, 1e300];

describe.each(WORLDS)('a world of size %d', (size) => {
  test.each(KINDS)('%s: nothing in the scene or the graph is NaN or infinite', (kind) => {
    const base = having({ type: 'shape', kind });
    const shape = shapeOf(base);
    const scaled = (v: Vec3): Vec3 => [v[0] * size, v[1] * size, v[2] * size];
    const own = SHAPES.find((entry) => entry.kind === kind)?.params ?? [];
    // What is a length or a place grows with the world; slopes, flares and normals do not.
    const actions = own.flatMap(({ key, type, ...param }): Action[] => {
      const value = paramValue(shape, key);
      if (type === 'vector' && !('nonZero' in param)) {
        return [{ type: 'param', key, value: scaled(value as Vec3) }];
      }
      return type === 'number' && 'unit' in param && param.unit === 'length'
        ? [{ type: 'param', key, value: (value as number) * size }]
        : [];
    });
    for (const d of [base.d, scaled(base.d)]) {
      const state = [
        ...actions,
        { type: 'origin', value: scaled(base.E) } as const,
        { type: 'direction', value: d } as const,
      ].reduce(update, base);
      const { scene, graph, found } = createDerive(() => exploreDetails)(state);
      const ordinary = createDerive(() => exploreDetails)(base);
      expect(found.class).toBe(ordinary.found.class);
      expect(scene.drawing.patches).toHaveLength(ordinary.scene.drawing.patches.length);
      expect(brokenNumbers(scene, (path) => TOLD.test(path))).toEqual([]);
      expect(brokenNumbers(graph, (path) => TOLD.test(path))).toEqual([]);
    }
  });
});

const SEED = 14142;
const RUNS = many(800);

test(`nothing breaks a scene or a graph: ${RUNS} states up to ${PICTURED}, seed ${SEED}`, () => {
  fc.assert(
    fc.property(anyPicture, (state) => {
      const { scene, graph, found } = createDerive(() => exploreDetails)(state);
      const nan = (model: unknown) => brokenNumbers(model, () => true);
      // Hidden, and where a float method cannot decide, f is not known; the page says that.
      const isKnown = found.class !== 'undecided' && !graph.concealed;
      const f = graph.concealed ? 0 : graph.bead.f;
      const known = isKnown ? graph : { ...graph, A: 0, B: 0, C: 0, bead: { ...graph.bead, f } };
      expect([...nan(scene), ...nan(known)]).toEqual([]);
    }),
    { seed: SEED, numRuns: RUNS },
  );
});
