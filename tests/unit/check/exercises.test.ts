import { describe, expect, test } from 'vitest';
import { derivationFor, type Posed, pose } from '../../../src/check/compose.ts';
import type { Draft, Level } from '../../../src/check/exercises/define.ts';
import { digitsRight } from '../../../src/check/exercises/digits.ts';
import { isClean } from '../../../src/check/exercises/draw.ts';
import { slug } from '../../../src/check/exercises/effect.ts';
import { stepOf, turnOf } from '../../../src/check/exercises/graph.ts';
import { EARLIER, EXERCISES } from '../../../src/check/exercises/index.ts';
import { OF_PAIRS } from '../../../src/check/exercises/method.ts';
import { alike, type Texts } from '../../../src/check/grade.ts';
import { judge } from '../../../src/check/judge.ts';
import { plan, question } from '../../../src/check/session.ts';
import { FIRST_SET, setOf } from '../../../src/check/sets.ts';
import type { Answer, Answers, Field } from '../../../src/check/types.ts';
import { doubleDoubleOver } from '../../../src/math/arithmetic/double-double.ts';
import { doubles } from '../../../src/math/float/floats.ts';
import { type Intersection, intersect } from '../../../src/math/index.ts';
import { definitionOf } from '../../../src/math/shapes.ts';
import { planEffects } from '../../../src/scene/effects/plan.ts';
import { findPreset } from '../../../src/scene/presets/index.ts';
import { cutDrawing, endPoints } from '../../../src/state/cut-drawing.ts';
import { stageAround } from '../../../src/state/stage.ts';
import { shortest } from '../../../src/text/format.ts';
import { cameraAxes, fireCamera } from '../../../src/tracer/camera.ts';
import { createWave } from '../../../src/tracer/wave.ts';
import { byTurns, many } from '../many.ts';

const SEEDS = many(200);

const asText = (answer: Answer | undefined): string => {
  if (typeof answer === 'number') return Number.isNaN(answer) ? '1/0' : shortest(answer);
  return typeof answer === 'object' ? answer.map(shortest).join('; ') : (answer ?? '-');
};

const texts = (fields: readonly Field[], answers: Answers): Texts =>
  Object.fromEntries(fields.map(({ id }) => [id, asText(answers[id])] as const));

const answered = (posed: Posed, answers: Answers) =>
  judge(derivationFor(posed), texts(posed.fields, answers));

const sideAt = (details: Intersection['details']): string => {
  const C = details.family === 'curved' ? details.C : Number.NaN;
  return C < 0 ? 'inside' : C > 0 ? 'outside' : 'on';
};

type Hits = Intersection['hits'];

/** The roots of a second shape, and which of both is met when. */
function bySecondShape({ other, ray }: Draft, first: Hits): Answers {
  if (!other) return {};
  const { hits: second } = intersect(other, ray, 'exact');
  const all = [...first.map(({ t }) => `${t} a`), ...second.map(({ t }) => `${t} b`)]
    .map((one) => one.split(' ') as [string, string])
    .filter(([t]) => Number(t) >= 0)
    .sort(([a], [b]) => Number(a) - Number(b));
  const [s1, s2] = second.map(({ t }) => t);
  return { s1: s1 ?? 0, s2: s2 ?? 0, order: all.map(([, of]) => of).join('') };
}

/** What the math module cuts off. */
function byEnds({ between, shape, ray }: Draft): Answers {
  if (!between) throw new RangeError('no ends');
  const { hits } = intersect(
    { ...shape, between } as Parameters<typeof intersect>[0],
    ray,
    'exact',
  );
  const out = hits.flatMap(({ fate }, i) => (fate === 'cut' ? [`t${i + 1}`] : []));
  const first = hits.find(({ t, fate }) => fate === 'hit' && t >= 0);
  const cut = out.length === 2 ? 'both' : (out[0] ?? 'none');
  return { cut, ...(first ? { t: first.t } : {}) };
}

