import { expect, test } from 'vitest';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { decode } from '../../src/state/url.ts';

/*
 * With a cone and d.y on its slider from 1.52 to 1.53 the far hit passes 40 lengths from the middle
 * of the stage. Up to there the picture had grown to hold it, and one ulp later the hit was
 * forgotten: the radius fell from 43.2 to 5 at once.
 */
test('the stage lets go of a hit as gradually as it followed it', () => {
  const derive = createDerive(() => exploreDetails);
  const radiusAt = (dy: number): number =>
    derive(decode(`#/explore?shape=cone&d=-0.8,${dy},-0.3`)).scene.stage.radius;
  const steps = Array.from({ length: 801 }, (_, i) => radiusAt(1.515 + (0.02 * i) / 800));
  const worst = steps.slice(1).map((r, i) => Math.abs(r / (steps[i] ?? r) - 1));
  expect(Math.max(...steps)).toBeGreaterThan(40);
  expect(Math.max(...worst)).toBeLessThan(0.03);
});
