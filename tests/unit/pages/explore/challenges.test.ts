import { expect, test } from 'vitest';
import { SHAPES } from '../../../../src/math/index.ts';
import { integer, seeded } from '../../../../src/math/rng.ts';
import { CHALLENGES } from '../../../../src/pages/explore/challenges.ts';
import { createDerive } from '../../../../src/state/derive.ts';
import { exploreDetails } from '../../../../src/state/explore-details.ts';
import { type AppState, INITIAL, RAY_PARAMS } from '../../../../src/state/state.ts';
import { decode } from '../../../../src/state/url.ts';

const metIn = (state: AppState): readonly string[] => {
  const model = createDerive(() => exploreDetails)(state);
  const { shape } = model;
  return CHALLENGES.filter(
    ({ kind, met }) => (kind ?? shape.kind) === shape.kind && met(model) !== null,
  ).map(({ id }) => id);
};

test('an empty visit has met none of them, on no shape', () => {
  for (const { kind } of SHAPES) expect(metIn({ ...INITIAL, kind }), kind).toEqual([]);
});

const cone = (rest: string): string => `#/explore?shape=cone&V=0,0,0&c=1&${rest}`;
test.each([
  ['a touching ray', '#/explore?shape=sphere&C=0,0,0&r=1&E=3,1,0&d=-1,0,0', ['tangent']],
  ['through the vertex alone', cone('E=-1,2,0&d=1,-2,0'), ['tangent']],
  // 0.1 is no double, and neither is the height at which the ray touches.
  [
    'nearly a touch',
    '#/explore?shape=sphere&C=0,0,0&r=0.3&E=3,0.1,0.28284271247461906&d=-1,0,0',
    ['tangent'],
  ],
  ['both points above V', cone('E=3,1,0&d=-1,0,0'), ['upper']],
  ['both below', cone('E=3,-1,0&d=-1,0,0'), []],
  ['one above and one below', cone('E=1,2,0&d=0,-1,0'), []],
  ['above, but behind E', cone('E=3,1,0&d=1,0,0'), ['behind']],
  ['E between the points', cone('E=0,1,0&d=-1,0,0'), ['upper', 'behind']],
  ['t₁ = 0', cone('E=1,1,0&d=-1,0,0'), ['upper']],
  ['a miss', '#/explore?shape=sphere&C=0,0,0&r=1&E=3,2,0&d=-1,0,0', []],
])('%s: %s meets %j', (_, hash, expected) => {
  expect(metIn(decode(hash))).toEqual(expected);
});

/** Of a range, a value that the slider stops at, coarse enough that a hand finds it. */
const stop = (random: () => number, { range: [least, most] }: { range: readonly number[] }) =>
  integer(random, 2 * (least ?? 0), 2 * (most ?? 0)) / 2;

test('each challenge can be met on every shape that it is offered on, by E and d alone', () => {
  const random = seeded(3);
  for (const { kind } of SHAPES) {
    const start = { ...INITIAL, kind };
    const { found, shape } = createDerive()(start);
    if (found.details.family !== 'curved') continue;
    const open = new Set(
      CHALLENGES.filter((one) => (one.kind ?? shape.kind) === shape.kind).map(({ id }) => id),
    );
    expect(open.size).toBeGreaterThan(1);
    for (let tries = 0; tries < 20_000 && open.size > 0; tries++) {
      const E = [0, 1, 2].map(() => stop(random, RAY_PARAMS.E)) as unknown as AppState['E'];
      const d = [0, 1, 2].map(() => stop(random, RAY_PARAMS.d)) as unknown as AppState['E'];
      if (d.every((x) => x === 0)) continue;
      for (const id of metIn({ ...start, E, d })) open.delete(id);
    }
    expect([...open], kind).toEqual([]);
  }
});
