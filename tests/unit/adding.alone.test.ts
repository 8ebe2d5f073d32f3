import { parseSync, transformWithOxc } from 'vite';
import { describe, expect, test, vi } from 'vitest';
import { generate } from '../../scripts/kernels/trees/generate.ts';
import { derivationFor, pose } from '../../src/check/compose.ts';
import type { Exercise, Level } from '../../src/check/exercises/define.ts';
import { EXERCISES } from '../../src/check/exercises/index.ts';
import { judge } from '../../src/check/judge.ts';
import { casesFor } from '../../src/check/program/cases.ts';
import { reportOf } from '../../src/check/program/report.ts';
import { programOf } from '../../src/check/program/source.ts';
import { plan } from '../../src/check/session.ts';
import { LATEST_SET } from '../../src/check/sets.ts';
import type { Answer } from '../../src/check/types.ts';
import { batchesOf } from '../../src/lab/plan.ts';
import { qualityOf } from '../../src/lab/quality.ts';
import { measureSession } from '../../src/lab/session.ts';
import { judge as judgeClass } from '../../src/lab/verdict.ts';
import {
  createAnswers,
  packRays,
  verdictsOfClasses,
  verdictsOfRoots,
} from '../../src/math/batch/batch.ts';
import { batchOf } from '../../src/math/batch/kernels.ts';
import { FAMILIES, type Family, findFamily, madeFamilies } from '../../src/math/families.ts';
import { intersect } from '../../src/math/intersect.ts';
import { METHODS } from '../../src/math/methods/index.ts';
import { seeded } from '../../src/math/rng.ts';
import type { ShapeDefinition } from '../../src/math/shapes/define.ts';
import { SHAPES, type Shape, type ShapeKind } from '../../src/math/shapes/index.ts';
import { definitionOf } from '../../src/math/shapes/lookup.ts';
import type { Vec3 } from '../../src/math/vec3.ts';
import { readSettings, settingsOf } from '../../src/pages/check/settings.ts';
import { sixShapes } from '../../src/scene/presets/six-shapes.ts';
import { surfacesOf } from '../../src/scene/surfaces.ts';
import type { Scene } from '../../src/scene/types.ts';
import { validateScene } from '../../src/scene/validate.ts';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { EXPORTS } from '../../src/state/exports/index.ts';
import { newThing, thingWords } from '../../src/state/picture/edits.ts';
import { initialShape, shapeOf } from '../../src/state/state.ts';
import { decode, encode } from '../../src/state/url.ts';
import { shortest } from '../../src/text/format.ts';
import { run } from './check/students.ts';
import { contractOf } from './math/contract.ts';
import { ellipticCylinder } from './toy-shape.ts';
import { flatten, TINY, tracerFor } from './tracer/tracing.ts';

/*
 * "A new shape, or a new method, is one new file and one word in an index": a shape and a method
 * that exist in this test only are put into the lists, and every page's part is asked about them.
 */

vi.mock('../../src/math/shapes/index.ts', async (original) => {
  const { SHAPES: own } = await original<{ SHAPES: readonly unknown[] }>();
  const { ellipticCylinder: toy } = await import('./toy-shape.ts');
  return { SHAPES: [...own, toy] };
});
vi.mock('../../src/math/methods/index.ts', async (original) => {
  const { METHODS: own } = await original<{ METHODS: readonly unknown[] }>();
  const { momentTextbook: toy } = await import('./toy-method.ts');
  return { METHODS: [...own, toy] };
});

const KIND = ellipticCylinder.kind as unknown as ShapeKind;
const METHOD = 'moment-textbook';
const toy = (center: Vec3, radius: number): Shape =>
  ({ kind: KIND, center, radius }) as unknown as Shape;
const method = (id: string) => {
  const found = METHODS.find((one) => one.id === id);
  if (!found) throw new RangeError(id);
  return found;
};
const MADE: readonly Family[] = (['ordinary', 'special', 'hard'] as const).flatMap((hardness) =>
  madeFamilies(KIND, hardness),
);