/** The direction in which the tracer sends the ray of this pixel. */
function byTracer({ pixel, ray }: Draft): Answer {
  if (!pixel) throw new RangeError('no pixel');
  const { column, row, columns: width, rows: height, side, middle } = pixel;
  const far = Math.hypot(...middle.map((x, i) => x - (ray.origin[i] ?? 0)));
  const angle = (360 / Math.PI) * Math.atan((side * height) / 2 / far);
  const axes = cameraAxes({ eye: ray.origin, target: middle, angle }, width / height);
  const wave = createWave(1);
  const settings = { width, height, samples: 1 } as Parameters<typeof fireCamera>[1];
  fireCamera(axes, settings, [row * width + column], wave);
  const { dx, dy, dz } = wave.rays;
  return [dx[0] ?? 0, dy[0] ?? 0, dz[0] ?? 0];
}

/** The effect that the tracer's plan leaves out of the scene. */
function byPlan({ id, effects }: NonNullable<Draft['scene']>): Answers {
  const scene = findPreset(id)?.scene;
  if (!scene) throw new RangeError(id);
  const out = planEffects(scene).filter((one) => effects.includes(one.id) && !one.runs);
  expect(out.map(({ leftOut }) => leftOut)).toEqual([false]);
  return { effect: out[0]?.id ?? '', reason: slug(out[0]?.reason ?? '') };
}

/** The truth again, by the exact method and nothing of src/check. */
function byExactMethod({ draft, fields, exercise }: Posed): Answers {
  const { class: verdict, hits, details } = intersect(draft.shape, draft.ray, 'exact');
  const first = hits.find(({ t }) => t >= 0);
  const flat = details.family === 'flat' ? details : null;
  const known: Record<string, Answer | undefined> = {
    ...(details.family === 'curved'
      ? { A: details.A, B: details.B, C: details.C, D: details.D }
      : {}),
    ...(flat ? { 'N.d': flat.rate, 'N.(E-P)': flat.offset } : {}),
    case: verdict,
    t1: flat ? flat.plane?.t : hits[0]?.t,
    t2: hits[1]?.t,
    t: first?.t,
    P: first?.point,
    N: first?.normal,
    inside: flat?.plane?.inside ? 'inside' : 'outside',
    place: flat?.plane ? 'meets' : verdict === 'contained' ? 'in' : 'beside',
    first: first ? `t${hits.indexOf(first) + 1}` : 'none',
    why: first && hits.indexOf(first) === 0 ? 'farther' : 'behind',
    shadow: first && first.t > 0 && first.t < 1 ? 'dark' : 'lit',
    value: draft.param?.value,
    side: sideAt(details),
  };
  if (draft.other) Object.assign(known, bySecondShape(draft, hits));
  if (draft.between) {
    delete known.t;
    Object.assign(known, byEnds(draft));
  }
  if (draft.pixel) known.d = byTracer(draft);
  if (exercise.id === 'graph') known.case = verdict;
  if (draft.scene) Object.assign(known, byPlan(draft.scene));
  const at = (by: number): string => {
    if (!draft.param) return '';
    const shape = { ...draft.shape, [draft.param.key]: draft.param.value + by };
    return intersect(shape, draft.ray, 'exact').class;
  };
  Object.assign(known, { before: at(-1 / 64), at: at(0), after: at(1 / 64) });
  return Object.fromEntries(
    fields.flatMap(({ id }) => {
      const answer = known[id];
      return answer === undefined ? [] : [[id, answer] as const];
    }),
  );
}

