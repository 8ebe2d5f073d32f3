import { describe, expect, test } from 'vitest';
import { remove } from '../../../../src/scene/edit.ts';
import { EFFECTS } from '../../../../src/scene/effects/index.ts';
import { findPreset, PRESETS } from '../../../../src/scene/presets/index.ts';
import type { Scene } from '../../../../src/scene/types.ts';
import {
  EMPTY_LEDGER,
  grouped,
  ledgerCsv,
  ledgerModel,
  MEASURES,
  msWords,
  percent,
} from '../../../../src/state/picture/ledger.ts';
import { LEAST_REPEATS, type Repeat, timesOf } from '../../../../src/state/picture/times.ts';
import { comparePictures } from '../../../../src/tracer/compare.ts';
import { DEFAULT_SETTINGS, type Ledger } from '../../../../src/tracer/types.ts';
import { picture } from '../../tracer/tracing.ts';

function scene(id: string): Scene {
  const preset = findPreset(id);
  if (!preset) throw new Error(`no preset ${id}`);
  return preset.scene;
}

const LEDGER: Ledger = {
  camera: { rays: 100, questions: 500, solves: 50, roots: 40, ms: 2 },
  effects: {
    shadow: { rays: 60, questions: 90, solves: 5, roots: 3, ms: 1 },
    reflection: { rays: 30, questions: 60, solves: 7, roots: 6, ms: 5 },
  },
  kinds: {
    camera: { rays: 100, questions: 500, roots: 40 },
    shadow: { rays: 60, questions: 90, roots: 3 },
    reflected: { rays: 30, questions: 60, roots: 6 },
    refracted: { rays: 0, questions: 0, roots: 0 },
  },
  fired: { shadow: { shadow: 60 }, reflection: { reflected: 30 } },
  saved: 3,
  cut: 1,
};

const TIMES = timesOf(Array.from({ length: 5 }, () => ({ ledger: LEDGER, waited: 6, workers: 2 })));

describe('times of repeats', () => {
  const run = (ms: number, waited: number, workers = 2): Repeat => ({
    ledger: {
      ...LEDGER,
      camera: { ...LEDGER.camera, ms },
      effects: { shadow: { ...LEDGER.camera, ms: 2 * ms } },
    },
    waited,
    workers,
  });

  test('are not told before there are enough', () => {
    const some = Array.from({ length: LEAST_REPEATS }, (_, k) => run(1 + k, 10 + k));
    expect(timesOf(some.slice(1))).toBeNull();
    expect(timesOf(some)?.repeats).toBe(LEAST_REPEATS);
  });

  test('quartiles leave out what another program took; a wide middle half is told', () => {
    const times = timesOf([
      run(1, 10),
      run(1, 10),
      run(1, 10),
      run(1, 10),
      run(1, 10),
      run(90, 99),
    ]);
    expect(times).toMatchObject({
      of: { camera: { low: 1, high: 1 }, shadow: { low: 2, high: 2 } },
      work: { low: 3, high: 3 },
      waited: { low: 10, high: 10 },
      busy: false,
    });
    const busy = timesOf([10, 10, 12, 15, 20, 30].map((waited) => run(1, waited)));
    expect(busy?.busy).toBe(true);
    expect(busy?.spread).toBeCloseTo(18.75 / 10.5 - 1, 12);
  });

  test.each([1, 2, 8])('work of %d workers, divided, and the rest are the wait', (workers) => {
    const waits = [31, 30, 47, 33, 36, 34, 90];
    const typical = timesOf(waits.map((waited, k) => run(k + 1, waited, workers)))?.typical;
    if (!typical) throw new Error('no times');
    expect(waits).toContain(typical.waited);
    expect(typical.work / typical.workers + typical.rest).toBeCloseTo(typical.waited, 12);
    expect(typical.rest).toBeGreaterThan(0);
  });
});