test('both are in their lists', () => {
  expect(SHAPES.map(({ kind }) => kind as string)).toContain('elliptic-cylinder');
  expect(METHODS.map(({ id }) => id as string)).toContain(METHOD);
});

describe('the contract of shapes', () =>
  contractOf(ellipticCylinder as unknown as ShapeDefinition<Shape>));

describe('families', () => {
  test('there are some of each hardness, and Accuracy offers them', () => {
    for (const hardness of ['ordinary', 'special', 'hard'] as const) {
      expect(madeFamilies(KIND, hardness)).not.toEqual([]);
    }
    for (const family of MADE) expect(FAMILIES()).toContain(family);
  });

  test('together they have every class that the shape has', () => {
    const random = seeded(5);
    const classes = MADE.flatMap(({ make }) =>
      Array.from({ length: 150 }, () => {
        const { shape, ray } = make(random);
        expect(shape.kind).toBe(KIND);
        return intersect(shape, ray, 'exact').class;
      }),
    );
    expect([...new Set(classes)].sort()).toEqual(['contained', 'none', 'tangent', 'two']);
  });
});

describe.each(METHODS.map(({ id }) => id as string))('batches of %s', (id) => {
  test('give the class and the roots of intersect, bit by bit (seed 6)', () => {
    const random = seeded(6);
    for (const family of [...MADE, findFamily('typical') as Family]) {
      const { shape, rays: list } = family.batch(random, 30);
      const rays = packRays(list);
      const out = createAnswers(list.length);
      const kernel = batchOf(method(id), shape);
      kernel.classes(rays, out);
      const classes = verdictsOfClasses(out, rays.count, kernel.met);
      kernel.both(rays, out);
      const roots = verdictsOfRoots(out, rays.count);
      list.forEach((ray, i) => {
        const found = intersect(shape, ray, id);
        const ts = [out.t0[i] as number, out.t1[i] as number].filter((t) => !Number.isNaN(t));
        expect({ shape, ray, class: classes[i], roots: roots[i], ts }).toEqual({
          ...{ shape, ray, class: found.class, roots: found.class },
          ts: found.hits.map(({ t }) => t),
        });
      });
    }
  });
});

test('npm run kernels makes loops of both, in programs that are sound', () => {
  const files = generate();
  expect(files.map(({ path }) => path)).toContain(`${METHOD}-simd.ts`);
  for (const { path, text } of files)
    expect([path, parseSync(path, text).errors]).toEqual([path, []]);
  expect(files.at(-1)?.text).toContain(`'${METHOD}'`);
  expect(files.at(-1)?.text).toContain(`'${KIND}'`);
});

describe('Accuracy', () => {
  const families = [...MADE, findFamily('typical'), findFamily('near-tangent-far')] as Family[];

  test.each(families.map((family) => [family.id, family] as const))(
    'counts on %s what intersect gives one by one',
    (_, family) => {
      const sample = { seed: 8, shapes: 5, count: 40 };
      const { judged, rays } = qualityOf(method(METHOD), batchesOf(family, sample));
      const random = seeded(sample.seed);
      const counted = { right: 0, misses: 0, invents: 0, misnames: 0, undecided: 0 };
      for (let i = 0; i < sample.shapes; i++) {
        const { shape, rays: list } = family.batch(random, sample.count);
        for (const ray of list) {
          const truth = intersect(shape, ray, 'exact').class;
          counted[judgeClass(intersect(shape, ray, METHOD).class, truth)]++;
        }
      }
      expect({ rays, judged }).toEqual({ rays: 200, judged: counted });
    },
  );

  test('has a row for the method, and one for each other', () => {
    const plan = { rounds: 1, least: 0, steps: 0, warmUp: 0 };
    const rays = { seed: 1, shapes: 2, count: 10, timed: 20, order: 'random' as const };
    const request = { ...rays, family: KIND, budget: { least: 10, most: 1e9 }, plan };
    let now = 0;
    const last = [...measureSession(request, () => now++)].at(-1);
    expect(last?.columns.typescript.map(({ id }) => id)).toEqual(METHODS.map(({ id }) => id));
    const truth = last?.columns.typescript.find(({ id }) => id === 'exact');
    expect(truth?.quality.judged.right).toBe(20);
  });
});

