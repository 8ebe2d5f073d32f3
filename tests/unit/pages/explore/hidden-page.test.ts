import { describe, expect, test } from 'vitest';
import '../../state/gallery-loaded.ts';
import { walkOf } from '../../../../src/math/formula.ts';
import { intersect } from '../../../../src/math/index.ts';
import { seeded } from '../../../../src/math/rng.ts';
import type { Shape } from '../../../../src/math/shapes/index.ts';
import { exploreExports } from '../../../../src/pages/explore/exports.ts';
import { sceneBar } from '../../../../src/pages/explore/scene-bar.ts';
import { stepOf } from '../../../../src/pages/explore/walk-steps.ts';
import { galleryContent } from '../../../../src/pages/gallery.ts';
import { algebra } from '../../../../src/panels/algebra.ts';
import { normalLine } from '../../../../src/panels/normal-line.ts';
import { announcement } from '../../../../src/state/announce.ts';
import { createDerive, type ExploreModel } from '../../../../src/state/derive.ts';
import { exploreDetails } from '../../../../src/state/explore-details.ts';
import { GALLERY } from '../../../../src/state/gallery/index.ts';
import { graphOf } from '../../../../src/state/graph.ts';
import { withoutResults, withoutRoots } from '../../../../src/state/hidden-results.ts';
import { ASKS } from '../../../../src/state/prediction-ask.ts';
import { sceneOf } from '../../../../src/state/scene.ts';
import { stageAround } from '../../../../src/state/stage.ts';
import { type AppState, INITIAL } from '../../../../src/state/state.ts';
import { decode } from '../../../../src/state/url.ts';
import { many } from '../../many.ts';
import { DRAWS, drawRay } from '../../state/ray-oracle.ts';

/*
 * While the results are hidden, nothing on the page may depend on them. What is shown beside E, d
 * and the shape's own numbers has to be the same for every ray.
 */

const nothing = (): void => {};

/** All that Lit makes of a template: texts, attributes, and what directives are given. */
function written(part: unknown): string {
  if (Array.isArray(part)) return part.map(written).join('');
  if (typeof part === 'string' || typeof part === 'number' || typeof part === 'boolean') {
    return String(part);
  }
  if (part === null || typeof part !== 'object') return '';
  const { strings, values } = part as {
    strings?: readonly string[];
    values?: readonly unknown[];
  };
  if (strings) return strings.map((text, i) => text + written(values?.[i])).join('');
  // guard([…], make), live(value)
  return (values ?? []).map((value) => written(isMaker(value) ? value() : value)).join('');
}
const isMaker = (value: unknown): value is () => unknown =>
  typeof value === 'function' && value.length === 0;

const stateOf = (shape: Shape, { origin: E, direction: d }: ExploreModel['ray']): AppState => ({
  ...INITIAL,
  ...{ kind: shape.kind, shapes: { ...INITIAL.shapes, [shape.kind]: shape }, E, d },
  revealed: 0,
});

const TOOLS = { command: () => undefined, playing: false, soundOn: false, second: false };

/** Everything on the page but E, d, the shape's numbers and the picture. */
function pageOf(model: ExploreModel): string {
  const walk = walkOf(model.shape, false);
  return [
    algebra(model, nothing, normalLine),
    sceneBar({ ...model, example: null }, TOOLS, false, null as unknown as HTMLElement),
    ...walk.map((step, i) => stepOf(step, i + 1, true, model)),
  ]
    .map(written)
    .join('\n');
}

describe.each(Object.entries(DRAWS))('%s', (_, draw) => {
  const random = seeded(77);
  const shapes = Array.from({ length: many(12) }, () => draw(random));

  test('the words and formulas are the same for every ray', () => {
    const classes = new Set<string>();
    for (const shape of shapes) {
      const pages = new Map<string, string>();
      for (let round = 0; round < 16; round++) {
        const ray = drawRay(random, shape);
        const model = createDerive(() => exploreDetails)(stateOf(shape, ray));
        classes.add(model.found.class);
        pages.set(pageOf(model), JSON.stringify(ray));
      }
      expect([...pages.values()], JSON.stringify(shape)).toHaveLength(1);
    }
    expect(classes.size).toBeGreaterThan(2);
  });

  test('the picture and the graph are the same, whatever was found', () => {
    for (const shape of shapes) {
      const ray = drawRay(random, shape);
      const stage = stageAround(shape, [ray.origin]);
      const drawing = createDerive(() => exploreDetails)(stateOf(shape, ray)).scene.drawing;
      for (const ask of ASKS) {
        const state = { ...stateOf(shape, ray), ask };
        const seen = new Set<string>();
        for (let round = 0; round < 12; round++) {
          // What would be found of another ray: hits, bead, stretches and words of its own.
          const found = intersect(shape, drawRay(random, shape));
          const graph = graphOf(found, shape, ray, null, found);
          const scene = sceneOf({
            ...{ title: 'it', verdict: found.class, ray, found, stage, drawing, graph },
            ended: null,
            ...{ handles: [], view: 'iso', ghost: { ray, found } },
          });
          const hidden = [withoutResults(scene, state), withoutRoots(graph, { shape, ray, state })];
          seen.add(JSON.stringify(hidden));
        }
        expect(seen.size, `${ask} ${JSON.stringify({ shape, ray })}`).toBe(1);
      }
    }
  });
});

test.each(ASKS)('asked for %s, no example has a word of its story on the page', (ask) => {
  const derive = createDerive(() => exploreDetails);
  let before = derive({ ...INITIAL, revealed: 0 });
  for (const { id, link, title, asks, answer } of GALLERY) {
    const model = derive({ ...decode(link), revealed: 0, ask, example: id });
    const bar = written(sceneBar(model, TOOLS, false, null as unknown as HTMLElement));
    const heard = announcement(before, model);
    for (const words of [title, asks, answer]) {
      expect(bar, id).not.toContain(words);
      expect(heard, id).not.toContain(words);
    }
    expect(heard, id).toMatch(/^Example \d+ of \d+\.$/);
    before = model;
  }
});

test('the gallery has numbers alone', () => {
  const whole = written(galleryContent(null, nothing, null, true, nothing, nothing));
  // The maps below it are of rays of their own, whose names may be like an example's.
  const [text = ''] = whole.split('<section aria-label="Maps">');
  expect(text).not.toBe(whole);
  for (const { id, title, asks } of GALLERY) {
    expect(text).not.toContain(asks);
    expect(text, id).not.toMatch(new RegExp(`>${title}<|"${id}"|=${id}\\b`));
  }
});

test('nothing can be taken home but pictures of the scene', () => {
  const model = createDerive(() => exploreDetails)({ ...INITIAL, revealed: 0 });
  const stub = { graph: () => null } as unknown as Parameters<typeof exploreExports>[0];
  expect(exploreExports(stub, () => model).map(({ id }) => id)).toEqual([
    'picture-svg',
    'picture-png',
  ]);
});

test('hiding takes the bead away from where it may tell a root', () => {
  const derive = createDerive(() => exploreDetails);
  expect(derive({ ...INITIAL, revealed: 0, bead: 2, ask: 'points' }).scene.bead).toBeNull();
});
