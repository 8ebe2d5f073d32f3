import { describe, expect, test } from 'vitest';
import { priceText } from '../../../src/lab/sentence.ts';
import { measureSession } from '../../../src/lab/session.ts';
import { sweepSession } from '../../../src/lab/sweep.ts';
import { findFamily } from '../../../src/math/families.ts';
import { METHODS } from '../../../src/math/methods/index.ts';
import { SHAPES } from '../../../src/math/shapes/index.ts';
import { changeWords } from '../../../src/state/accuracy/change-words.ts';
import { frontierOf } from '../../../src/state/accuracy/frontier.ts';
import { hardnessOf, tickOf } from '../../../src/state/accuracy/hardness.ts';
import { createRayModel } from '../../../src/state/accuracy/ladder.ts';
import {
  ACCURACY_KEYS,
  type AccuracySettings,
  INITIAL_ACCURACY,
  readAccuracy,
  writeAccuracy,
} from '../../../src/state/accuracy/settings.ts';
import { INITIAL, type Settings } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';
import { isFloat32 } from '../math/shorthand.ts';

const PLAN = { rounds: 2, least: 10, steps: 1, warmUp: 0 };
const ticking = () => {
  let now = 0;
  return () => {
    now += 10;
    return now;
  };
};
const RAYS = { seed: 7, shapes: 2, count: 64, timed: 64, order: 'random' as const };
const BUDGET = { least: 64, most: 1e9 };
const measured = (family: string) => ({
  rows:
    [...measureSession({ family, ...RAYS, budget: BUDGET, plan: PLAN }, ticking())].at(-1)?.columns
      .typescript ?? [],
  target: 'typescript' as const,
  isFaint: false,
});

describe('the frontier', () => {
  const rows = measured('far-origin');

  test('has a mark a method, with the numbers of the rows', () => {
    const data = frontierOf(rows, { worth: 'digits', cost: 'ns' }, 'exact');
    expect(data?.marks.map(({ id }) => id)).toEqual(rows.rows.map(({ id }) => id));
    for (const row of rows.rows) {
      const mark = data?.marks.find(({ id }) => id === row.id);
      expect(mark?.cost).toEqual(row.roots?.times);
      expect(mark?.worth).toBe(row.quality.digits);
      expect(mark?.words).toContain(
        row.roots ? `${priceText(row.roots.times)} times textbook` : '-',
      );
    }
    const textbook = rows.rows.find(({ id }) => id === 'textbook');
    expect(data?.unit).toBe(textbook?.roots?.ns.value);
    expect(data?.gridByUnit).toBe(true);
    expect(frontierOf(rows, { worth: 'digits', cost: 'times' }, 'exact')?.gridByUnit).toBe(false);
  });

  test('sets apart what is emulated, in TypeScript only', () => {
    const apart = (target: 'simd' | 'typescript') =>
      frontierOf({ ...rows, target }, { worth: 'digits', cost: 'ns' }, 'exact')
        ?.marks.filter(({ isApart }) => isApart)
        .map(({ id, note }) => [id, note.startsWith(', emulated')]);
    const emulated = rows.rows.filter(({ id }) => isFloat32(id));
    expect(apart('typescript')).toEqual(emulated.map(({ id }) => [id, true]));
    expect(apart('simd')).toEqual([]);
  });

  test('knows no times where prices are another machine’s', () => {
    const data = frontierOf({ ...rows, isFaint: true }, { worth: 'digits', cost: 'ns' }, 'exact');
    expect([data?.unit, data?.gridByUnit]).toEqual([null, false]);
    for (const { words } of data?.marks ?? []) {
      expect(words).toContain('for typical rays where this page was built');
      expect(words).not.toContain(' ns ');
    }
  });

  test('puts no failure on top, and its ticks reach the worst', () => {
    const data = frontierOf(rows, { worth: 'wrong', cost: 'ns' }, 'exact');
    expect(data?.marks.find(({ id }) => id === 'exact')?.worth).toBe(0);
    const lowest = Math.min(...(data?.worthTicks ?? []).map(({ value }) => value));
    expect(lowest).toBeLessThanOrEqual(Math.min(...(data?.marks ?? []).map(({ worth }) => worth)));
    expect(data?.worthTicks[0]?.label).toBe('0 %');
  });

  test('is not there before there is a time', () => {
    const untimed = { ...rows, rows: rows.rows.map(({ id, quality }) => ({ id, quality })) };
    expect(frontierOf(untimed, { worth: 'digits', cost: 'ns' }, 'exact')).toBeNull();
  });
});

