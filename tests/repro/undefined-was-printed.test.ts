import { expect, test } from 'vitest';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { decode } from '../../src/state/url.ts';

/*
 * Numbers that a float method lost (∞ − ∞, 0 · ∞) were put into sentences, where NaN is
 * "undefined".
 */
test.each([
  [
    'a distance',
    'shape=square&axis=z&P=0,0,1e21&L=0&E=0,0,0&d=4.469269276682214e132,0,1/3&method=compensated',
  ],
  ['f(0)', 'shape=hyperboloid&C=0,0,0&a=1e308&r=0&E=0,0,0&d=0,0,0.1&method=textbook32'],
])('%s', (_, query) => {
  const { verdict, graph, scene, hits } = createDerive(() => exploreDetails)(
    decode(`#/explore?${query}`),
  );
  const said = [verdict.text, graph.description, scene.description, ...hits.map((h) => h.text)];
  expect(said.join(' ')).not.toContain('undefined');
});
