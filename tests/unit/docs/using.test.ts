import { describe, expect, test } from 'vitest';
import { METHODS, SHAPES } from '../../../src/math/index.ts';
import { KEYS as CHECK_KEYS, PARTS, readSettings } from '../../../src/pages/check/settings.ts';
import { commandTitle } from '../../../src/pages/command-titles.ts';
import { commandsOf } from '../../../src/pages/commands.ts';
import { keyWords } from '../../../src/pages/help.ts';
import { SIMPLIFICATIONS } from '../../../src/scene/simplifications.ts';
import {
  ACCURACY_KEYS,
  COSTS,
  readAccuracy,
  WORTHS,
} from '../../../src/state/accuracy/settings.ts';
import { NAMED_VIEWS } from '../../../src/state/camera-view.ts';
import {
  LIGHT_SAMPLES,
  type PictureKey,
  readPicture,
  SAMPLES,
} from '../../../src/state/picture/settings.ts';
import { PAGES, type Settings } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';
import { parseNumber } from '../../../src/text/parse.ts';
import { MOST_BOUNCES } from '../../../src/tracer/weight.ts';
import { codeSpans, flowing, read, section } from './documents.ts';

const using = read('docs/USING.md');
/** What a document need not name yet: a shape or method that is newer than its last row. */
const inOrder = (ids: readonly string[], documented: readonly string[]): readonly string[] =>
  ids.filter((id) => documented.includes(id));
const tableRows = (text: string): readonly (readonly string[])[] =>
  [...text.matchAll(/^\| (.*) \|$/gm)].map((m) => (m[1] ?? '').split(' | '));

describe('the keys in docs/USING.md', () => {
  const commands = commandsOf({ dispatch() {}, get() {} } as never, {} as never);
  const titleOf = (id: string): string | undefined => PAGES.find((page) => page.id === id)?.title;

  test('are those of the pages, with what they do', () => {
    const [[, ...found] = []] = section(using, '## Keys')
      .split('\n\n')
      .map(tableRows)
      .filter((rows) => rows.length > 0);
    const documented = found.map(([, , title = '']) => title);
    const newer = SHAPES.map(({ title }) => title).filter((title) => !documented.includes(title));
    const rows = commands
      .filter(({ id }) => !newer.includes(commandTitle(id) ?? ''))
      .map(({ keys, pages, id }) => [
        keys.map((key) => `\`${keyWords(key)}\``).join(' or '),
        pages ? pages.map(titleOf).join(', ') : 'every page',
        commandTitle(id),
      ]);
    expect(rows.flat()).not.toContain(undefined);
    expect(found).toEqual(rows);
  });
});

