import { describe, expect, test } from 'vitest';
import { createBudgetSearch } from '../../../../src/pages/picture/budget.ts';
import { createGrowth } from '../../../../src/pages/picture/growth.ts';
import { pictureModel } from '../../../../src/pages/picture/picture-model.ts';
import { createRayRecorder } from '../../../../src/pages/picture/ray-recorder.ts';
import {
  createRefiner,
  EDGE_RAYS,
  EDGES,
  oneAfterAnother,
  type Refined,
} from '../../../../src/pages/picture/refiner.ts';
import { createRepeats } from '../../../../src/pages/picture/repeats.ts';
import {
  type Background,
  coresOf,
  createTraceQueue,
  type TraceQueue,
} from '../../../../src/pages/picture/trace-queue.ts';
import { type TraceRequest, traceRequests } from '../../../../src/pages/picture/trace-request.ts';
import { BUDGET } from '../../../../src/state/picture/budget.ts';
import { pictureSettings } from '../../../../src/state/picture/settings.ts';
import { type AppState, INITIAL, type Settings } from '../../../../src/state/state.ts';
import type { Picture } from '../../../../src/tracer/compare.ts';
import { differencesBeside } from '../../../../src/tracer/edges.ts';
import { totalOf } from '../../../../src/tracer/ledger.ts';
import type { Frame, TraceProgress } from '../../../../src/workers/trace-job.ts';
import { type FakeWorker, fakeWorker } from '../../tracer/fake-worker.ts';

const SMALL: Settings = { size: '32x18', light: '4' };

const requests = (more: Settings = {}, method = 'moment') =>
  traceRequests(pictureSettings({ ...SMALL, ...more }), method);

interface Bench {
  readonly room: TraceQueue;
  readonly hands: FakeWorker[];
  /** Answers what the workers were asked, up to so many messages. */
  work(most?: number): Promise<number>;
}

function bench(workers = 2, background?: Background): Bench {
  const hands: FakeWorker[] = [];
  const spawn = (): FakeWorker => {
    const hand = fakeWorker();
    hands.push(hand);
    return hand;
  };
  const room = createTraceQueue({
    spawn,
    workers,
    changed: () => {},
    ...(background ? { background } : {}),
  });
  const work = async (most = 10_000): Promise<number> => {
    let done = 0;
    for (let moved = true; moved && done < most; ) {
      moved = false;
      for (const hand of hands)
        if (!hand.terminated && (await hand.step())) [moved, done] = [true, done + 1];
    }
    return done;
  };
  return { room, hands, work };
}

const state = (room: TraceQueue, request: TraceRequest | null) =>
  request && room.seen(request)?.state;