describe('Picture', () => {
  const scene: Scene = {
    ...sixShapes.scene,
    // So low and so far to the side that the shadow falls where it is seen.
    lights: [{ light: 'point', id: 'lamp', colour: '#ffffff', strength: 1, at: [-4, 3, 1] }],
    things: sixShapes.scene.things.flatMap((thing) =>
      thing.id === 'floor' || thing.id === 'circle'
        ? [thing]
        : thing.id === 'cylinder'
          ? [{ ...thing, shape: toy([0, 0, 0], 1.25), between: [0, 2] as const }]
          : [],
    ),
  };

  test('a scene with it is in order, also with one that was added by the menu', () => {
    expect(() => validateScene(JSON.parse(JSON.stringify(scene)))).not.toThrow();
    const added = newThing(scene, KIND);
    expect(added.shape.kind).toBe(KIND);
    const both = { ...scene, things: [...scene.things, added] };
    expect(() => validateScene(both)).not.toThrow();
    expect(thingWords(both, added), 'a name of two words says what it is').toBe('');
  });

  test.each(['certified', METHOD])('traced by %s: every ray ends where exact says', async (id) => {
    const surfaces = surfacesOf(scene);
    const tracer = await tracerFor(scene, { method: id });
    const hits = new Map<string, number>();
    let blocked = 0;
    for (let pixel = 0; pixel < TINY.width * TINY.height; pixel += 5) {
      const x = pixel % TINY.width;
      const { rays } = tracer.record(x, (pixel - x) / TINY.width);
      for (const { kind, ray, from, end } of flatten(rays)) {
        const first = surfaces.map(({ shape, between = [-Infinity, Infinity] }) => {
          const found = intersect(shape, ray, 'exact', { from: surfaces[from]?.shape });
          const ahead = found.hits.filter(
            ({ t, point: [, y] }) => t > 0 && y >= between[0] && y <= between[1],
          );
          return ahead[0]?.t ?? Infinity;
        });
        const least = Math.min(...first);
        if (end.end === 'blocked') blocked++;
        if (kind === 'shadow') continue;
        if (end.end !== 'hit') expect(least).toBe(Infinity);
        else {
          expect(end.surface).toBe(first.indexOf(least));
          expect(Math.abs(end.t - least)).toBeLessThanOrEqual(1e-12 * least);
          const kindHit = surfaces[end.surface]?.shape.kind ?? '';
          hits.set(kindHit, (hits.get(kindHit) ?? 0) + 1);
        }
      }
    }
    expect(hits.get(KIND)).toBeGreaterThan(10);
    expect(blocked).toBeGreaterThan(10);
  });
});