describe.each([...EXERCISES, ...EARLIER].map((exercise) => [exercise.id, exercise] as const))(
  '%s',
  (_, exercise) => {
    const all: Posed[] = [];
    for (let seed = 1; seed <= SEEDS; seed++) {
      const kind = exercise.kinds[seed % exercise.kinds.length];
      if (!kind) throw new RangeError('an exercise without shapes');
      all.push(pose(exercise, kind, seed * 7919, ((seed % 3) + 1) as Level));
    }

    test(`the true answer is accepted, seeds 1 to ${SEEDS}`, () => {
      for (const posed of all) expect(answered(posed, posed.truth).verdict).toBe('correct');
    });

    test('and it is what the exact method says', () => {
      if (!exercise.paper) return;
      for (const posed of all) {
        const truth = byExactMethod(posed);
        const asked = posed.fields.filter((field) => !field.mayBeAbsent || truth[field.id]);
        for (const { id } of asked) expect(truth[id], id).toBeDefined();
        expect(alike(posed.fields, truth, posed.truth), JSON.stringify([posed.draft, truth])).toBe(
          true,
        );
      }
    });

    test('each misconception is rejected and named', () => {
      // What is no algebra has no formulas to edit.
      if (all.every(({ draft }) => draft.watch.length === 0)) return;
      let named = 0;
      let close = 0;
      for (const posed of byTurns(all)) {
        for (const { misconception, answers } of posed.suspects) {
          const judged = answered(posed, answers);
          // By chance a mistake may be right to three digits; that is said of it.
          if (judged.verdict === 'rounded') {
            close++;
            continue;
          }
          expect(judged.verdict).toBe('wrong');
          expect(judged.causes.map(({ id }) => id)).toEqual([misconception.id]);
          named++;
        }
      }
      expect(named).toBeGreaterThanOrEqual(SEEDS / 8);
      expect(close).toBeLessThanOrEqual(named / 50);
    });

    test('no two misconceptions coincide', () => {
      for (const { suspects, fields } of all) {
        suspects.forEach((a, i) => {
          for (const b of suspects.slice(0, i)) {
            expect(alike(fields, a.answers, b.answers)).toBe(false);
          }
        });
      }
    });

    test('numbers are clean enough for paper where it is for paper', () => {
      if (!exercise.paper) return;
      for (const { given, truth, draft } of all) {
        const numbers = [...Object.values(given), ...Object.values(truth)];
        for (const x of numbers) if (typeof x !== 'string') expect(isClean(x), `${x}`).toBe(true);
        if (exercise.hidden) continue;
        expect(
          [...draft.ray.origin, ...draft.ray.direction].every((x) => Number.isInteger(2 * x)),
        ).toBe(true);
      }
    });

    test('nothing is right for everybody: the right choices differ from seed to seed', () => {
      for (const field of all[0]?.fields ?? []) {
        if (field.kind !== 'choice') continue;
        const right = new Set(all.map(({ truth }) => truth[field.id]));
        const always = exercise.id === 'nappes' || exercise.id === 'tangent';
        if (!always) expect(right.size, field.id).toBeGreaterThan(1);
      }
    });
  },
);

describe('posing ends', () => {
  test.each(EXERCISES.map((exercise) => [exercise.id, exercise] as const))(
    '%s, for each of its shapes at each level',
    (_, exercise) => {
      for (const kind of exercise.kinds) {
        for (const level of [1, 2, 3] as const) {
          expect(pose(exercise, kind, 613 * level, level).draft.shape.kind).toBe(kind);
        }
      }
    },
  );

  test('also where there is nothing to pose, within one draw or over many', () => {
    const [exercise] = EXERCISES;
    if (!exercise) throw new RangeError('no exercises');
    const never = (random: () => number): null => {
      random();
      return null;
    };
    const forEver = (random: () => number): never => {
      for (;;) random();
    };
    for (const draw of [never, forEver]) {
      expect(() => pose({ ...exercise, draw }, 'plane', 1, 1)).toThrow('no input for flat, plane');
    }
  });
});