describe('the traceQueue', () => {
  test('traces what is wanted, one after the other, and then rests', async () => {
    const { room, work } = bench();
    const { main, other } = requests({ against: 'start:none' });
    if (!other) throw new Error('no other side');
    room.want([main, other]);
    expect(room.current()).toBe(main);
    await work();
    // The page is drawn, and asks again.
    room.want([main, other]);
    expect([state(room, main), state(room, other)]).toEqual(['finished', 'loading']);
    await work();
    room.want([main, other]);
    expect([state(room, main), state(room, other)]).toEqual(['finished', 'finished']);
    expect(room.current()).toBeNull();
    expect(await work()).toBe(0);
  });

  test('a change ends what runs, and begins at once with what is wanted now', async () => {
    const { room, work } = bench();
    const before = requests().main;
    const after = requests({ scene: 'mirror' }).main;
    room.want([before]);
    await work(3);
    room.want([after]);
    expect(room.current()).toBe(after);
    expect(room.seen(before)).toBeNull();
    await work();
    expect([state(room, before), state(room, after)]).toEqual(
      [null, 'finished'].map((s) => s ?? undefined),
    );
  });

  test('what is urgent comes before what already runs', async () => {
    const { room, work } = bench();
    const { main } = requests();
    const first = requests({ scene: 'plain' }).main;
    room.want([main]);
    await work(2);
    room.want([first, main]);
    expect(room.current()).toBe(first);
  });

  test('a finished picture is there again without tracing', async () => {
    const { room, work } = bench();
    const [a, b] = [requests().main, requests({ scene: 'plain' }).main];
    for (const request of [a, b]) {
      room.want([request]);
      await work();
    }
    room.want([requests().main]);
    expect(state(room, a)).toBe('finished');
    expect(await work()).toBe(0);
  });

  test('cancelled it stays as it is, until it is wanted anew', async () => {
    const { room, work } = bench();
    const { main } = requests();
    room.want([main]);
    await work(4);
    room.cancel();
    expect(state(room, main)).toBe('cancelled');
    room.want([main]);
    expect(room.current()).toBeNull();
    expect(room.seen(main)?.done).toBeGreaterThan(0);
    room.again([main]);
    room.want([main]);
    await work();
    expect(state(room, main)).toBe('finished');
  });

  test('cancelled, then something else, then back: it is traced', async () => {
    const { room, work } = bench();
    const { main } = requests();
    room.want([main]);
    await work(3);
    room.cancel();
    room.want([requests({ scene: 'plain' }).main]);
    room.want([main]);
    await work();
    expect(state(room, main)).toBe('finished');
  });

  test('at rest nothing runs; afterwards it goes on', async () => {
    const { room, work } = bench();
    const { main } = requests();
    room.want([main]);
    await work(3);
    room.rest();
    expect(room.current()).toBeNull();
    room.want([main]);
    await work();
    expect(state(room, main)).toBe('finished');
  });

  test('a worker that fails is told, and not asked again and again', async () => {
    const { room, hands } = bench(1);
    const { main } = requests();
    room.want([main]);
    hands[0]?.crash('out of memory');
    expect(room.seen(main)).toMatchObject({ state: 'failed', message: 'out of memory' });
    room.want([main]);
    expect(room.current()).toBeNull();
  });

  test.each([
    [undefined, 1],
    [0, 1],
    [2, 2],
    [64, 8],
  ])('%s cores: %d workers', (hardwareConcurrency, workers) => {
    expect(coresOf(hardwareConcurrency === undefined ? {} : { hardwareConcurrency })).toBe(workers);
  });
});

