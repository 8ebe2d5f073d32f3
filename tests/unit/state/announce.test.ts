import { describe, expect, test } from 'vitest';
import './gallery-loaded.ts';
import type { Action } from '../../../src/state/actions.ts';
import { announcement } from '../../../src/state/announce.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { INITIAL } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode } from '../../../src/state/url.ts';

function heard(link: string, action: Action): string {
  const derive = createDerive(() => exploreDetails);
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

test('where it is looked at from, and the bead is silent: its slider speaks', () => {
  expect(heard(NEAR, { type: 'view', view: 'ray' })).toBe('View: along ray.');
  const view = { azimuth: 30, elevation: -20, zoom: 1.5 };
  expect(heard(NEAR, { type: 'view', view })).toBe('View: 30° round, −20° up, zoom 1.5.');
  expect(heard(NEAR, { type: 'bead', t: 2 })).toBe('');
});

test('all that has changed since it was last told', () => {
  const derive = createDerive(() => exploreDetails);
  const state = decode(NEAR, INITIAL);
  const moved = update(state, { type: 'origin', value: [5, 1, 1.5] });
  const both = update(moved, { type: 'param', key: 'radius', value: 1.5 });
  expect(announcement(derive(state), derive(both))).toBe(
    'E (5, 1, 1.5). r 1.5. Now tangent: one double root, the ray touches, t₁ 5.',
  );
});

test('lines that are revealed one by one, and all of them', () => {
  const derive = createDerive(() => exploreDetails);
  const hidden = update(decode(NEAR, INITIAL), { type: 'reveal', lines: 0 });
  const told = [1, 4, 5, null].map((lines, i, all) => {
    const before = i === 0 ? 0 : (all[i - 1] ?? null);
    return announcement(
      derive(update(hidden, { type: 'reveal', lines: before })),
      derive(update(hidden, { type: 'reveal', lines })),
    );
  });
  expect(told).toEqual([
    'A 1.',
    'B −8. C 16.29. D −1.16.',
    'no point: the ray misses.',
    'Shown: no point: the ray misses.',
  ]);
});

test('what is hidden is not told', () => {
  const derive = createDerive(() => exploreDetails);
  const state = update(decode(NEAR, INITIAL), { type: 'reveal', lines: 0 });
  const next = update(state, { type: 'param', key: 'radius', value: 1.5 });
  expect(announcement(derive(state), derive(next))).toBe('r 1.5.');
});

describe('an example', () => {
  const derive = createDerive(() => exploreDetails);
  const opened = update(INITIAL, { type: 'example', id: 'circle-rim' });
  const moved = update(opened, { type: 'param', key: 'radius', value: 3 });

  test('is announced with its number, title, question and verdict', () => {
    const words = announcement(derive(INITIAL), derive(opened));
    expect(words).toMatch(/^Example \d+ of \d+: on the rim\. Does a point on the rim count\? /);
    expect(words).toContain('Now one point, on the rim, which belongs to the circle, t₁ 3.');
  });

  test('that is changed says so once, and is announced again when it is back', () => {
    expect(announcement(derive(opened), derive(moved))).toBe(
      'r 3. Now one point, inside the circle, t₁ 3. The example is changed.',
    );
    const further = update(moved, { type: 'param', key: 'radius', value: 4 });
    expect(announcement(derive(moved), derive(further))).toBe('r 4.');
    expect(announcement(derive(further), derive(opened))).toMatch(/^Example \d+ of/);
  });

  test('is not changed by the derivation that is opened beside it', () => {
    const open = update(opened, { type: 'derive', step: () => 1 });
    expect(derive(open).example?.changed).toBe(false);
    expect(announcement(derive(opened), derive(open))).toBe('');
  });

  test('has its answer announced when it is asked for', () => {
    const told = update(opened, { type: 'tell', on: true });
    const answer = '|P₁ − C| is exactly r: the rim belongs to the circle.';
    expect(announcement(derive(opened), derive(told))).toBe(answer);
    expect(announcement(derive(told), derive(update(told, { type: 'tell', on: false })))).toBe('');
  });

  test('keeps its title and question to itself while the results are hidden', () => {
    const hidden = update(INITIAL, { type: 'reveal', lines: 0 });
    const next = update(hidden, { type: 'example', id: 'circle-rim' });
    expect(announcement(derive(hidden), derive(next))).toMatch(/^Example \d+ of \d+\.$/);
  });
});

test('a shape that becomes another one is named', () => {
  const link = '#/explore?shape=hyperboloid&a=0.1&E=3,1,0.5&d=-1,0,0';
  const at = (value: number) => heard(link, { type: 'param', key: 'flare', value });
  expect(at(0)).toMatch(/^a 0: a cylinder\./);
  expect(at(-1)).toMatch(/^a −1: a sphere\./);
  expect(at(-0.5)).toMatch(/^a −0\.5: an ellipsoid\./);
  expect(at(0.2)).toMatch(/^a 0\.2\./);
  const flat = heard('#/explore?shape=cone&c=0.5', { type: 'param', key: 'slope', value: 0 });
  expect(flat).toMatch(/^c 0: only the axis is left\./);
});
