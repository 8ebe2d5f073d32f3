import { question } from '../../src/check/session.ts';
import { batchesOf } from '../../src/lab/plan.ts';
import { qualityOf } from '../../src/lab/quality.ts';
import { findFamily } from '../../src/math/families.ts';
import type { Shape } from '../../src/math/index.ts';
import { METHODS } from '../../src/math/methods/index.ts';
import { kindsFor } from '../../src/pages/check/program-run.ts';
import { settingsOf } from '../../src/pages/check/settings.ts';
import { INITIAL_ACCURACY, readAccuracy } from '../../src/state/accuracy/settings.ts';
import { createDerive } from '../../src/state/derive.ts';
import { pictureSettings } from '../../src/state/picture/settings.ts';
import { type AppState, shapeOf } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';
import { prepareTracer } from '../../src/tracer/prepare.ts';
import { DEFAULT_SETTINGS } from '../../src/tracer/types.ts';

/*
 * What a link means, in numbers and ids and without words: words may become better, a meaning
 * stays.
 */

type Facts = Readonly<Record<string, unknown>>;

const whole = (x: unknown): unknown =>
  JSON.parse(
    // JSON has no −0, no infinity and no NaN.
    JSON.stringify(x, (_, value) =>
      typeof value === 'number' && (!Number.isFinite(value) || Object.is(value, -0))
        ? String(Object.is(value, -0) ? '-0' : value)
        : value,
    ),
  );

function exploreFacts(state: AppState): Facts {
  const { found } = createDerive()(state);
  const { details } = found;
  return {
    shape: shapeOf(state),
    ...{ E: state.E, d: state.d, unit: state.unit, method: state.method, view: state.view },
    t: state.bead,
    class: found.class,
    hits: found.hits.map(({ t, point, normal, singular }) => ({ t, point, normal, singular })),
    ...(details.family === 'curved'
      ? { A: details.A, B: details.B, C: details.C, D: details.D }
      : { rate: details.rate, offset: details.offset, plane: details.plane?.t ?? null }),
  };
}

/** The settings, and the first rays that they stand for with what two methods make of them. */
function accuracyFacts({ settings }: AppState): Facts {
  // What links have told since is at its default in a link of before.
  const { target, order, atlas, zoom, by, at, maps, start, ...values } = readAccuracy(
    settings.accuracy,
  ).values;
  const since = { target, order, atlas, zoom, by, at, maps, start };
  if (Object.entries(since).some(([key, value]) => value !== INITIAL_ACCURACY[key as 'zoom'])) {
    return {};
  }
  const family = findFamily(values.family);
  if (!family) return values as unknown as Facts;
  const sample = { seed: values.seed, shapes: 2, count: 25, difficulty: values.dial ?? undefined };
  const batches = batchesOf(family, sample);
  const judged = (id: string): unknown => {
    const method = METHODS.find((one) => one.id === id);
    return method && qualityOf(method, batches).judged;
  };
  return {
    ...values,
    shapes: batches.map(({ shape }) => shape),
    first: batches.map(({ rays: { Ex, Ey, Ez, dx, dy, dz } }) =>
      [Ex, Ey, Ez, dx, dy, dz].map((part) => part[0]),
    ),
    verdicts: batches.map(({ verdicts }) => verdicts.join(' ')),
    ...{ textbook: judged('textbook'), certified: judged('certified') },
  };
}

const [COLUMNS, ROWS] = [16, 9];

/** A sphere as the hyperboloid with a = −1 that it is: so did scenes before there were spheres. */
const surface = (shape: Shape): Shape =>
  shape.kind === 'sphere'
    ? { kind: 'hyperboloid', center: shape.center, flare: -1, radius: shape.radius }
    : shape;

/** The settings, the scene, and what camera rays on a coarse grid hit at which t. */
async function pictureFacts(state: AppState): Promise<Facts> {
  const { scene, sceneText: _, ...all } = pictureSettings(state.settings.picture);
  // Settings that these links cannot name have their defaults, which change nothing.
  const { bounces, grows, budget, along } = pictureSettings({});
  const later: Facts = { bounces, grows, budget, along };
  const settings = Object.fromEntries(
    Object.entries(all).filter(([key, value]) => !(key in later) || later[key] !== value),
  );
  const { method } = state;
  const size = { width: COLUMNS, height: ROWS, samples: 1 };
  const tracer = await prepareTracer(scene, { ...DEFAULT_SETTINGS, ...size, method }, () => 0);
  const hits = Array.from({ length: ROWS }, (_row, y) =>
    Array.from({ length: COLUMNS }, (_pixel, x) => {
      const end = tracer.record(x, y).rays[0]?.end;
      return end?.end === 'hit' ? `${end.surface} ${end.t.toPrecision(12)}` : '-';
    }).join(' | '),
  );
  const things = scene.things.map(({ id, shape }) => `${id}: ${JSON.stringify(surface(shape))}`);
  return { ...settings, method, things, hits };
}

function checkFacts({ settings }: AppState): Facts {
  const read = settingsOf(settings.check);
  const { seed, part, cases } = read;
  const { exercise, draft, given, truth } = question(seed, read.question, read.set);
  const { shape, ray, param } = draft;
  return {
    ...{ part, seed, question: read.question, cases: kindsFor(cases, read.set) },
    ...{ exercise: exercise.id, shape, ray, param },
    // Without names: the t of flat shapes was called so, and is called t1.
    ...{ given: Object.values(given), truth: Object.values(truth) },
  };
}

/** What the page of this link shows. */
export async function factsOf(link: string): Promise<unknown> {
  const state = decode(link);
  const facts = {
    explore: exploreFacts,
    accuracy: accuracyFacts,
    picture: pictureFacts,
    check: checkFacts,
  }[state.page as 'explore' | 'accuracy' | 'picture' | 'check'];
  return whole({ page: state.page, problems: state.problems, ...(await facts(state)) });
}