describe('the ledger', () => {
  const model = ledgerModel(scene('mirror'), DEFAULT_SETTINGS, LEDGER, { reflection: 77 });

  test('has every effect once, with what runs apart from what does not', () => {
    const ids = [...model.simulated, ...model.idle].map(({ id }) => id);
    expect(ids.toSorted()).toEqual(EFFECTS.map(({ id }) => id).toSorted());
    expect(model.simulated.every(({ needed }) => needed)).toBe(true);
    expect(model.idle.every(({ needed, cost }) => !needed && cost === null)).toBe(true);
  });

  test.each(MEASURES)('bars by %s follow each other and fill the whole', (by) => {
    const shown = ledgerModel(scene('mirror'), DEFAULT_SETTINGS, LEDGER, {}, { by, times: TIMES });
    const of = { rays: 190, questions: 650, solves: 62, roots: 49, ms: 8 }[by];
    let end = shown.camera.share;
    expect(shown.camera).toMatchObject({ share: LEDGER.camera[by] / of, from: 0 });
    for (const { from, share } of shown.simulated) {
      expect(from).toBeCloseTo(end, 12);
      end = from + share;
    }
    expect(end).toBeCloseTo(1, 12);
  });

  test('what is not measured has no time, and bars by time are empty', () => {
    const shown = ledgerModel(scene('mirror'), DEFAULT_SETTINGS, LEDGER, {}, { by: 'ms' });
    expect([shown.camera, ...shown.simulated].map(({ share, time }) => [share, time])).toEqual(
      [shown.camera, ...shown.simulated].map(() => [0, null]),
    );
  });

  test('the total is the sum of its rows', () => {
    expect(model.total).toEqual({
      rays: 190,
      questions: 650,
      solves: 62,
      roots: 49,
      ms: 8,
    });
  });

  test.each(EFFECTS)('rays that $id fires, of whatever kind, are told apart from others', (one) => {
    const other = one.id === 'reflection' ? 'refraction' : 'reflection';
    const fired = { [other]: { reflected: 30 }, [one.id]: { reflected: 7 } };
    const { kinds } = ledgerModel(scene('mirror'), DEFAULT_SETTINGS, { ...LEDGER, fired }, {});
    const parts = kinds.find(({ kind }) => kind === 'reflected')?.parts ?? [];
    expect(parts.map(({ rays }) => rays).toSorted((a, b) => a - b)).toEqual([7, 30]);
    expect(new Set(parts.map(({ words }) => words)).size).toBe(2);
  });

  test('a count of pixels stands at its effect', () => {
    const counts = model.simulated.map(({ id, pixels }) => [id, pixels]);
    expect(counts).toContainEqual(['reflection', 77]);
    expect(counts.filter(([, pixels]) => pixels !== null)).toHaveLength(1);
  });

  test('without the mirror there is no reflection, and why', () => {
    const before = scene('cone-on-mirror');
    const ids = (s: Scene) =>
      ledgerModel(s, DEFAULT_SETTINGS, EMPTY_LEDGER, {}).simulated.map(({ id }) => id);
    expect(ids(before)).toContain('reflection');
    const after = ledgerModel(remove(before, 'mirror'), DEFAULT_SETTINGS, EMPTY_LEDGER, {});
    expect(after.idle.find(({ id }) => id === 'reflection')).toMatchObject({
      reason: 'no material is a mirror',
      needed: false,
    });
  });

  test('nothing traced: no shares, no costs, nothing is not a number', () => {
    const empty = ledgerModel(scene('everything'), DEFAULT_SETTINGS, EMPTY_LEDGER, {});
    expect(empty.camera.cost).toBeNull();
    for (const { share, from, cost } of empty.simulated) {
      expect([share, from, cost]).toEqual([0, 0, null]);
    }
  });

  test('forced on it stands among what runs, forced off among what does not', () => {
    const settings = {
      ...DEFAULT_SETTINGS,
      forced: { refraction: 'on', reflection: 'off' },
    } as const;
    const forced = ledgerModel(scene('mirror'), settings, LEDGER, {});
    expect(forced.simulated.find(({ id }) => id === 'refraction')?.forced).toBe('on');
    expect(forced.idle.find(({ id }) => id === 'reflection')?.forced).toBe('off');
  });

  test('as CSV: a line for each, every line as long', () => {
    const shown = ledgerModel(
      scene('mirror'),
      DEFAULT_SETTINGS,
      LEDGER,
      { reflection: 77 },
      { times: TIMES },
    );
    const lines = ledgerCsv(shown).trimEnd().split('\n');
    expect(lines).toHaveLength(EFFECTS.length + 3);
    for (const line of lines) {
      expect(line.replace(/"(?:[^"]|"")*"/g, '').split(',')).toHaveLength(12);
    }
    expect(lines.find((line) => line.startsWith('reflection'))).toMatch(
      /^reflection,true,no,[^",]+,30,60,7,6,5,5,0\.09\d*,77$/,
    );
  });
});

describe.each(PRESETS.map(({ id, scene: of }) => [id, of] as const))('%s', async (_, of) => {
  const { ledger, work } = await picture(of);
  const model = ledgerModel(of, DEFAULT_SETTINGS, ledger, {});

  test('what is shown adds up to what is shown', () => {
    const rows = [model.camera, ...model.simulated].map(({ cost }) => cost);
    for (const key of ['rays', 'questions', 'solves', 'roots'] as const) {
      const sum = rows.reduce((all, cost) => all + (cost?.[key] ?? 0), 0);
      expect([key, sum]).toEqual([key, model.total[key]]);
    }
    for (const key of ['rays', 'questions', 'roots'] as const) {
      const byKind = model.kinds.reduce((all, kind) => all + kind[key], 0);
      expect([key, byKind]).toEqual([key, model.total[key]]);
      const byPixel = work[key].reduce((all, n) => all + n, 0);
      expect([key, byPixel]).toEqual([key, model.total[key]]);
    }
    expect(model.total.roots).toBeLessThanOrEqual(model.total.questions);
    for (const { kind, rays, parts } of model.kinds) {
      const fired = kind === 'camera' ? 0 : rays;
      expect([kind, parts.reduce((all, part) => all + part.rays, 0)]).toEqual([kind, fired]);
    }
  });

  test('a comparison’s other verdicts are holes, ghosts and other surfaces', async () => {
    const right = await picture(of);
    for (const how of [{ method: 'textbook32' }, { start: { rule: 'none' } }] as const) {
      const { verdicts, holes, ghosts, others } = comparePictures(await picture(of, how), right);
      expect(holes + ghosts + others).toBe(verdicts);
    }
  });

  test('what glass and lamps would show is said to be left out, and only that', () => {
    const glass = of.things.some(({ material }) => material.glass);
    const lamps = of.lights.some(({ light }) => light !== 'sun');
    for (const { id, needed, leftOut, reason } of [...model.simulated, ...model.idle]) {
      expect(leftOut && needed).toBe(false);
      expect([id, leftOut]).toEqual([id, /simplification/.test(reason)]);
      if (leftOut) expect(id === 'fall-off' ? lamps : glass).toBe(true);
    }
  });
});

test.each([
  [0, '0'],
  [999, '999'],
  [1000, '1 000'],
  [1491968, '1 491 968'],
])('%d in groups of three', (n, text) => {
  expect(grouped(n).replace(/\u202f/g, ' ')).toBe(text);
});

test.each([
  [0, '0'],
  [0.004, '< 0.01'],
  [0.42, '0.42'],
  [7.43, '7.4'],
  [1005.4, '1 005'],
])('%d ms', (ms, text) => {
  expect(msWords(ms).replace(/\u202f/g, ' ')).toBe(text);
});

test.each([
  [0, 100, '0 %'],
  [1, 1_000_000, '< 0.1 %'],
  [23, 1000, '2.3 %'],
  [999_999, 1_000_000, '> 99.9 %'],
  [5, 5, '100 %'],
  [0, 0, '0 %'],
])('%d of %d is %s', (part, whole, text) => {
  expect(percent(part, whole)).toBe(text);
});
