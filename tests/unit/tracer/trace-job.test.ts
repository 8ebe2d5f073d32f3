import { describe, expect, test } from 'vitest';
import { everything } from '../../../src/scene/presets/everything.ts';
import { plain } from '../../../src/scene/presets/plain.ts';
import { prepareTracer } from '../../../src/tracer/prepare.ts';
import { DEFAULT_SETTINGS, type TraceSettings } from '../../../src/tracer/types.ts';
import { createTiles } from '../../../src/workers/tiles.ts';
import {
  createTracePool,
  type TracePool,
  type TraceProgress,
} from '../../../src/workers/trace-job.ts';
import { type FakeWorker, fakeWorker } from './fake-worker.ts';

const SMALL: TraceSettings = { ...DEFAULT_SETTINGS, width: 53, height: 31, lightSamples: 4 };

interface Bench {
  readonly pool: TracePool;
  readonly hands: FakeWorker[];
  readonly seen: TraceProgress[];
  readonly listener: { progress(state: TraceProgress): void };
  now: number;
}

function bench(workers: number): Bench {
  const hands: FakeWorker[] = [];
  const seen: TraceProgress[] = [];
  const self: Bench = {
    hands,
    seen,
    now: 0,
    listener: { progress: (state) => void seen.push(state) },
    pool: createTracePool({
      workers,
      clock: () => self.now,
      spawn() {
        const hand = fakeWorker();
        hands.push(hand);
        return hand;
      },
    }),
  };
  return self;
}

/** Lets the workers answer, `order` deciding who is next, until none has anything to do. */
async function settle(hands: readonly FakeWorker[], order: (turn: number) => number) {
  for (let turn = 0; hands.some(({ inbox }) => inbox.length > 0); turn++) {
    await hands[order(turn) % hands.length]?.step();
  }
}

const whole = async (settings: TraceSettings) =>
  (await prepareTracer(everything.scene, settings, () => 0)).trace({
    y0: 0,
    y1: settings.height,
    step: 1,
    refines: false,
  });

describe('a picture', () => {
  test.each([
    ['one worker', 1, (turn: number) => turn],
    ['three workers by turns', 3, (turn: number) => turn],
    ['three workers, one of them slow', 3, (turn: number) => (turn % 7 === 0 ? 0 : 1 + (turn % 2))],
  ])('is bit for bit the same by %s as in one piece, and so is its ledger', async (_, n, order) => {
    const { pool, hands, seen, listener } = bench(n);
    pool.start(everything.scene, SMALL, listener);
    await settle(hands, order);
    const last = seen.at(-1) as TraceProgress;
    const right = await whole(SMALL);
    expect(last.state).toBe('finished');
    expect(last.done).toBe(53 * 31);
    expect([...last.frame.rgba]).toEqual([...right.rgba]);
    expect([...last.frame.surface]).toEqual([...right.surface]);
    expect([...last.frame.t]).toEqual([...right.t]);
    expect(last.ledger.kinds).toEqual(right.ledger.kinds);
    expect(last.ledger.saved).toBe(right.ledger.saved);
    expect(last.effects).toContain('soft-shadow');
    if (n > 1) expect(hands.every(({ done }) => done.length > 2)).toBe(true);
  });

  test('comes coarse to fine: after the first pass every pixel has a colour', async () => {
    const { pool, hands, seen, listener } = bench(1);
    pool.start(plain.scene, { ...SMALL, width: 160, height: 90 }, listener);
    const steps: number[] = [];
    while (hands[0]?.inbox.length) {
      await hands[0].step();
      const now = seen.at(-1) as TraceProgress;
      const first = now.done >= 20 * 12;
      steps.push(now.step);
      if (first) expect(now.frame.rgba.every((x, k) => k % 4 !== 3 || x === 255)).toBe(true);
    }
    expect(steps).toEqual([...steps].sort((a, b) => b - a));
    expect([steps[0], steps.at(-1)]).toEqual([8, 1]);
    const done = seen.map((state) => state.done);
    expect(done).toEqual([...done].sort((a, b) => a - b));
  });

  test('says how long it will still take', async () => {
    const world = bench(1);
    world.pool.start(plain.scene, SMALL, world.listener);
    expect(world.seen.at(-1)?.msLeft).toBeNaN();
    await world.hands[0]?.step();
    world.now = 100;
    await world.hands[0]?.step();
    const { done, total, msLeft, msSpent } = world.seen.at(-1) as TraceProgress;
    expect(msSpent).toBe(100);
    expect(msLeft).toBeCloseTo((100 * (total - done)) / done, 10);
  });
});

