import { matches } from '../../../src/check/grade.ts';
import { question } from '../../../src/check/session.ts';
import { FIRST_SET } from '../../../src/check/sets.ts';
import { type MeasuredRow, measureSession } from '../../../src/lab/session.ts';
import { type SweepPoint, sweepSession } from '../../../src/lab/sweep.ts';
import type { Lesson } from '../../../src/lesson/lesson.ts';
import { innerState } from '../../../src/lesson/step-state.ts';
import { intersect } from '../../../src/math/index.ts';
import { measureRequest, sweepRequest } from '../../../src/pages/accuracy/requests.ts';
import { planEffects } from '../../../src/scene/effects/plan.ts';
import { readAccuracy } from '../../../src/state/accuracy/settings.ts';
import { type PictureSettings, pictureSettings } from '../../../src/state/picture/settings.ts';
import { type AppState, rayOf, shapeOf } from '../../../src/state/state.ts';
import type { RayKind, TileResult } from '../../../src/tracer/types.ts';
import { curvedDetails } from '../math/shorthand.ts';
import { picture } from '../tracer/tracing.ts';
import { holdsOnMaps } from './map-claims.ts';

/** What a step shows on a page, in its lesson. */
interface Shown {
  readonly state: AppState;
  readonly lesson: Lesson;
}

type Check = (shown: Shown, ...parts: string[]) => boolean | Promise<boolean>;

const traced = new Map<string, Promise<TileResult>>();
/** The picture of a step, with other effects forced than its link says. */
function trace({ state }: Shown, forced?: PictureSettings['forced']): Promise<TileResult> {
  const { scene, sceneText, width, height, samples, lightSamples, start, ...own } =
    pictureOf(state);
  const settings = { width, height, samples, lightSamples, start, method: state.method };
  const all = { ...settings, forced: forced ?? own.forced };
  const key = JSON.stringify([sceneText, all]);
  const found = traced.get(key) ?? picture(scene, all);
  traced.set(key, found);
  return found;
}
const pictureOf = ({ settings }: AppState): PictureSettings => pictureSettings(settings.picture);
const planOf = ({ state }: Shown) => planEffects(pictureOf(state).scene, pictureOf(state).forced);
const rowOf = (shown: Shown, id: string) => planOf(shown).find((one) => one.id === id);
const kindsOf = async (shown: Shown) => {
  const { camera, shadow, reflected, refracted } = (await trace(shown)).ledger.kinds;
  return {
    camera: camera.rays,
    shadow: shadow.rays,
    reflected: reflected.rays,
    refracted: refracted.rays,
  };
};
const raysOf = async (shown: Shown, id: string, forced?: PictureSettings['forced']) =>
  (await trace(shown, forced)).ledger.effects[id as 'shadow']?.rays ?? 0;
/** Forced off if it runs; as the scene calls for it if it is forced off. */
const otherwise = (shown: Shown, id: string): PictureSettings['forced'] => {
  const { forced } = pictureOf(shown.state);
  const { [id as 'shadow']: how, ...rest } = forced;
  return how === 'off' ? rest : { ...rest, [id]: 'off' };
};
const sameBytes = (a: TileResult, b: TileResult): boolean =>
  a.rgba.every((x, i) => x === b.rgba[i]);
const hitsOf = async (shown: Shown): Promise<number> =>
  (await trace(shown)).surface.filter((surface) => surface >= 0).length;

