import { expect, test } from 'vitest';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { decode } from '../../../src/state/url.ts';
import { graphAt, sceneAt } from '../../../src/state/walk-figures.ts';

/* What the walk adds to scene and graph: by hand, for rays of whole numbers. */

const modelOf = (link: string) => createDerive(() => exploreDetails)(decode(`#/explore?${link}`));

/** 3 beside the axis of a cylinder of radius 5: f(t) = (t − 10)² + 9 − 25. */
const CYLINDER = 'shape=cylinder&C=0,0,0&r=5&E=-10,2,3&d=1,0,0';
/** 3 beside the centre of a sphere of radius 5. */
const SPHERE = 'shape=sphere&C=0,0,0&r=5&E=-10,0,3&d=1,0,0';

test('f turns at −B/2A, at the height −D/4A, and its roots lie √D/2A from there', () => {
  for (const step of ['complete', 'roots']) {
    expect(graphAt(modelOf(CYLINDER), step).square).toEqual({ t: 10, f: -16, half: 4 });
  }
  const missed = graphAt(modelOf(CYLINDER.replace('r=5', 'r=2')), 'complete').square;
  expect(missed).toEqual({ t: 10, f: 5, half: Number.NaN });
});

test.each([
  ['cylinder', CYLINDER, [0, 2, 0], [0, 2, 3]],
  ['sphere', SPHERE, [0, 0, 0], [0, 0, 3]],
])('%s: the circle, and the line from its centre to the ray', (_, link, foot, point) => {
  const [circle, distance] = sceneAt(modelOf(link), 'complete').figures ?? [];
  expect(distance?.points).toEqual([foot, point]);
  for (const corner of circle?.points ?? []) {
    const away = corner.map((x, i) => x - (foot[i] ?? 0));
    expect(Math.hypot(...away)).toBeCloseTo(5, 12);
    // About an axis in one height; about a centre in the plane of the line.
    expect(away[1]).toBeCloseTo(0, 12);
  }
});

test('nothing at other steps, of other surfaces, for A = 0, or while results are hidden', () => {
  const cases = [
    [CYLINDER, 'coefficients'],
    [`${CYLINDER}&hide=1`, 'complete'],
    [CYLINDER.replace('d=1,0,0', 'd=0,1,0'), 'complete'],
    ['shape=plane', 'expand'],
  ] as const;
  for (const [link, step] of cases) {
    const model = modelOf(link);
    expect(graphAt(model, step)).toBe(model.graph);
    expect(sceneAt(model, step)).toBe(model.scene);
  }
  expect(sceneAt(modelOf('shape=cone'), 'complete').figures).toBeUndefined();
  expect(graphAt(modelOf('shape=cone'), 'complete').square).toBeDefined();
});
