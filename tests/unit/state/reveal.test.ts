import { describe, expect, test } from 'vitest';
import './gallery-loaded.ts';
import { announcement } from '../../../src/state/announce.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { titleOf } from '../../../src/state/example.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';
import { rootsOf } from '../../../src/state/graph-window.ts';
import { lineCount } from '../../../src/state/reveal.ts';
import { clipToStage } from '../../../src/state/scene.ts';
import { stageAround } from '../../../src/state/stage.ts';
import { INITIAL } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode } from '../../../src/state/url.ts';

const at = (link: string, lines: number | null) =>
  createDerive(() => exploreDetails)(
    update({ ...decode(link, INITIAL), revealed: lines }, { type: 'reveal', lines }),
  );

test.each([
  ['#/explore?shape=cone', 7],
  ['#/explore?shape=cone&d=1,0,0&E=0,0,9', 6],
  ['#/explore?shape=plane', 5],
  ['#/explore?shape=square', 6],
])('%s has %i lines', (link, lines) => {
  expect(lineCount(at(link, null))).toBe(lines);
});

test('one after another: steps, conditions, verdict, hits', () => {
  const shown = Array.from({ length: 7 }, (_, n) => at('#/explore?shape=square', n).shown);
  expect(shown.map((s) => [s.steps, s.conditions, s.verdict, s.hits])).toEqual([
    [0, false, false, false],
    [1, false, false, false],
    [2, false, false, false],
    [3, false, false, false],
    [3, true, false, false],
    [3, true, true, false],
    [3, true, true, true],
  ]);
});

test('while the hits are hidden the scene does not give them away', () => {
  const { scene } = at('#/explore?shape=cone', 6);
  expect(scene.hits).toEqual([]);
  expect(scene.ray.segments.map(({ stretch }) => stretch)).toEqual(
    scene.ray.segments.map(({ to }) => (to <= 0 ? 'behind' : 'before')),
  );
  expect(scene.description).not.toMatch(/enters|root|t₁/);
});

test('the segments of a hidden scene are one piece before and after E', () => {
  const { scene } = at('#/explore?shape=cone', 0);
  expect(scene.ray.segments).toHaveLength(2);
});

describe.each(GALLERY.map((entry) => [entry.id, entry] as const))('hidden, %s', (_, entry) => {
  const derive = createDerive(() => exploreDetails);
  const state = update(decode(entry.link, INITIAL), { type: 'reveal', lines: 0 });
  const { scene, shape, ray, example, graph } = derive(update(state, { type: 'ghost', on: true }));

  test('shows the part of the world that E and the shape take, wherever the hits are', () => {
    expect(scene.stage).toEqual(stageAround(shape, [ray.origin]));
    expect(scene.ghost).toBeNull();
    expect(scene.bead).toBeNull();
    expect(graph.concealed).toBe(true);
  });

  test('draws the line to where it leaves that part, not to a root', () => {
    const whole = clipToStage(ray, scene.stage, { from: -Infinity, to: Infinity });
    const { segments } = scene.ray;
    const drawn = segments.length > 0 ? [segments[0]?.from, segments.at(-1)?.to] : undefined;
    expect(drawn).toEqual(whole ? [whole.from, whole.to] : undefined);
  });

  test('is named by its number, and announced by it', () => {
    expect(example && titleOf(example, true)).toMatch(/^\d+ of \d+$/);
    const before = derive(update(INITIAL, { type: 'reveal', lines: 0 }));
    const words = announcement(before, derive(state));
    expect(words).not.toContain(entry.title);
    expect(words).not.toContain(entry.asks);
    expect(words).not.toContain(entry.answer);
  });
});

test('until D is known the line of t is the same, whether there is one or not', () => {
  const lines = (link: string, n: number) => at(link, n).derivation.steps.map(({ expr }) => expr);
  const [two, tangent, none, one] = ['E=3,1,0', 'E=3,1,1', 'E=3,1,9', 'E=3,0.5,0&d=-1,1,0'].map(
    (ray) => `#/explore?shape=cone&V=0,0,0&c=1&d=-1,0,0&${ray}`,
  );
  for (let n = 0; n < 4; n++) {
    for (const link of [tangent, none, one]) {
      expect(lines(link ?? '', n), link).toEqual(lines(two ?? '', n));
    }
  }
  expect(lines(none ?? '', 4)).toHaveLength(4);
  expect(lines(two ?? '', 4)).toHaveLength(5);
});

test('a bead that was put on the ray is shown where that is asked, and nowhere else', () => {
  const marked = (ask: string) => at(`#/explore?shape=cone&hide=1&ask=${ask}&t=1.5`, 0).scene.bead;
  expect(marked('where')).toMatchObject({ t: 1.5 });
  expect(marked('points')).toBeNull();
});

test('a line without roots is drawn through the whole stage', () => {
  for (const { id, link } of GALLERY) {
    const { scene, found, ray } = createDerive(() => exploreDetails)(decode(link, INITIAL));
    if (rootsOf(found).length > 0) continue;
    const whole = clipToStage(ray, scene.stage, { from: -Infinity, to: Infinity });
    expect(scene.ray.segments[0]?.from, id).toBe(whole?.from);
    expect(scene.ray.segments.at(-1)?.to, id).toBe(whole?.to);
  }
});