const PICTURE: readonly (readonly [RegExp, Check])[] = [
  [/^(\d) things?$/, ({ state }, n) => pictureOf(state).scene.things.length === Number(n)],
  [/^(\d) lights?$/, ({ state }, n) => pictureOf(state).scene.lights.length === Number(n)],
  [
    /^lamp at a point$/,
    ({ state }) => pictureOf(state).scene.lights.every(({ light }) => light === 'point'),
  ],
  [
    /^(\d+) × (\d+) pixels$/,
    ({ state }, width, height) => {
      const { width: w, height: h, samples } = pictureOf(state);
      return w === Number(width) && h === Number(height) && samples === 1;
    },
  ],
  [/^camera rays = (\d+)$/, async (s, n) => (await kindsOf(s)).camera === Number(n)],
  [
    /^rays: (.+)$/,
    async (s, list = '') => {
      const fired = Object.entries(await kindsOf(s)).flatMap(([kind, n]) => (n > 0 ? [kind] : []));
      return fired.join(' and ') === list;
    },
  ],
  [/^no ([\w-]+) needed$/, (s, id = '') => rowOf(s, id)?.needed === false],
  [/^everything needed$/, (s) => planOf(s).every(({ needed, runs }) => needed && runs)],
  [/^nothing simulated$/, (s) => planOf(s).every(({ runs }) => !runs)],
  [/^each has a reason$/, (s) => planOf(s).every(({ reason }) => reason.length > 0)],
  [
    /^([\w-]+) (not needed|needed|forced on|forced off)$/,
    (s, id = '', how = '') => {
      const row = rowOf(s, id);
      return how.startsWith('forced')
        ? `forced ${row?.forced}` === how
        : row?.needed === (how === 'needed');
    },
  ],
  [/^no ([\w-]+) rays$/, async (s, id = '') => (await raysOf(s, id)) === 0],
  [/^([\w-]+) rays fired$/, async (s, id = '') => (await raysOf(s, id)) > 0],
  [
    /^fewer (\w+) rays than (\w+) rays$/,
    async (s, a, b) => (await kindsOf(s))[a as RayKind] < (await kindsOf(s))[b as RayKind],
  ],
  [/^some rays meet nothing$/, async (s) => (await hitsOf(s)) < (await kindsOf(s)).camera],
  [/^fewer shadow rays than hits$/, async (s) => (await kindsOf(s)).shadow < (await hitsOf(s))],
  [
    /^(?:with|without) ([\w-]+): (the same|another) picture$/,
    async (s, id = '', which) =>
      sameBytes(await trace(s), await trace(s, otherwise(s, id))) === (which === 'the same'),
  ],
  [
    /^without ([\w-]+): fewer ([\w-]+) rays$/,
    async (s, id = '', of = '') => (await raysOf(s, of, otherwise(s, id))) < (await raysOf(s, of)),
  ],
  [
    /^most other rays are soft shadow rays$/,
    async (s) => {
      const { camera, ...others } = await kindsOf(s);
      const sum = Object.values(others).reduce((a, b) => a + b, 0);
      return 2 * (await raysOf(s, 'soft-shadow')) > sum;
    },
  ],
  [
    /^(\d+) rays to a light with a size$/,
    ({ state }, n) => pictureOf(state).lightSamples === Number(n),
  ],
];

const ticking = () => {
  let now = 0;
  return () => {
    now += 10;
    return now;
  };
};
const known = new Map<string, unknown>();
const once = <T>(key: string, make: () => T): T => {
  const found = known.has(key) ? (known.get(key) as T) : make();
  known.set(key, found);
  return found;
};
const accuracyOf = ({ state }: Shown) => readAccuracy(state.settings.accuracy).values;
/** The page's own rays, counted as it counts them. */
const counted = (shown: Shown): readonly MeasuredRow[] => {
  const request = measureRequest(accuracyOf(shown), false);
  return once(JSON.stringify(request), () => {
    const first = measureSession(request, ticking()).next().value;
    return first ? first.columns.typescript : [];
  });
};
const measured = (shown: Shown): readonly MeasuredRow[] => {
  const few = { shapes: 1, count: 16, timed: 16, budget: { least: 16, most: 1e9 } };
  const plan = { rounds: 2, least: 10, steps: 1, warmUp: 0 };
  const request = { ...measureRequest(accuracyOf(shown), false), ...few, plan };
  return once(JSON.stringify(request), () => {
    const all = [...measureSession(request, ticking())];
    return all.at(-1)?.columns.typescript ?? [];
  });
};
/** The page's sweep of fewer rays. */
const swept = (shown: Shown): readonly SweepPoint[] => {
  const request = { ...sweepRequest(accuracyOf(shown)), count: 32 };
  return once(JSON.stringify(request), () => [...sweepSession(request)]);
};
const digitsOf = (shown: Shown, id: string): number[] =>
  swept(shown).map(({ rows }) => rows.find((row) => row.id === id)?.quality.digits ?? Number.NaN);

