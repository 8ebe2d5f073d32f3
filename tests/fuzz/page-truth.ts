import type { Page } from '@playwright/test';
import type { Vec3 } from '../../src/math/vec3.ts';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { INITIAL } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';
import { shortest } from '../../src/text/format.ts';
import { frames, timersDone } from '../browser/support/pending.ts';

/**
 * Of a page with `countPending`. Null if the page is whole: no word of NaN, and every number on it
 * is the math module's for the state in its link.
 */
export async function pageTruth(page: Page, errors: readonly string[]): Promise<string | null> {
  if (errors.length > 0) return `errors at ${page.url()}: ${errors.join('\n')}`;
  await frames(page, 2);
  // On the way to an example what is drawn is not yet what the state says.
  await page.locator('main:is([data-moving], [data-waiting])').waitFor({ state: 'detached' });
  await frames(page, 2);
  await timersDone(page);
  const { hash, shown, words, boxes, playing, sweeping } = await page.evaluate(() => ({
    sweeping: document.querySelector('[data-playing]') !== null,
    playing: document.querySelector('.ray-tool[aria-pressed="true"]')?.textContent === 'stop',
    hash: location.hash,
    words: (document.querySelector('#app') as HTMLElement).innerText,
    boxes: [...document.querySelectorAll<HTMLInputElement>('input')].map(({ value }) => value),
    shown: [...document.querySelectorAll('[data-quantity]')].map((e) => [
      e.getAttribute('data-quantity') ?? '',
      e.getAttribute('data-value') ?? '',
    ]),
  }));
  const nonsense = /\bNaN\b|\bundefined\b|\[object/.exec(words);
  if (nonsense) return `the page says ${nonsense[0]} at ${hash}`;
  if (boxes.some((value) => /NaN|undefined/.test(value))) return `a box says NaN at ${hash}`;
  // While a number plays, what is drawn is on its way and the state is not.
  if (sweeping) return null;
  // While the bead plays the link follows a little behind.
  const still = shown.filter(([name]) => !(playing && name?.startsWith('bead.')));
  return differences(hash, still as [string, string][]);
}

function differences(hash: string, shown: readonly [string, string][]): string | null {
  const state = decode(hash, INITIAL);
  if (state.problems.length > 0) return `its own link has problems: ${state.problems.join(', ')}`;
  const truth = quantitiesOf(hash);
  const seen = new Set<string>();
  for (const [name, value] of shown) {
    if (seen.has(name)) return `${name} stands twice at ${hash}`;
    seen.add(name);
    const expected = truth.get(name);
    if (expected !== undefined && expected !== value) {
      return `${name} is ${value}, should be ${expected} at ${hash}`;
    }
  }
  return null;
}

/** Every number that is said of a link, by the math module itself. */
function quantitiesOf(hash: string): Map<string, string> {
  const model = createDerive(() => exploreDetails)(decode(hash, INITIAL));
  const found = new Map<string, string>();
  const put = (name: string, x: number): void => {
    found.set(name, shortest(x));
  };
  const triple = (name: string, [x, y, z]: Vec3): void => {
    put(`${name}.x`, x);
    put(`${name}.y`, y);
    put(`${name}.z`, z);
  };
  found.set('class', model.found.class);
  triple('E', model.ray.origin);
  triple('d', model.ray.direction);
  for (const { id, value } of model.derivation.steps) if (value !== null) put(id, value);
  model.found.hits.forEach((hit, i) => {
    put(`t${i + 1}`, hit.t);
    triple(`P${i + 1}`, hit.point);
    if (!hit.singular) triple(`N${i + 1}`, hit.normal);
  });
  put('bead.t', model.graph.bead.t);
  put('bead.f', model.graph.bead.f);
  triple('bead', model.graph.bead.point);
  return found;
}