describe('the links in docs/USING.md', () => {
  const [shared = [], own = []] = section(using, '## Links')
    .split('\n\n')
    .map(tableRows)
    .filter((rows) => rows.length > 0);
  const spansOf = (rows: readonly (readonly string[])[], first: string): readonly string[] =>
    codeSpans(rows.find(([key]) => key === first)?.[1] ?? '');
  /** Keys of a page, each with what its row says of it. */
  const keysOf = (page: string): ReadonlyMap<string, string> =>
    new Map(
      own
        .filter(([title]) => title === page)
        .flatMap(([, keys = '', value = '']) => codeSpans(keys).map((key) => [key, value])),
    );

  const kinds = spansOf(shared, '`shape`');

  test('name shapes and methods in their order', () => {
    const methods = spansOf(shared, '`method`');
    expect(Math.min(kinds.length, methods.length)).toBeGreaterThan(1);
    expect(
      inOrder(
        SHAPES.map(({ kind }) => kind),
        kinds,
      ),
    ).toEqual(kinds);
    expect(
      inOrder(
        METHODS.map(({ id }) => id),
        methods,
      ),
    ).toEqual(methods);
  });

  test('name every parameter of these shapes by its symbol', () => {
    for (const { title, params } of SHAPES.filter(({ kind }) => kinds.includes(kind))) {
      const symbols = params.map(({ symbol }) => `\`${symbol}\``).join(', ');
      expect(shared).toContainEqual([
        symbols,
        `${title}: ${params.map((param) => param.title).join('; ')}`,
      ]);
    }
  });

  test('name every key of each page and no other', () => {
    // The compiler holds this list to be whole.
    const picture: Readonly<Record<PictureKey, string>> = {
      scene: 'scene',
      size: 'size',
      samples: 'samples',
      light: 'light',
      start: 'start',
      on: 'on',
      off: 'off',
      against: 'against',
      split: 'split',
      show: 'show',
      pixel: 'pixel',
      bounces: 'bounces',
      growth: 'growth',
      budget: 'budget',
      drag: 'drag',
    };
    expect([...keysOf('Accuracy').keys()].sort()).toEqual([...ACCURACY_KEYS].sort());
    expect([...keysOf('Picture').keys()].sort()).toEqual(Object.keys(picture).sort());
    expect([...keysOf('Check').keys()].sort()).toEqual([...CHECK_KEYS].sort());
    for (const key of keysOf('Explore').keys()) {
      expect(decode(`#/explore?${key}=`).problems.join()).not.toContain('means nothing');
    }
  });

  test('name the words that keys may have', () => {
    const words = (page: string, key: string): readonly string[] =>
      codeSpans(keysOf(page).get(key) ?? '');
    const ids = (list: readonly { readonly id: string }[]): readonly string[] =>
      list.map(({ id }) => id);
    expect(words('Explore', 'view').slice(0, -1)).toEqual(ids(NAMED_VIEWS));
    expect(words('Accuracy', 'worth')).toEqual(ids(WORTHS));
    expect(words('Accuracy', 'cost')).toEqual(ids(COSTS));
    expect(words('Check', 'part')).toEqual(ids(PARTS));
    expect(keysOf('Picture').get('samples')).toContain(`: ${SAMPLES.join(', ')}`);
    expect(keysOf('Picture').get('light')).toContain(`: ${LIGHT_SAMPLES.join(', ')}`);
  });

  test('give values that open without complaint', () => {
    const problemsOf = (page: string, key: string, value: string): readonly string[] => {
      const given: Settings = { [key]: value };
      if (page === 'Accuracy') return readAccuracy(given).problems;
      if (page === 'Picture') return readPicture(given).problems;
      return page === 'Check' ? readSettings(given).problems : [];
    };
    let tried = 0;
    for (const [page = '', keys = '', text = ''] of own.slice(1)) {
      for (const span of codeSpans(text).filter((one) => !one.includes('/'))) {
        if (span.includes('=')) {
          expect(decode(`#/explore?${span}`).problems).toEqual([]);
        } else {
          expect([keys, span, ...problemsOf(page, codeSpans(keys)[0] ?? '', span)]).toEqual([
            keys,
            span,
          ]);
        }
        tried += 1;
      }
    }
    expect(tried).toBeGreaterThan(20);
  });
});

test('what boxes take, they take', () => {
  const [first = ''] = flowing(using).split(';');
  const numbers = codeSpans(first);
  expect(numbers.length).toBeGreaterThan(3);
  expect(numbers.filter((text) => !parseNumber(text).ok)).toEqual([]);
});

describe('docs/FAKED.md', () => {
  test('what it says that pictures leave out is what the page lists', () => {
    const [, ...items] = section(read('docs/FAKED.md'), '## In pictures').split('\n* ');
    expect(items.map(flowing)).toEqual(
      SIMPLIFICATIONS.map(({ title, reason, file }) => `${title}: ${reason} (\`${file}\`)`),
    );
    expect(SIMPLIFICATIONS.map(({ reason }) => reason).join()).toContain(`${MOST_BOUNCES} bounces`);
  });
});