describe('Check', () => {
  const asked = EXERCISES.filter(({ kinds }) => kinds.includes(KIND));
  const asText = (answer: Answer | undefined): string => {
    if (typeof answer === 'number') return shortest(answer);
    return typeof answer === 'object' ? answer.map(shortest).join('; ') : (answer ?? '-');
  };

  test('asks about it', () => {
    const ids = asked.map(({ id }) => id);
    expect(ids).toEqual(expect.arrayContaining(['coefficients', 'discriminant', 'roots', 'first']));
  });

  test('a session of a new seed asks about it, and a link to it opens', () => {
    const asked = plan(41, LATEST_SET).map(({ kind }) => kind as string);
    expect(asked).toContain(KIND);
    expect(plan(41).map(({ kind }) => kind as string)).not.toContain(KIND);
    const { settings, problems } = readSettings({ set: LATEST_SET, seed: '41', cases: KIND });
    expect(problems).toEqual([]);
    expect(settingsOf(settings)).toMatchObject({ set: LATEST_SET, cases: KIND });
    const link = encode(decode(`#/check?set=${LATEST_SET}&seed=41`));
    expect(decode(link).settings.check).toMatchObject({ set: LATEST_SET });
  });

  test('the truth is right, and a known mistake is named', () => {
    const judged = (exercise: Exercise, level: Level) => {
      const posed = pose(exercise, KIND, 17 * level, level);
      expect(posed.draft.shape.kind).toBe(KIND);
      const texts = Object.fromEntries(
        posed.fields.map(({ id }) => [id, asText(posed.truth[id])] as const),
      );
      expect([exercise.id, judge(derivationFor(posed), texts).verdict]).toEqual([
        exercise.id,
        'correct',
      ]);
      for (const { misconception, answers } of posed.suspects) {
        const own = Object.fromEntries(
          posed.fields.map(({ id }) => [id, asText(answers[id])] as const),
        );
        const { verdict, causes } = judge(derivationFor(posed), own);
        expect([verdict, causes.map(({ id }) => id)]).toEqual(['wrong', [misconception.id]]);
      }
    };
    for (const exercise of asked) for (const level of [1, 2, 3] as const) judged(exercise, level);
  });

  test('a program about it is judged: the textbook one is right on what is not hard', () => {
    const cases = casesFor([KIND], 41);
    const { groups, findings } = reportOf(cases, run(programOf(KIND) ?? '', cases));
    for (const { id, passed, total } of groups) {
      if (id === 'ordinary' || id === 'special') expect([id, passed]).toEqual([id, total]);
      expect([id, total > 0]).toEqual([id, true]);
    }
    expect(findings).toEqual([]);
  });
});

describe('Explore', () => {
  const ray = `E=4,1,0.125&d=-1,0.125,0&method=${METHOD}`;
  const link = `#/explore?shape=${KIND}&C=0.5,1,-0.25&r=1.25&${ray}`;
  const model = createDerive(() => exploreDetails)(decode(link));

  test('a link opens it, and the state makes the same link', () => {
    const state = decode(link);
    expect(state.problems).toEqual([]);
    expect(shapeOf(state)).toEqual(toy([0.5, 1, -0.25], 1.25));
    expect(state.method).toBe(METHOD);
    expect(decode(encode(state))).toEqual(state);
  });

  test('the page says what it is, and what is found', () => {
    expect(model.title).toBe('elliptic cylinder');
    expect(model.found).toEqual(intersect(toy([0.5, 1, -0.25], 1.25), shapeRay(link), METHOD));
    expect(model.verdict.text).not.toMatch(/undefined|null|NaN/);
    const along = decode(`#/explore?shape=${KIND}&d=0,1,0&E=9,0,0`);
    expect(createDerive(() => exploreDetails)(along).verdict.text).not.toMatch(
      /undefined|null|NaN/,
    );
  });

  describe.each(EXPORTS.map((one) => [one.id, one] as const))('export %s', (_, { text }) => {
    test('has its symbols', () => {
      const said = text(model);
      // By symbol in formulas, by its name in the call of a function.
      expect(said).toMatch(/\b(r|radius)\b/);
      expect(said).toMatch(/\b(C|center)\b|\bC[xyz]\b|C_/);
      expect(said).not.toMatch(/undefined/);
    });
  });

  test('the exported program finds the textbook method’s roots', async () => {
    const text = EXPORTS.find(({ id }) => id === 'typescript')?.text(model) ?? '';
    const { code } = await transformWithOxc(text, 'ray.ts');
    const printed: string[] = [];
    new Function('console', code)({ log: (line: string) => printed.push(line) });
    const { hits } = intersect(toy([0.5, 1, -0.25], 1.25), shapeRay(link), 'textbook');
    const said = JSON.parse(printed.join('\n'));
    expect(said.hits.map(({ t }: { t: number }) => t)).toEqual(hits.map(({ t }) => t));
    expect(hits).toHaveLength(2);
  });
});

const shapeRay = (link: string) => {
  const { E, d } = decode(link);
  return { origin: E, direction: d };
};

test('the entry’s own words are what the pages use', () => {
  const shape = initialShape(KIND);
  expect(definitionOf(shape).title).toBe(ellipticCylinder.title);
});
