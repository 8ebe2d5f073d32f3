import { expect, test } from 'vitest';
import type { Action } from '../../../src/state/actions.ts';
import { announcement } from '../../../src/state/announce.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { INITIAL } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode } from '../../../src/state/url.ts';

function heard(link: string, action: Action): string {
  const derive = createDerive();
  const state = decode(link, INITIAL);
  return announcement(derive(state), derive(update(state, action)));
}

const NEAR = '#/explore?shape=cylinder&C=0,0,0&r=1.4&E=4,1,1.5&d=-1,0,0';

test('the value first, the consequence second', () => {
  expect(heard(NEAR, { type: 'param', key: 'radius', value: 1.5 })).toBe(
    'r 1.5. Now tangent: one double root, the ray touches, t₁ 4.',
  );
  expect(heard(NEAR, { type: 'param', key: 'radius', value: 2.5 })).toBe(
    'r 2.5. Now two points: the ray enters, then leaves, t₁ 2, t₂ 6.',
  );
});

test('with the same verdict, only where the hits have gone', () => {
  expect(heard(NEAR.replace('1.4', '2.5'), { type: 'origin', value: [5, 1, 1.5] })).toBe(
    'E (5, 1, 1.5). t₁ 3, t₂ 7.',
  );
});

test('a miss that stays a miss says the value alone', () => {
  expect(heard(NEAR, { type: 'param', key: 'radius', value: 1 })).toBe('r 1.');
});

test('a shape is named', () => {
  expect(heard(NEAR, { type: 'shape', kind: 'plane' })).toMatch(/^plane\. Now one point/);
});

test('looking around is silent', () => {
  expect(heard(NEAR, { type: 'view', view: 'top' })).toBe('');
  expect(heard(NEAR, { type: 'bead', t: 2 })).toBe('');
});

test('what is hidden is not told', () => {
  const derive = createDerive();
  const state = update(decode(NEAR, INITIAL), { type: 'reveal', lines: 0 });
  const next = update(state, { type: 'param', key: 'radius', value: 1.5 });
  expect(announcement(derive(state), derive(next))).toBe('r 1.5.');
});
