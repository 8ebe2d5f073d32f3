import { expect, test } from 'vitest';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { decode } from '../../src/state/url.ts';

/*
 * r² was formed before the root was taken: at 1e300 every drawn point was NaN, at 1e-300 there was
 * no patch at all.
 */
test.each(['1e300', '1e-300'])('a cylinder and a hyperboloid of radius %s', (r) => {
  for (const kind of ['cylinder', 'hyperboloid']) {
    const link = `#/explore?shape=${kind}&C=0,0,0&r=${r}&E=3*${r},0,0&d=-1,0,0`;
    const [patch] = createDerive(() => exploreDetails)(decode(link)).scene.drawing.patches;
    // The waist, seen from the side.
    const waist = Array.from({ length: 101 }, (_, i) => patch?.at(0.25, i / 100) ?? [0, 0, 0]);
    const narrowest = Math.min(...waist.map(([x]) => x));
    expect(narrowest / Number(r)).toBeCloseTo(1, 2);
  }
});
