import { expect, test } from 'vitest';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { decode } from '../../src/state/url.ts';

test('where a part of the stage’s radius is below the doubles, handles have places', () => {
  const link = '#/explore?shape=paraboloid&k=0&E=0,0,0&d=0,0,5e-324&between=0,5e-324';
  const { scene } = createDerive(() => exploreDetails)(decode(link));
  for (const grip of scene.drawing.grips) {
    if (grip.type === 'reach') expect(grip.reach).toBeGreaterThanOrEqual(0);
  }
});