const ACCURACY: readonly (readonly [RegExp, Check])[] = [
  [/^doubles have about 16 digits$/, () => Math.round(53 * Math.log10(2)) === 16],
  [/^swept by distance$/, (s) => accuracyOf(s).hard === 'far-origin' && swept(s).length > 9],
  [
    /^(\w+) loses a digit a step$/,
    (s, id = '') => {
      const digits = digitsOf(s, id).filter((n) => n > 0);
      const [first = 0, last = 0] = [digits[0], digits.at(-1)];
      const dials = swept(s).map(({ difficulty }) => difficulty);
      const isByTen = dials.every((x, i) => i === 0 || x - (dials[i - 1] ?? 0) === 1);
      const a = (first - last) / (digits.length - 1);
      return isByTen && a > 0.8 && a < 1.2 && digits.every((x, i) => x <= (digits[i - 1] ?? 99));
    },
  ],
  [/^(\w+) ends without digits$/, (s, id = '') => digitsOf(s, id).at(-1) === 0],
  [/^(\w+) keeps its digits$/, (s, id = '') => digitsOf(s, id).every((n) => n > 15.9)],
  [
    /^(\w+) wrong on some$/,
    (s, id) => (counted(s).find((row) => row.id === id)?.quality.wrong ?? 0) > 0,
  ],
  [
    /^(\w+) right on all$/,
    (s, id) => {
      const { wrong, undecided, mostUlps } = counted(s).find((row) => row.id === id)?.quality ?? {};
      return wrong === 0 && undecided === 0 && mostUlps === 0;
    },
  ],
  [/^(\w+) has a price$/, (s, id) => measured(s).some((row) => row.id === id && row.roots)],
];

const posed = ({ state }: Shown) => {
  const { seed = '1', question: number = '1', set = FIRST_SET } = state.settings.check;
  return question(Number(seed), Number(number) - 1, set);
};

const CHECK: readonly (readonly [RegExp, Check])[] = [
  [
    /^a question about (\w+) of a (\w+)$/,
    (s, id, kind) => posed(s).exercise.id === id && posed(s).draft.shape.kind === kind,
  ],
  [
    /^the question's A = 0$/,
    (s) => {
      const { shape, ray } = posed(s).draft;
      return curvedDetails(intersect(shape, ray)).A === 0;
    },
  ],
  [
    /^any length of (\w+)$/,
    (s, id) => {
      const field = posed(s).fields.find((one) => one.id === id);
      return (
        field !== undefined &&
        matches(field, [2, 4, 6], [1, 2, 3]) &&
        !matches(field, [-1, -2, -3], [1, 2, 3])
      );
    },
  ],
  [
    /^the ray of step (\d+)$/,
    ({ state, lesson }, n) => {
      const step = lesson.steps[Number(n) - 1];
      if (!step) return false;
      const before = innerState(step, {});
      const both = [before, state].map((one) => JSON.stringify([shapeOf(one), rayOf(one)]));
      return both[0] === both[1];
    },
  ],
];

const ALL = [...PICTURE, ...ACCURACY, ...CHECK];

/** What a page other than Explore shows; null where the claim is none of those. */
export async function holdsOnPage(claim: string, shown: Shown): Promise<boolean | null> {
  if (shown.state.page === 'explore') return null;
  for (const [pattern, check] of ALL) {
    const match = claim.match(pattern);
    if (match) return check(shown, ...match.slice(1));
  }
  return shown.state.page === 'accuracy' ? holdsOnMaps(claim, shown.state) : null;
}