describe('the opposite ray and the swapped roots', () => {
  const posedAs = (id: string): Posed[] => {
    const exercise = EXERCISES.find((one) => one.id === id);
    if (!exercise) throw new RangeError(id);
    return Array.from({ length: 60 }, (_, i) => {
      const kind = exercise.kinds[i % exercise.kinds.length];
      return pose(exercise, kind as (typeof exercise.kinds)[number], i + 1, 2);
    });
  };

  test('the roots of the opposite ray, seeds 1 to 60', () => {
    for (const posed of posedAs('roots')) {
      const { origin, direction } = posed.draft.ray;
      const back = { origin, direction: direction.map((x) => -x) as unknown as typeof direction };
      const [a, b] = intersect(posed.draft.shape, back, 'exact').hits;
      const judged = answered(posed, { t1: a?.t ?? 0, t2: b?.t ?? 0 });
      expect(judged.verdict).toBe('wrong');
      expect(judged.causes[0]?.id).toBe('lost-minus');
    }
  });

  test('the point of the opposite ray', () => {
    for (const posed of posedAs('point')) {
      const { origin: E, direction: d } = posed.draft.ray;
      const { hits } = intersect(posed.draft.shape, posed.draft.ray, 'exact');
      const t = hits.find((hit) => hit.t >= 0)?.t ?? 0;
      const judged = answered(posed, { P: [E[0] - t * d[0], E[1] - t * d[1], E[2] - t * d[2]] });
      expect(judged.causes[0]?.id).toBe('backwards');
    }
  });

  test('the roots swapped', () => {
    for (const posed of posedAs('roots')) {
      const { t1 = 0, t2 = 0 } = posed.truth;
      const judged = answered(posed, { t1: t2, t2: t1 });
      expect(judged.verdict).toBe('wrong');
      expect(judged.causes[0]?.id).toBe('swapped-roots');
    }
  });
});

test('digits are lost on every line but B, and every cure is the right one somewhere', () => {
  const exercise = EXERCISES.find(({ id }) => id === 'digits.2');
  if (!exercise) throw new RangeError('digits');
  const { classes = [], without = {} } = exercise.spread ?? {};
  const truths = exercise.kinds.flatMap((kind, i) =>
    classes
      .filter((one) => !without[kind]?.includes(one))
      .flatMap((one) => [1, 2, 3].map((k) => pose(exercise, kind, 5 * i + k, 3, [one]).truth)),
  );
  const right = (id: string) => [...new Set(truths.map((truth) => truth[id]))].sort();
  expect(right('line')).toEqual(['A', 'C', 'D', 'nowhere', 't']);
  expect(right('cure')).toEqual(['compensated', 'moment', 'stable', 'textbook']);
  for (const { line, cure } of truths) expect(line === 'nowhere').toBe(cure === 'textbook');
});

test('an empty box says that there is no root, once the rest is answered', () => {
  const linear = EXERCISES.find(({ id }) => id === 'linear');
  const posed = Array.from(
    { length: 20 },
    (_, i) => linear && pose(linear, (['cone', 'cylinder'] as const)[i % 2] ?? 'cone', i, 2),
  );
  const truths = new Set<unknown>();
  for (const one of posed) {
    if (!one) throw new RangeError('linear');
    const { case: verdict, t1 } = one.truth;
    truths.add(t1 === undefined);
    // Whether the box is needed is told neither by the form nor by its absence from an answer.
    expect(one.fields.map(({ id }) => id)).toEqual(['case', 't1']);
    const judged = judge(derivationFor(one), { case: String(verdict), t1: '' });
    expect(judged.verdict).toBe(t1 === undefined ? 'correct' : 'wrong');
    expect(judge(derivationFor(one), {}).verdict).toBe('invalid');
  }
  expect(truths.size).toBe(2);
});

describe('a session', () => {
  test.each([1, 2, 41, 1000])('of seed %i has every shape and rises', (seed) => {
    const slots = plan(seed);
    const { shapes, turns } = setOf(FIRST_SET);
    expect(new Set(slots.map(({ kind }) => kind))).toEqual(new Set(shapes));
    const levels = slots.map(({ level }) => level);
    expect(levels).toEqual([...levels].sort());
    expect(new Set(slots.map(({ exercise }) => exercise))).toEqual(
      new Set(turns.map(({ exercise }) => exercise)),
    );
  });

  test('is the same for the same seed, and another for another', () => {
    const of = (seed: number) => plan(seed).map((_, i) => JSON.stringify(question(seed, i).draft));
    const [a, again, b] = [41, 41, 42].map(of) as [string[], string[], string[]];
    expect(again).toEqual(a);
    expect(a.filter((draft, i) => draft === b[i])).toEqual([]);
  });
});

