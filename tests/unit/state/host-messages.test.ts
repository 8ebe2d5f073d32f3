import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createDerive } from '../../../src/state/derive.ts';
import { PARTS } from '../../../src/state/embed.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { answerOf, opened, readMessage } from '../../../src/state/host-messages.ts';
import { INITIAL, shapeOf } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode, encode } from '../../../src/state/url.ts';
import { anyState } from './random-state.ts';

const SEED = 66260;
const read = (data: unknown) => readMessage(data, 'explore');

describe('messages of a host', () => {
  test.each([
    [{ graze: 1, type: 'get' }, { type: 'get' }],
    [{ graze: 1, type: 'reset', state: 'x' }, { type: 'reset' }],
    [{ graze: 1, type: 'subscribe' }, { type: 'subscribe' }],
    [
      { graze: 1, type: 'set', state: 'shape=cone&c=2' },
      { type: 'set', link: '#/explore?shape=cone&c=2' },
    ],
    [
      { graze: 1, type: 'set', state: '?c=2' },
      { type: 'set', link: '#/explore?c=2' },
    ],
    [
      { graze: 1, type: 'set', state: '#/check?seed=4' },
      { type: 'set', link: '#/check?seed=4' },
    ],
  ])('%j is read', (data, message) => {
    expect(read(data)).toEqual(message);
  });

  test.each([
    ...[null, undefined, 1, 'get', [], {}, { graze: '1', type: 'get' }, { type: 'get' }],
    ...[{ graze: 2, type: 'get' }, { graze: 1 }, { graze: 1, type: 'eval' }, { method: 'next' }],
    { graze: 1, type: { toString: (): string => 'get' } },
  ])('%j is nothing to Graze', (data) => {
    expect(read(data)).toBeNull();
  });

  test('a state that is no text, or too long a one, is refused with what came', () => {
    expect(read({ graze: 1, type: 'set' })).toEqual({
      error: "state must be a link's text, got nothing",
    });
    expect(read({ graze: 1, type: 'set', state: 7 })).toEqual({
      error: "state must be a link's text, got 7",
    });
    expect(read({ graze: 1, type: 'set', state: {} })).toEqual({
      error: "state must be a link's text, got an object",
    });
    expect(read({ graze: 1, type: 'set', state: 'x'.repeat(20_001) })).toEqual({
      error: 'state has 20001 characters, at most 20000 are read',
    });
  });

  test(`no data of any kind throws, seed ${SEED}`, () => {
    const data = fc.anything({ withNullPrototype: true, withBigInt: true, withDate: true });
    fc.assert(
      fc.property(data, fc.anything(), (one, state) => {
        read(one);
        const message = read({ graze: 1, type: 'set', state });
        if (message && 'link' in message) expect(message.link).toMatch(/^#\//);
      }),
      { seed: SEED, numRuns: 500 },
    );
  });
});

describe('a link of the host', () => {
  const now = decode('#/explore?shape=cone&embed=scene,graph&lock=c&theme=dark');

  test('leaves what is shown, locked and the theme as they were', () => {
    const next = opened('#/explore?shape=cone&c=2', now);
    expect(next).toMatchObject({ embed: ['scene', 'graph'], lock: ['c'], theme: 'dark' });
    expect(next.shapes.cone).toMatchObject({ slope: 2 });
  });

  test('changes those that it names', () => {
    const next = opened('#/explore?shape=cone&embed=graph&lock=E&theme=light', now);
    expect(next).toMatchObject({ embed: ['graph'], lock: ['E'], theme: 'light' });
  });
});

describe('what is answered', () => {
  const derive = createDerive(() => exploreDetails);

  test(`is the state, and brings it back, seed ${SEED}`, () => {
    fc.assert(
      fc.property(anyState, (state) => {
        const { state: query } = answerOf(state, null);
        expect(decode(`#/${state.page}?${query}`)).toEqual(state);
      }),
      { seed: SEED, numRuns: 200 },
    );
  });

  test(`has class and roots as the page has, neither while they are hidden, seed ${SEED}`, () => {
    fc.assert(
      fc.property(anyState, (state) => {
        const model = derive({ ...state, page: 'explore' });
        const answer = answerOf(state, model);
        if (state.revealed === null) {
          expect(answer.class).toBe(model.found.class);
          expect(answer.t).toEqual(model.found.hits.map(({ t }) => t));
        } else expect([answer.class, answer.t]).toEqual([null, []]);
      }),
      { seed: SEED, numRuns: 200 },
    );
  });
});

describe('keys of a link for a host', () => {
  test('what is no part, no theme or no symbol is said with what was written', () => {
    const { embed, lock, theme, problems } = decode(
      '#/explore?shape=sphere&embed=scene,menu&lock=c&theme=pink',
    );
    expect([embed, lock, theme]).toEqual([null, [], null]);
    expect(problems).toEqual([
      "opened without embed: 'menu' is not a part",
      "opened without lock: 'c' is not a symbol of a sphere",
      "opened without theme: 'pink' is not a theme",
    ]);
  });

  test('all parts in any order', () => {
    const link = `#/explore?shape=cone&method=certified&embed=${[...PARTS].reverse().join(',')}`;
    expect(encode(decode(link))).toBe(link);
  });

  test(`what is locked stays, whatever is asked for, seed ${SEED}`, () => {
    const vector = fc.tuple(fc.double(), fc.double(), fc.double());
    const params = ['slope', 'vertex', 'radius', 'center', 'flare', 'normal', 'point', 'width'];
    const actions = fc.oneof(
      fc.record({ type: fc.constant('origin' as const), value: vector }),
      fc.record({ type: fc.constant('direction' as const), value: vector }),
      fc.record({ type: fc.constant('unit' as const), on: fc.boolean() }),
      fc.record({
        type: fc.constant('param' as const),
        key: fc.constantFrom(...params),
        value: fc.oneof(vector, fc.double()),
      }),
      fc.record({
        type: fc.constant('reset' as const),
        what: fc.constantFrom('E' as const, 'd' as const, 'all' as const),
      }),
    );
    const locked = anyState.filter(({ lock }) => lock.length > 0);
    fc.assert(
      fc.property(locked, fc.array(actions, { maxLength: 8 }), (state, deeds) => {
        const after = deeds.reduce(update, state);
        const kept = (now: typeof state) =>
          state.lock.map((symbol) => new RegExp(`[?&]${symbol}=([^&]*)`).exec(encode(now))?.[1]);
        expect(kept(after)).toEqual(kept(state));
      }),
      { seed: SEED, numRuns: 400 },
    );
  });
});

test('what is not locked moves', () => {
  const state = decode('#/explore?shape=cone&lock=c');
  expect(update(state, { type: 'param', key: 'slope', value: 3 })).toBe(state);
  expect(update(state, { type: 'origin', value: [1, 2, 3] }).E).toEqual([1, 2, 3]);
  expect(INITIAL.lock).toEqual([]);
});

test('another shape is free, and the locked one comes back as it was', () => {
  const state = decode('#/explore?shape=cone&c=2&lock=c');
  const sphere = update(state, { type: 'shape', kind: 'sphere' });
  expect(sphere.kind).toBe('sphere');
  const back = update(sphere, { type: 'shape', kind: 'cone' });
  expect(shapeOf(back)).toMatchObject({ kind: 'cone', slope: 2 });
});
