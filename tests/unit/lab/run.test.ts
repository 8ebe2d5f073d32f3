import { describe, expect, test } from 'vitest';
import { clockStep, hasSettled, measure, measuring, type Task } from '../../../src/lab/run.ts';

/** A clock that only moves when somebody works, in steps. */
function fakeClock(step: number) {
  let now = 0;
  return {
    clock: () => {
      // Reading costs a little, so that waiting for the next step ends.
      now += 0.001;
      return Math.floor(now / step) * step;
    },
    work: (ms: number) => {
      now += ms;
    },
  };
}

const PLAN = { rounds: 5, least: 10, steps: 100, warmUp: 2 };

describe('measuring', () => {
  test('finds the step of the clock', () => {
    expect(clockStep(fakeClock(0.1).clock)).toBeCloseTo(0.1, 9);
    expect(clockStep(fakeClock(5).clock)).toBe(5);
  });

  test('gives each task its own time, and no round of the warm-up', () => {
    const { clock, work } = fakeClock(0.005);
    const task = (id: string, ms: number): Task => ({ id, run: () => work(ms) });
    const times = measure([task('a', 0.5), task('b', 3)], clock, PLAN);
    expect(times.get('a')).toHaveLength(5);
    for (const ms of times.get('a') ?? []) expect(ms).toBeCloseTo(0.5, 2);
    for (const ms of times.get('b') ?? []) expect(ms).toBeCloseTo(3, 2);
  });

  test('a sample lasts for 10 ms and 100 steps of the clock', () => {
    for (const step of [0.005, 1]) {
      const { clock, work } = fakeClock(step);
      let calls = 0;
      const samples = measuring(
        [
          {
            id: 'a',
            run: () => {
              calls += 1;
              work(0.5);
            },
          },
        ],
        clock,
        { ...PLAN, warmUp: 1 },
        step,
      );
      samples.next();
      calls = 0;
      samples.next();
      expect(calls * 0.5).toBeGreaterThanOrEqual(Math.max(10, 100 * step));
    }
  });

  test('the tasks take turns', () => {
    const { clock, work } = fakeClock(0.005);
    const order: string[] = [];
    const task = (id: string): Task => ({
      id,
      run() {
        if (order.at(-1) !== id) order.push(id);
        work(20);
      },
    });
    measure([task('a'), task('b'), task('c')], clock, { ...PLAN, warmUp: 0, rounds: 2 });
    expect(order.join('')).toBe('abcabc');
  });

  test('tells how far it is, sample by sample, and can be left at any time', () => {
    const { clock, work } = fakeClock(0.005);
    const tasks = ['a', 'b'].map((id): Task => ({ id, run: () => work(20) }));
    const seen: [number, number][] = [];
    for (const { round, done, total, times } of measuring(tasks, clock, PLAN, 0.005)) {
      seen.push([round, done]);
      expect(total).toBe(14);
      if (done === 8) {
        expect(times.get('b')).toHaveLength(2);
        break;
      }
    }
    expect(seen).toEqual([
      [-2, 1],
      [-1, 2],
      [-1, 3],
      [0, 4],
      [0, 5],
      [1, 6],
      [1, 7],
      [2, 8],
    ]);
  });

  test('stops when the best quarter agrees, not before the least number of rounds', () => {
    const steady = new Map([['a', [1, 1, 1, 1.001]]]);
    expect(hasSettled(steady, { rounds: 4, spread: 0.01 })).toBe(true);
    expect(hasSettled(steady, { rounds: 5, spread: 0.01 })).toBe(false);
    expect(
      hasSettled(
        new Map([
          ['a', [1, 1, 1, 1]],
          ['b', [1, 2, 3, 4]],
        ]),
        { rounds: 4, spread: 0.01 },
      ),
    ).toBe(false);
    const { clock, work } = fakeClock(0.005);
    const times = measure([{ id: 'a', run: () => work(0.5) }], clock, {
      ...PLAN,
      rounds: 50,
      settles: { rounds: 6, spread: 0.05 },
    });
    expect(times.get('a')).toHaveLength(6);
  });
});
