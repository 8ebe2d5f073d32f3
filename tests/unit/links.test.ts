import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { PAGES } from '../../src/state/state.ts';
import { factsOf } from '../links/facts.ts';

/*
 * Links that were made before there were question sets, with what the version that made them showed
 * (cd6e47f). The file is never made anew: a link that means something else is a broken link.
 */

const file = new URL('../links/before-sets.json', import.meta.url);
const BEFORE: Readonly<Record<string, { readonly page: string }>> = JSON.parse(
  readFileSync(file, 'utf8'),
);

/** Pages that there were then. */
const OLD = PAGES.filter(({ id }) => id !== 'lesson');

test('there are at least ten links of each page', () => {
  for (const { id } of OLD) {
    const links = Object.values(BEFORE).filter(({ page }) => page === id);
    expect([id, links.length >= 10]).toEqual([id, true]);
  }
});

describe.each(OLD.map(({ id }) => id))('%s', (id) => {
  const links = Object.entries(BEFORE).filter(([, { page }]) => page === id);
  test.each(links)('%s', async (link, facts) => {
    expect(await factsOf(link)).toEqual(facts);
  });
});
