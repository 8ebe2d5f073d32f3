import * as fc from 'fast-check';
import { expect, test } from 'vitest';
import { frameOf } from '../../../src/charts/graph-frame.ts';
import { scalesOf } from '../../../src/charts/graph-scales.ts';
import { page } from '../../../src/charts/graph-view.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import type { AppState } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';
import { coordinate, FARTHEST } from '../../../src/text/coordinate.ts';
import { many } from '../many.ts';
import { anyPicture } from '../state/random-state.ts';

/* Every number that the graph hands to SVG can be drawn. */

const nothing = () => {};
const HANDLERS = { key: nothing, down: nothing, move: nothing, up: nothing, cancel: nothing };

/** The markup of a template, functions and comments left out. */
function markup(part: unknown): string {
  if (Array.isArray(part)) return part.map(markup).join('');
  if (typeof part === 'string' || typeof part === 'number') return String(part);
  if (typeof part !== 'object' || part === null) return '';
  const { strings, values } = part as { strings: readonly string[]; values: readonly unknown[] };
  return strings.reduce((before, after, i) => {
    const value = markup(values[i - 1]);
    return before + (before.endsWith('=') ? `"${value}"` : value) + after;
  });
}

const GEOMETRY = /\s(x|y|x1|x2|y1|y2|cx|cy|r|d|width|height|transform)="([^"]*)"/g;

function undrawable(state: AppState): string[] {
  const model = createDerive(() => exploreDetails)(state).graph;
  return [
    [640, 200],
    [340, 150],
  ].flatMap(([width = 0, height = 0]) => {
    const frame = frameOf({ width, height, em: 12.5, mark: 1 });
    const drawn = markup(page(model, frame, scalesOf(model, frame), 'graph', HANDLERS));
    return [...drawn.matchAll(GEOMETRY)].flatMap(([attribute, , value = '']) => {
      const words = value.match(/-?[\d.]+(?:e[-+]?\d+)?|NaN|Infinity|undefined/g) ?? [];
      return words.every((word) => Math.abs(Number(word)) <= FARTHEST) ? [] : [attribute];
    });
  });
}

test.each([
  'shape=cone&t=1e308',
  'shape=cone&t=-1e308',
  'shape=cone&d=-0,1e154,1e77',
  'shape=circle&E=1e236,1,1&d=-1,-1,0.5&method=textbook',
])('%s', (query) => {
  expect(undrawable(decode(`#/explore?${query}`))).toEqual([]);
});

test('of many states of any numbers', () => {
  fc.assert(
    fc.property(anyPicture, (state) => {
      expect(undrawable(state)).toEqual([]);
    }),
    { numRuns: many(400) },
  );
});

test('a coordinate is a number that can be drawn, and exact to a hundredth where it is one', () => {
  fc.assert(
    fc.property(fc.double(), (x) => {
      const px = coordinate(x);
      expect(Math.abs(px)).toBeLessThanOrEqual(FARTHEST);
      if (Math.abs(x) <= FARTHEST) expect(Math.abs(px - x)).toBeLessThanOrEqual(0.00501);
    }),
  );
  expect(coordinate(Number.NaN)).toBe(0);
});