describe('how hard', () => {
  test.each([
    ['far-origin', 4, '10⁴'],
    ['near-tangent', 4, '10⁻⁴'],
    ['near-generator', 3, '2³'],
    ['mix', 40, '40'],
    ['scale-world', 0, '1'],
  ])('%s: %d is written %s', (id, k, text) => {
    const dial = findFamily(id)?.dial;
    expect(dial && tickOf(dial)(k)).toBe(text);
  });

  test('lines carry the sweep’s numbers and say in words what fails', () => {
    const points = [
      ...sweepSession({ family: 'far-origin', seed: 7, shapes: 2, count: 64, points: 13 }),
    ];
    const dial = findFamily('far-origin')?.dial;
    if (!dial) throw new Error('a dial was expected');
    const { lines, dialTitle } = hardnessOf(points, dial, 'digits');
    expect(dialTitle).toBe('E is 10ᵏ radii away');
    const textbook = lines.find(({ id }) => id === 'textbook');
    expect(textbook?.end?.reason).toBe('loses hits');
    expect(textbook?.end?.words).toMatch(/of 128 rays \d+ lose a hit/);
    expect(textbook?.points[0]?.digits).toBe(
      points[0]?.rows.find(({ id }) => id === 'textbook')?.quality.digits,
    );
    expect(lines.find(({ id }) => id === 'certified')?.end).toBeUndefined();
  });
});

describe('the ray', () => {
  const model = createRayModel();

  test.each(SHAPES.map(({ kind }) => kind))('%s: a row for each method, and words', (kind) => {
    const { rows, where, words, losses } = model({ ...INITIAL, kind });
    expect(rows.map(({ method }) => method)).toEqual(METHODS);
    expect([...where.values()].every((text) => text.length > 3)).toBe(true);
    expect(words).toMatch(/^The [\w ]+ of Explore, with E [\d.]+ away\. /);
    expect(losses.steps.length).toBeGreaterThan(3);
  });

  test.each([
    ['#/explore?shape=cylinder&E=2,0,0&d=0,1,0&C=0,0,0&r=2', 'The whole line lies in it'],
    ['#/explore?shape=cone&E=-3,1.5,0&d=2,1,0&V=0,3,0&c=2', 'The whole line lies in it'],
    ['#/explore?shape=cylinder&E=2,0,-5&d=0,0,1&C=0,0,0&r=2', 'It touches in exactly one point'],
    ['#/explore?shape=cylinder&E=9,0,0&d=0,1,0&C=0,0,0&r=2', 'no point of it'],
    ['#/explore?shape=plane&E=0,5,0&d=1,0,0&N=0,1,0&P=0,0,0', 'no point of it'],
    ['#/explore?shape=circle&E=0,0,0&d=1,0,0&N=0,1,0&C=0,0,0&r=1', 'The whole line lies in it'],
    ['#/explore?shape=cone&E=0,3,-5&d=0,0,1&V=0,3,0&c=0.5', 'It touches in exactly one point'],
  ])('%s', (link, words) => {
    expect(model(decode(link, INITIAL)).words).toContain(words);
  });

  test('keeps its answer while nothing of it changes', () => {
    const first = model(INITIAL);
    expect(model({ ...INITIAL, view: 'top' })).toBe(first);
    expect(model({ ...INITIAL, method: 'moment' })).not.toBe(first);
  });
});

