import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { exploreLink } from '../../../src/state/explore-link.ts';
import { fromFile, toFile } from '../../../src/state/file.ts';
import { advance, historyOf } from '../../../src/state/history.ts';
import { type AppState, INITIAL, PAGES, type PageId } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode, encode } from '../../../src/state/url.ts';

const SEED = 16180;
const LATER = PAGES.map(({ id }) => id).filter((id) => id !== 'explore');

/** Any text that a link can carry: all of Unicode but halves of surrogate pairs. */
const text = fc.string({ unit: 'binary' }).map((s) => s.replace(/\p{Surrogate}/gu, ''));
/** No key of a ray's or of a shape's: those are single letters, shape, axis, unit, method. */
const key = text.map((s) => `key${s}`);
const someSettings = fc.dictionary(key, text, { maxKeys: 6 });

const on = (page: PageId, settings: Record<string, string>): AppState => ({
  ...INITIAL,
  page,
  settings: { ...INITIAL.settings, [page]: settings },
});

describe('settings in the link', () => {
  test.each(LATER)(`come back from a link of %s, whatever they say (seed ${SEED})`, (page) => {
    fc.assert(
      fc.property(someSettings, (settings) => {
        const state = on(page, settings);
        const link = encode(state);
        expect(decode(link).settings[page]).toEqual(settings);
        expect(decode(link).problems).toEqual([]);
        expect(encode(decode(link))).toBe(link);
      }),
      { seed: SEED, numRuns: 300 },
    );
  });

  test('halves of surrogate pairs become the sign for what could not be read', () => {
    expect(encode(on('check', { word: '\ud800' }))).toContain(encodeURIComponent('\ufffd'));
  });

  test('Explore has none: what it does not know is said', () => {
    expect(decode('#/explore?seed=3').problems).toEqual(["'seed' means nothing for a cone"]);
    expect(decode('#/check?seed=3')).toMatchObject({
      problems: [],
      settings: { check: { seed: '3' } },
    });
  });

  test('a page about the ray has it in its link, another one leaves it alone', () => {
    const before = decode('#/explore?shape=circle&E=1,2,3&r=0.25&method=stable');
    const accuracy = encode({ ...before, page: 'accuracy' });
    expect(decode(accuracy)).toMatchObject({ page: 'accuracy', kind: 'circle', E: [1, 2, 3] });
    const picture = encode({ ...before, page: 'picture' });
    expect(picture).toBe('#/picture?method=stable');
    const after = decode(picture, before);
    expect(after).toMatchObject({
      page: 'picture',
      kind: 'circle',
      E: [1, 2, 3],
      method: 'stable',
    });
    expect(after.shapes).toEqual(before.shapes);
  });

  test('a ray from elsewhere is a link to Explore, with its method', () => {
    const shape = { kind: 'cylinder', center: [1, 0, -1], radius: 2 } as const;
    const link = exploreLink(shape, { origin: [6, 1, 2], direction: [-1, 0.5, -0.5] }, 'moment');
    expect(link).toBe('#/explore?shape=cylinder&E=6,1,2&d=-1,0.5,-0.5&C=1,0,-1&r=2&method=moment');
  });
});

describe('settings in the state', () => {
  test('are merged into those of the page that is shown; null takes one away', () => {
    const state = on('picture', { scene: 'glass', size: '160x90' });
    const after = update(state, { type: 'settings', values: { scene: null, start: 'none' } });
    expect(after.settings.picture).toEqual({ size: '160x90', start: 'none' });
    expect(after.settings.check).toBe(state.settings.check);
  });

  test('that change nothing are no change', () => {
    const state = on('picture', { scene: 'glass' });
    expect(update(state, { type: 'settings', values: { scene: 'glass', size: null } })).toBe(state);
  });

  test('another page is no step of undo; undo goes where the step was taken', () => {
    const picture = on('picture', { scene: 'glass' });
    const changed = advance(
      historyOf(picture),
      { type: 'settings', values: { scene: 'plain' } },
      null,
    );
    const away = advance(changed, { type: 'page', page: 'explore' }, null);
    expect(away.past).toHaveLength(1);
    const back = advance(away, { type: 'undo' }, null);
    expect(back.present).toMatchObject({
      page: 'picture',
      settings: { picture: { scene: 'glass' } },
    });
    const elsewhere = advance(back, { type: 'page', page: 'check' }, null);
    const again = advance(elsewhere, { type: 'redo' }, null);
    expect(again.present).toMatchObject({
      page: 'picture',
      settings: { picture: { scene: 'plain' } },
    });
  });

  test('the complaints about a link end with the page they were about', () => {
    const state = decode('#/explore?c=x');
    expect(update(state, { type: 'page', page: 'check' }).problems).toEqual([]);
  });
});

describe('settings in a file', () => {
  test('every page’s come back', () => {
    const state: AppState = {
      ...on('check', { seed: '41' }),
      settings: { ...INITIAL.settings, check: { seed: '41' }, picture: { scene: 'far' } },
    };
    const opened = fromFile(toFile(state));
    expect(opened).toMatchObject({ ok: true, state: { page: 'check', settings: state.settings } });
  });

  test.each([
    ['no object', '3'],
    ['a page that is a list', '{"check":["a"]}'],
    ['values that are no text', '{"check":{"seed":41,"deep":{"a":1},"none":null}}'],
    ['a page that there is not', '{"attic":{"seed":"1"},"__proto__":{"seed":"1"}}'],
  ])('%s is left out', (_, settings) => {
    const opened = fromFile(`{"graze":1,"link":"#/explore","settings":${settings}}`);
    if (!opened.ok) throw new Error(opened.reason);
    expect(Object.keys(opened.state.settings).sort()).toEqual(
      PAGES.map(({ id }) => id as string).sort(),
    );
    for (const own of Object.values(opened.state.settings)) {
      for (const value of Object.values(own)) expect(typeof value).toBe('string');
    }
    expect(opened.state.settings.check).not.toHaveProperty('seed');
  });
});