const drawn = (id: string): Draft[] => {
  const exercise = EXERCISES.find((one) => one.id === id);
  return Array.from({ length: SEEDS }, (_, i) => {
    const kind = exercise?.kinds[i % exercise.kinds.length];
    if (!exercise || !kind) throw new RangeError(id);
    return pose(exercise, kind, i + 1, 2).draft;
  });
};

test('heights that cut both roots off leave something of the shape', () => {
  for (const { shape, between } of drawn('cut')) {
    if (!between) throw new RangeError('cut');
    const stage = stageAround(shape, endPoints(shape, between));
    const { patches } = cutDrawing(
      definitionOf(shape).draw(shape, stage),
      shape,
      stage,
      between,
      false,
    );
    expect(patches.length, JSON.stringify([shape, between])).toBeGreaterThan(0);
  }
});

test('what is read off a graph lies on its lines', () => {
  for (const draft of drawn('graph')) {
    const turn = turnOf(draft);
    const half = (stepOf(turn) ?? Number.NaN) / 2;
    expect([turn.F / half, turn.G / half].every(Number.isInteger), JSON.stringify(turn)).toBe(true);
  }
});

describe('which method', () => {
  const exercise = EXERCISES.find(({ id }) => id === 'method');
  const posed = Array.from({ length: 24 }, (_, i) => {
    const kind = exercise?.kinds[i % exercise.kinds.length];
    if (!exercise || !kind) throw new RangeError('method');
    return pose(exercise, kind, 31 * i + 1, 3);
  });

  test('is the one with the fewest operations that keeps 13 digits on both rays', () => {
    for (const { draft, truth, exercise: own } of posed) {
      const says = own.told?.(draft).at(-1)?.says ?? '';
      const prices = new Map(
        says.split(', ').map((one) => {
          const [id = '', price] = one.split(' ');
          return [id, Number(price)] as const;
        }),
      );
      const does = [...prices].filter(([id]) =>
        [draft, ...(draft.more ?? [])].every(({ shape, ray }) => {
          const right = intersect(shape, ray, 'exact').hits;
          const { hits } = intersect(shape, ray, id);
          return (
            hits.length === right.length &&
            hits.every(({ t }, i) => digitsRight(t, right[i]?.t ?? Number.NaN) >= 13)
          );
        }),
      );
      const least = Math.min(...does.map(([, price]) => price));
      expect(does.find(([, price]) => price === least)?.[0]).toBe(truth.method);
    }
  });

  test('an operation on pairs takes as many on doubles as it is counted for', () => {
    let count = 0;
    const counted =
      (f: (...x: number[]) => number) =>
      (...x: number[]): number => {
        count++;
        return f(...x);
      };
    const { add, sub, mul, div, sqrt } = doubles;
    const pairs = doubleDoubleOver({
      ...doubles,
      ...{ add: counted(add), sub: counted(sub), mul: counted(mul), div: counted(div) },
      sqrt: counted(sqrt),
    });
    const [a, b] = [pairs.of(3), pairs.of(7)];
    const of = (f: () => unknown): number => {
      count = 0;
      f();
      return count;
    };
    expect({
      add: of(() => pairs.add(a, b)),
      sub: of(() => pairs.sub(a, b)),
      mul: of(() => pairs.mul(a, b)),
      div: of(() => pairs.div(a, b)),
      sqr: of(() => pairs.sqr(a)),
      sqrt: of(() => pairs.sqrt(a)),
    }).toEqual(OF_PAIRS);
  });
});