describe('the settings of a link', () => {
  const all: AccuracySettings = {
    family: 'mix',
    dial: 20,
    worth: 'wrong',
    cost: 'times',
    target: 'typescript',
    order: 'sorted',
    hard: 'near-axis',
    seed: 99,
    atlas: 'E.z,r',
    zoom: 12.5,
    by: 'ulps',
    at: '1,0.5',
    maps: 'own,certified',
    start: 'none,1e-9',
  };

  test('come back from their texts, and defaults leave none', () => {
    expect(readAccuracy(writeAccuracy(all) as Settings)).toEqual({ values: all, problems: [] });
    expect(writeAccuracy(INITIAL_ACCURACY)).toEqual({
      family: null,
      dial: null,
      worth: null,
      cost: null,
      target: null,
      order: null,
      hard: null,
      seed: null,
      atlas: null,
      zoom: null,
      by: null,
      at: null,
      maps: null,
      start: null,
    });
    expect(readAccuracy({}).values).toEqual(INITIAL_ACCURACY);
  });

  test.each([
    ['family', 'nowhere'],
    ['dial', 'abc'],
    ['dial', ''],
    ['dial', 'Infinity'],
    ['worth', 'best'],
    ['cost', 'euros'],
    ['target', 'gpu'],
    ['order', 'up'],
    ['hard', 'typical'],
    ['seed', '-1'],
    ['seed', '1e3'],
    ['atlas', 'E.z'],
    ['atlas', 'r,r'],
    ['atlas', 'E.q,r'],
    ['zoom', '99'],
    ['zoom', 'in'],
    ['by', 'miles'],
    ['at', '1'],
    ['at', '1,x'],
    ['maps', 'newton'],
    ['maps', 'own,own,own'],
    ['start', 'somewhere'],
    ['start', '-1'],
  ])('%s=%s is said to be none, and has its default', (key, text) => {
    const { values, problems } = readAccuracy({ [key]: text });
    expect(values).toEqual(INITIAL_ACCURACY);
    expect(problems).toHaveLength(1);
    expect(problems[0]).toContain(`'${text}'`);
  });

  test.each(ACCURACY_KEYS)('what %s should be is said', (key) => {
    const [problem] = readAccuracy({ [key]: '?' }).problems;
    expect(problem).toMatch(/^opened without \w+: '\?' is not (an? |two |\w+ or )/);
  });

  test('a dial stops at its ends, and a family without one has none', () => {
    expect(readAccuracy({ family: 'mix', dial: '900' }).values.dial).toBe(100);
    expect(readAccuracy({ family: 'far-origin', dial: '-4' }).values.dial).toBe(0);
    expect(readAccuracy({ family: 'typical', dial: '3' }).values.dial).toBeNull();
  });
});

describe('what another ray changes', () => {
  const model = createRayModel();
  const at = (x: string) =>
    model(
      decode(`#/accuracy?shape=cylinder&E=${x},0,-5&d=0,0,1&C=0,0,0&r=2&method=exact`, INITIAL),
    );

  test('verdicts, with what each is worth', () => {
    const words = changeWords(at('2'), at('2+2^-51'), 'exact');
    expect(words).toContain('exact: touches once → no point (right)');
    expect(words).not.toContain('textbook, float32');
  });

  test('else the roots of the chosen method, before and after', () => {
    const words = changeWords(at('1'), at('1.5'), 'exact');
    expect(words).toMatch(
      /^no verdict changes; exact: t₁ = 3\.26\d+ → 3\.67\d+ \(16 → 16 digits\)/,
    );
    expect(changeWords(at('1'), at('1'), 'exact')).toBe(
      'no verdict changes; exact: t₁ stays, t₂ stays',
    );
    expect(changeWords(at('3'), at('4'), 'exact')).toBe('no verdict changes');
  });
});