describe('behind what is wanted', () => {
  /** Draws the page until nothing more happens. */
  async function rest({ room, work }: Bench, wanted: readonly TraceRequest[]): Promise<void> {
    do room.want(wanted);
    while ((await work()) > 0);
  }

  test('pictures are repeated in turn, the first time not counted', async () => {
    const repeats = createRepeats();
    const the = bench(2, repeats);
    const { main, baselines } = requests({ on: 'refraction', scene: 'shadows' });
    const all = [main, ...baselines];
    await rest(the, all);
    expect(repeats.times(main)).toBeNull();
    repeats.start(all);
    expect(repeats.progress()).toMatchObject({ repeat: 0, repeats: 7 });
    await rest(the, all);
    expect(repeats.progress()).toBeNull();
    for (const one of all) expect(repeats.times(one)?.repeats).toBe(7);
    const scenes =
      the.hands[0]?.done.flatMap((m) => (m.type === 'scene' ? [m.settings] : [])) ?? [];
    const forced = scenes.map((settings) => settings.forced.refraction ?? 'no');
    expect(forced.slice(0, 6)).toEqual(['on', 'no', 'on', 'no', 'on', 'no']);
    expect(forced).toHaveLength(all.length * (1 + 8));
  });

  test('they stop for what is wanted, and when told', async () => {
    const repeats = createRepeats();
    const the = bench(1, repeats);
    const { main } = requests({ scene: 'plain' });
    await rest(the, [main]);
    repeats.start([main]);
    the.room.want([main]);
    await the.work(3);
    const { main: other } = requests();
    the.room.want([other]);
    expect(the.room.current()).toBe(other);
    repeats.stop();
    await rest(the, [other]);
    expect([state(the.room, other), repeats.times(main)]).toEqual(['finished', null]);
  });

  const rgbaOf = (picture: Picture | null | undefined) => [...(picture?.rgba ?? [])];

  test.each([
    ['1', 'shadows.2'],
    ['1', 'everything.2'],
    ['9', 'shadows.2'],
  ])(
    'at rest, a picture of %s rays a pixel becomes the one with sixteen: %s',
    async (samples, scene) => {
      const refiner = createRefiner();
      const the = bench(2, oneAfterAnother(createRepeats(), refiner));
      const main = requests({ samples, scene }).main;
      const fine = requests({ samples: '16', scene }).main;
      const refine = (): void => refiner.setPicture(main, the.room.seen(main)?.frame ?? null);
      await rest(the, [main]);
      refine();
      await rest(the, [main]);
      expect(refiner.progress(main)).toEqual({ everywhere: 16, edges: 16 });
      expect(refiner.next()).toBeNull();
      refiner.setPicture(null, null);
      await rest(the, [fine]);
      refine();
      expect(refiner.finer(main)).toBeNull();
      await rest(the, [main]);
      expect(rgbaOf(refiner.finer(main))).toEqual(rgbaOf(the.room.seen(fine)?.frame));
    },
  );

  test.each(['1', '4'])(
    'edges first, each pixel in the same order, from %s rays a pixel',
    async (samples) => {
      const refiner = createRefiner();
      const rays = new Map<number, number[]>();
      const seen: { everywhere: number; edges: number; least: number; at32: number }[] = [];
      const main = requests({ samples, scene: 'everything.2' }).main;
      let differences = new Uint8Array(0);
      const the = bench(2, {
        ...refiner,
        onResult(request, progress) {
          const { samples: order = [], pixels } = request.settings.part ?? {};
          pixels?.forEach((one, i) => {
            if (one) rays.set(i, [...(rays.get(i) ?? []), ...order]);
          });
          refiner.onResult(request, progress);
          const counts = [...differences.keys()].map((i) => rays.get(i)?.length ?? 0);
          const steep = counts.filter((_, i) => (differences[i] ?? 0) > EDGES[0]);
          const [least, at32] = [Math.min(...counts), Math.min(...steep)];
          seen.push({ ...(refiner.progress(main) as Refined), least, at32 });
        },
      });
      await rest(the, [main]);
      const stands = the.room.seen(main)?.frame as Frame;
      differences = differencesBeside(stands);
      const before = [...stands.rgba];
      refiner.setPicture(main, stands);
      await rest(the, [main]);
      for (const order of rays.values()) expect(order).toEqual(rays.get(0));
      expect([...(rays.get(0) ?? [])].sort((a, b) => a - b)).toEqual([...Array(16).keys()]);
      for (const { everywhere, least } of seen) expect(everywhere).toBe(least);
      if (samples === '1')
        expect(seen[0]).toMatchObject({ everywhere: 0, edges: EDGE_RAYS - 1, at32: 3 });
      else expect(seen[0]).toEqual({ everywhere: 1, edges: 1, least: 1, at32: 1 });
      // What was asked for is what the ledger is of: it stays.
      expect([...stands.rgba]).toEqual(before);
    },
  );

  test('stopped, it says how many rays the picture has that it shows', async () => {
    const refiner = createRefiner();
    let passes = 0;
    const the = bench(1, {
      ...refiner,
      onResult(request, progress) {
        refiner.onResult(request, progress);
        passes += 1;
        if (passes === 1) refiner.stop();
      },
    });
    const main = requests({ scene: 'everything.2' }).main;
    await rest(the, [main]);
    refiner.setPicture(main, the.room.seen(main)?.frame ?? null);
    await rest(the, [main]);
    expect([passes, refiner.progress(main)]).toEqual([1, { everywhere: 1, edges: EDGE_RAYS }]);
  });

  test('how the price grows: all work, then the times; it waits, stops, begins anew', async () => {
    const growth = createGrowth();
    const the = bench(2, growth);
    const { main } = requests({ scene: 'mirror' });
    growth.setPicture(main);
    growth.setPaused(true);
    await rest(the, [main]);
    expect(growth.state()).toMatchObject({ share: 0, runs: true, repeat: 0 });
    growth.setPaused(false);
    the.room.want([main]);
    await the.work(40);
    const some = growth.state()?.series.flatMap(({ points }) => points) ?? [];
    expect(some.some(({ work }) => work)).toBe(true);
    expect(some.every(({ time }) => time === null)).toBe(true);
    growth.stop();
    await rest(the, [main]);
    expect(growth.state()?.runs).toBe(false);
    growth.again();
    await rest(the, [main]);
    const found = growth.state();
    expect(found).toMatchObject({ share: 1, runs: false, msLeft: 0 });
    const [pixels] = found?.series ?? [];
    const whole = pixels?.points.at(-1);
    expect(whole?.x).toBe(32 * 18);
    const { ms: _, ...work } = totalOf((the.room.seen(main) as TraceProgress).ledger);
    expect(whole?.work).toMatchObject(work);
    for (const { points } of found?.series ?? []) {
      for (const { time } of points) expect(time?.low).toBeGreaterThanOrEqual(0);
    }
    growth.setPicture(null);
    expect(growth.state()).toBeNull();
  });

  test('a budget: what breaks it ends at once, and what is chosen was compared whole', async () => {
    const search = createBudgetSearch();
    const the = bench(2, search);
    const { main } = requests({ scene: 'cone-on-mirror' }, 'certified');
    const budget = BUDGET.read('0.5');
    search.setPicture(main, budget);
    await rest(the, [main]);
    const found = search.state();
    const pixels = 32 * 18;
    expect(found).toMatchObject({ runs: false, tracing: null, timed: 1 });
    expect(found?.chosen).toMatchObject({ keeps: true, seen: pixels, over: 0 });
    expect(found?.chosen?.time).not.toBeNull();
    for (const { keeps, over, seen } of found?.candidates ?? []) {
      expect(keeps).toBe(over === 0 && seen === pixels);
    }
    const broken = found?.candidates.filter(({ keeps }) => !keeps) ?? [];
    expect(broken.some(({ seen }) => seen < pixels / 2)).toBe(true);
    // The same question is not asked again, another one is.
    search.setPicture(requests({ scene: 'cone-on-mirror' }, 'certified').main, BUDGET.read('0.5'));
    expect(search.state()).toBe(found);
    search.setPicture(main, BUDGET.read('10%'));
    expect(search.state()).toMatchObject({ candidates: [], chosen: null, runs: true });
    search.setPicture(main, null);
    expect([search.state(), search.next()]).toEqual([null, null]);
  });
});

