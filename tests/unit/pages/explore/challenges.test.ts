import { expect, test } from 'vitest';
import { SHAPES } from '../../../../src/math/index.ts';
import { CHALLENGES } from '../../../../src/pages/explore/challenges.ts';
import { closerLook } from '../../../../src/state/closer-look.ts';
import { createDerive } from '../../../../src/state/derive.ts';
import { type AppState, INITIAL } from '../../../../src/state/state.ts';
import { decode } from '../../../../src/state/url.ts';

const metIn = (state: AppState): readonly string[] => {
  const { found, shape } = createDerive(() => closerLook)(state);
  return CHALLENGES.filter(
    ({ kind, met }) => (kind ?? shape.kind) === shape.kind && met(found, shape) !== null,
  ).map(({ id }) => id);
};

test('an empty visit has met none of them, on no shape', () => {
  for (const { kind } of SHAPES) expect(metIn({ ...INITIAL, kind }), kind).toEqual([]);
});

const cone = (rest: string): string => `#/explore?shape=cone&V=0,0,0&c=1&${rest}`;
test.each([
  ['a touching ray', '#/explore?shape=sphere&C=0,0,0&r=1&E=3,1,0&d=-1,0,0', ['tangent']],
  ['through the vertex alone', cone('E=-1,2,0&d=1,-2,0'), ['tangent']],
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
