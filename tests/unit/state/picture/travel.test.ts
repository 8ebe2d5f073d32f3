import { describe, expect, test } from 'vitest';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import { createDerive } from '../../../../src/state/derive.ts';
import { exploreDetails } from '../../../../src/state/explore-details.ts';
import { exploreLink } from '../../../../src/state/explore-link.ts';
import { pictureSettings } from '../../../../src/state/picture/settings.ts';
import { type TreeRow, treeRows } from '../../../../src/state/picture/tree-rows.ts';
import { startOutcomeOf } from '../../../../src/state/start-outcome.ts';
import { type AppState, INITIAL } from '../../../../src/state/state.ts';
import { update } from '../../../../src/state/update.ts';
import { decode, encode } from '../../../../src/state/url.ts';
import type { TraceSettings } from '../../../../src/tracer/types.ts';
import { share } from '../../many.ts';
import { TINY, tracerFor } from '../../tracer/tracing.ts';

/* From a pixel's ray to Explore and back: shape, heights, caps, method and start rule. */

const ALL: ReadonlySet<string> = new Set();
const derive = createDerive(() => exploreDetails);

/** Rows of every 127th pixel. */
async function rowsOf(
  { scene }: (typeof PRESETS)[number],
  how: Partial<TraceSettings>,
): Promise<TreeRow[]> {
  const settings = { ...TINY, ...how };
  const tracer = await tracerFor(scene, settings);
  const found: TreeRow[] = [];
  for (let pixel = 7; pixel < TINY.width * TINY.height; pixel += 127) {
    const x = pixel % TINY.width;
    const [root] = tracer.record(x, (pixel - x) / TINY.width).rays;
    if (root) found.push(...treeRows(scene, root, ALL, settings));
  }
  return found;
}

const RULES: readonly Partial<TraceSettings>[] = [
  {},
  { method: 'textbook' },
  { start: { rule: 'none' } },
  { start: { rule: 'epsilon', epsilon: 0.3 } },
  { forced: { heights: 'off' } },
];

describe.each(RULES)('by %o', (how) => {
  test.each(PRESETS)('$id: where a ray hits is the first hit in Explore', async (preset) => {
    const { method } = { ...TINY, ...how };
    const rows = (await rowsOf(preset, how)).flatMap(({ opens, ray, node }) =>
      opens ? [{ opens, ray, node }] : [],
    );
    for (const { opens, ray, node } of share(rows)) {
      const state = decode(exploreLink(opens.shape, ray, method, opens));
      expect(state.problems).toEqual([]);
      expect(state).toMatchObject({ E: ray.origin, d: ray.direction, method });
      expect(state).toMatchObject({ between: opens.between, caps: opens.caps });
      // The shape itself, with the numbers that it has in the scene.
      expect(state.shapes[state.kind]).toEqual(opens.shape);
      if (node.end.end === 'hit') {
        expect([opens, ray, startOutcomeOf(derive(state))?.first]).toEqual([
          opens,
          ray,
          node.end.t,
        ]);
      }
    }
  });
});

test('back from Explore the picture is as it was, with its pixel', () => {
  const picture =
    '#/picture?method=textbook&scene=six-shapes&size=320x180&start=0.001&pixel=224,68';
  const before = decode(picture, INITIAL);
  const there = decode('#/explore?shape=cylinder&r=2&method=textbook&start=0.001', before);
  expect(there.settings.explore).toEqual({ start: '0.001' });
  const changed = update(there, { type: 'origin', value: [9, 9, 9] } as never);
  const back = decode(encode({ ...changed, page: 'picture' }), changed);
  expect(encode(back)).toBe(encode(before));
  expect(pictureSettings(back.settings.picture)).toEqual(pictureSettings(before.settings.picture));
});

describe('a start rule on Explore', () => {
  const from = (hash: string) => {
    const state: AppState = decode(hash);
    return { state, started: startOutcomeOf(derive(state)) };
  };

  test('without one nothing is said, and links have none', () => {
    const { state, started } = from('#/explore?shape=cylinder&r=1');
    expect([started, encode(state).includes('start')]).toEqual([null, false]);
  });

  test('it is in the link, and can be forgotten', () => {
    const { state, started } = from('#/explore?shape=cylinder&E=1,0,0&d=-1,0,0&r=1&start=from');
    expect(started).toMatchObject({ rule: 'from', dropped: 0, first: 2 });
    expect(encode(state)).toMatch(/&start=from$/);
    const forgotten = update(state, { type: 'settings', values: { start: null } });
    expect(encode(forgotten)).not.toContain('start');
  });

  test('one that nobody can read is quoted', () => {
    const { state, started } = from('#/explore?shape=plane&start=later');
    expect(state.problems).toEqual([]);
    expect(started?.words).toContain('later');
  });

  test('what else means nothing is said as before', () => {
    const { state } = from('#/explore?shape=plane&start=from&r=2');
    expect(state.problems).toHaveLength(1);
    expect(state.settings.explore).toEqual({ start: 'from' });
  });
});