describe('a comparison', () => {
  const stateOf = (settings: Settings, method: string): AppState => {
    const given = { ...SMALL, ...settings };
    return { ...INITIAL, method, settings: { ...INITIAL.settings, picture: given } };
  };

  async function modelFor(settings: Settings, method: string) {
    const { room, work } = bench(1);
    const state = stateOf(settings, method);
    const { main, other } = pictureModel(state, room).requests;
    for (let k = 0; k < 2; k++) {
      room.want(other ? [main, other] : [main]);
      await work();
    }
    return pictureModel(state, room);
  }

  test('finds the same, whichever side is the one to be trusted', async () => {
    const right = await modelFor({ scene: 'far', against: 'method:textbook32' }, 'certified');
    const left = await modelFor({ scene: 'far', against: 'method:certified' }, 'textbook32');
    expect([right.trustsLeft, left.trustsLeft]).toEqual([false, true]);
    const { verdicts, holes, ghosts } = right.comparison ?? {};
    expect(verdicts).toBeGreaterThan(50);
    expect(left.comparison).toMatchObject({ verdicts, holes, ghosts });
  });

  test('with an effect off counts the pixels that it changes', async () => {
    const model = await modelFor({ scene: 'mirror', against: 'off:reflection' }, 'moment');
    const reflection = model.ledger.simulated.find(({ id }) => id === 'reflection');
    expect(reflection?.pixels).toBeGreaterThan(0);
    expect(reflection?.pixels).toBe(model.comparison?.differing);
    expect(model.uncounted).toHaveLength(model.ledger.simulated.length - 1);
  });

  test('acne: no method cures it; an epsilon is too small here and too large there', async () => {
    const differing = async (scene: string, against: string, method: string): Promise<number> => {
      const model = await modelFor({ size: '96x54', scene, against }, method);
      return model.comparison?.differing ?? Number.NaN;
    };
    for (const method of ['moment', 'compensated', 'certified']) {
      expect(await differing('self-intersection', 'start:none', method)).toBeGreaterThan(300);
      expect(await differing('self-intersection', 'start:1e-15', method)).toBeGreaterThan(20);
    }
    expect(await differing('self-intersection', 'start:1e-9', 'moment')).toBe(0);
    // In a scene with a small thing far out every epsilon is one or the other.
    expect(await differing('two-scales', 'start:1e-9', 'moment'), 'too small').toBeGreaterThan(300);
    expect(await differing('two-scales', 'start:0.001', 'moment'), 'too large').toBeGreaterThan(30);
  });

  test('of a picture with itself finds nothing', async () => {
    const model = await modelFor({ scene: 'mirror', against: 'on:reflection' }, 'moment');
    expect(model.comparison).toMatchObject({ differing: 0, verdicts: 0 });
  });
});