describe('a job', () => {
  test('that is cancelled says so once and nothing after', async () => {
    const { pool, hands, seen, listener } = bench(2);
    const job = pool.start(plain.scene, SMALL, listener);
    await hands[0]?.step();
    await hands[0]?.step();
    job.cancel();
    expect(seen.at(-1)?.state).toBe('cancelled');
    const count = seen.length;
    job.cancel();
    await settle(hands, (turn) => turn);
    expect(seen).toHaveLength(count);
    expect(hands.flatMap(({ done }) => done).length).toBeLessThan(12);
  });

  test('that is replaced keeps its frame to itself, and the new one is right', async () => {
    const { pool, hands, seen, listener } = bench(2);
    pool.start(everything.scene, SMALL, listener);
    await hands[0]?.step();
    await hands[0]?.step();
    await hands[1]?.step();
    const old = seen.at(-1)?.frame;
    const before = [...(old?.rgba ?? [])];
    pool.start(plain.scene, SMALL, listener);
    await settle(hands, (turn) => turn);
    const last = seen.at(-1) as TraceProgress;
    const tracer = await prepareTracer(plain.scene, SMALL, () => 0);
    const right = tracer.trace({ y0: 0, y1: 31, step: 1, refines: false });
    expect(last.state).toBe('finished');
    expect([...last.frame.rgba]).toEqual([...right.rgba]);
    expect([...(old?.rgba ?? [])]).toEqual(before);
    expect(hands).toHaveLength(2);
  });

  test('does not wait for a worker that is stuck, but for one that is still loading', async () => {
    const world = bench(1);
    world.pool.start(plain.scene, SMALL, world.listener);
    world.now = 5000;
    world.pool.start(plain.scene, SMALL, world.listener);
    expect(world.hands).toHaveLength(1);
    await settle(world.hands, () => 0);
    expect(world.seen.at(-1)?.state).toBe('finished');
    world.pool.start(plain.scene, SMALL, world.listener);
    await world.hands[0]?.step();
    world.now = 6000;
    world.pool.start(plain.scene, SMALL, world.listener);
    expect(world.hands.map(({ terminated }) => terminated)).toEqual([true, false]);
  });

  test('fails with the reason, and the next one gets new workers', async () => {
    const { pool, hands, seen, listener } = bench(2);
    const job = pool.start(plain.scene, { ...SMALL, method: 'guess' }, listener);
    const asked = job.record(1, 1);
    hands[0]?.crash('out of memory');
    expect(seen.at(-1)).toMatchObject({ state: 'failed', message: 'out of memory' });
    await expect(asked).rejects.toThrow('out of memory');
    await expect(job.record(1, 1)).rejects.toThrow('cancelled');
    pool.start(plain.scene, SMALL, listener);
    await settle(hands.slice(2), (turn) => turn);
    expect(hands).toHaveLength(4);
    expect(seen.at(-1)?.state).toBe('finished');
  });

  test('answers for a pixel while it runs and after', async () => {
    const { pool, hands, listener } = bench(1);
    const job = pool.start(everything.scene, SMALL, listener);
    const during = job.record(20, 20);
    await settle(hands, () => 0);
    const after = job.record(20, 20);
    await settle(hands, () => 0);
    expect(await during).toEqual(await after);
    expect((await after).rays).toHaveLength(1);
  });
});

test.each([
  [640, 360, 2],
  [53, 31, 8],
  [1, 1, 1],
  [8, 8, 3],
  [7, 300, 2],
])('tiles of %i × %i for %i workers cover each pixel once', async (width, height, workers) => {
  const { pixelsOf } = await import('../../../src/tracer/camera.ts');
  const tiles = createTiles(width, height, workers);
  const times = new Uint8Array(width * height);
  for (let tile = tiles.next(); tile; tile = tiles.next()) {
    const pixels = pixelsOf(tile, width);
    expect(pixels.length).toBeGreaterThan(0);
    for (const pixel of pixels) times[pixel] = (times[pixel] as number) + 1;
    tiles.took(pixels.length, 1 + (pixels.length % 100));
  }
  expect(times.every((n) => n === 1)).toBe(true);
});
