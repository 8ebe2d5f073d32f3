import { expect, test } from 'vitest';
import { createDerive } from '../../../src/state/derive.ts';
import { lineCount } from '../../../src/state/reveal.ts';
import { INITIAL } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode } from '../../../src/state/url.ts';

const at = (link: string, lines: number | null) =>
  createDerive()(update(decode(link, INITIAL), { type: 'reveal', lines }));

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