describe('requests', () => {
  test('forcing on what is needed anyway is the same picture', () => {
    expect(requests({ on: 'reflection' }).main.key).toBe(requests().main.key);
    expect(requests({ off: 'reflection' }).main.key).not.toBe(requests().main.key);
  });

  test('what is forced has the picture without forcing for its baseline', () => {
    const forced = requests({ off: 'reflection', on: 'soft-shadow' });
    expect(forced.baselines.map(({ key }) => key).toSorted()).toEqual(
      [
        requests({ on: 'soft-shadow' }).main.key,
        requests({ off: 'reflection' }).main.key,
      ].toSorted(),
    );
    expect(requests().baselines).toEqual([]);
  });

  test('method, start rule, size and scene each make another picture', () => {
    const keys = [
      requests(),
      requests({}, 'exact'),
      requests({ start: 'none' }),
      requests({ start: '1e-9' }),
      requests({ samples: '4' }),
      requests({ light: '9' }),
      requests({ size: '33x18' }),
      requests({ scene: 'mirror' }),
    ].map(({ main }) => main.key);
    expect(new Set(keys).size).toBe(keys.length);
  });

  test('divider, pixel and error map do not', () => {
    const more = { split: '10', pixel: '3,4', show: 'errors' };
    expect(requests(more).main.key).toBe(requests().main.key);
  });
});

describe('the recorder', () => {
  test('follows one pixel after the other, each in its own picture', async () => {
    const hand = fakeWorker();
    const recorder = createRayRecorder(() => hand);
    const asked = [
      recorder.record(requests().main, 16, 9),
      recorder.record(requests({ scene: 'plain' }).main, 3, 4),
      recorder.record(requests().main, 5, 6),
    ];
    const pump = async (): Promise<void> => {
      for (let idle = 0; idle < 20; ) {
        await new Promise((done) => setTimeout(done));
        idle = (await hand.step()) ? 0 : idle + 1;
      }
    };
    await pump();
    const trees = await Promise.all(asked);
    expect(trees.map(({ x, y }) => [x, y])).toEqual([
      [16, 9],
      [3, 4],
      [5, 6],
    ]);
    expect(hand.done.filter(({ type }) => type === 'scene')).toHaveLength(3);
  });

  test('a failure is that question’s alone', async () => {
    const [dead, fresh] = [fakeWorker(), fakeWorker()];
    const hands = [dead, fresh];
    const recorder = createRayRecorder(() => hands.shift() as FakeWorker);
    const first = recorder.record(requests().main, 1, 1);
    await new Promise((done) => setTimeout(done));
    dead.crash('broken');
    await expect(first).rejects.toThrow('broken');
    expect(dead.terminated).toBe(true);
    const second = recorder.record(requests().main, 2, 2);
    for (let k = 0; k < 10; k++) {
      await new Promise((done) => setTimeout(done));
      await fresh.step();
    }
    await expect(second).resolves.toMatchObject({ x: 2, y: 2 });
  });
});
