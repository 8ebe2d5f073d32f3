import { expect, test } from 'vitest';
import { scalesOf } from '../../src/charts/graph-scales.ts';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { decode } from '../../src/state/url.ts';

const FRAME = { left: 40, right: 600, top: 30, bottom: 180, floor: 160, em: 12.5, narrow: false };

/**
 * The page's fuzzer, seed 1: d3 made an array of 10^300 ticks for a graph whose values are
 * subnormal.
 */
test.each([
  '#/explore?shape=plane&N=1e-320,0,0',
  '#/explore?shape=plane&N=1e-308,0,0&E=1e-10,0,0',
  '#/explore?shape=cylinder&r=1e-170&E=1e-170,0,0&d=1e-160,0,0',
  '#/explore?shape=plane&N=1e308,0,0&E=1e308,1,1',
])('%s has ticks, or none, but no error', (link) => {
  const { graph } = createDerive(() => exploreDetails)(decode(link));
  expect(() => scalesOf(graph, FRAME as Parameters<typeof scalesOf>[1])).not.toThrow();
});
