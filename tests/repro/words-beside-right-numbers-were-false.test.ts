import { expect, test } from 'vitest';
import { createDerive } from '../../src/state/derive.ts';
import { exploreDetails } from '../../src/state/explore-details.ts';
import { GALLERY } from '../../src/state/gallery/index.ts';
import { INITIAL } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';

const open = (link: string) => createDerive(() => exploreDetails)(decode(`#/explore?${link}`));
const verdict = (link: string) => open(link).verdict.text;
const graph = (link: string) => open(link).graph.stretches.map(({ place }) => place);

/* "The textbook formula says it misses" stood beside "D = 0, tangent: one double root". */
test('what a caption says of the textbook formula is what it gives', () => {
  const far = GALLERY.find(({ id }) => id === 'cylinder-far');
  const model = createDerive(() => exploreDetails)(decode(far?.link ?? ''));
  expect([far?.answer.includes('textbook formula says that it misses'), model.found.class]).toEqual(
    [true, 'none'],
  );
  const before = decode(
    '#/explore?shape=cylinder&C=0,1,0&r=1&E=100000000,1,0.5&d=-1,0,0&method=textbook',
  );
  expect([before.problems, before.E]).toEqual([[], [1e8, 1, 0.5]]);
});

test('a point on the rim or on an edge was called inside', () => {
  expect(verdict('shape=circle&N=1,0,0&C=0,1,0&r=2&E=3,1,2&d=-1,0,0')).toContain('on the rim');
  expect(verdict('shape=square&P=0,0,-1&L=2&axis=x&E=3,2,0&d=-1,0,0')).toContain('on an edge');
});

test('a ray that stays inside for ever was said to miss', () => {
  const link = 'shape=hyperboloid&a=1&E=0.5,4,0.25&d=0,-1,0';
  expect(verdict(link)).toBe('no point: the ray stays inside for ever');
  expect(graph(link)).toEqual(['behind', 'inside']);
});

test('the graph said before where the ray had left, had no root, or lay in the surface', () => {
  expect(graph('shape=cone&V=0,3,0&c=0.5&E=1,0,0&d=-0.125,1,0.125')).toEqual([
    'behind',
    'inside',
    'outside',
    'inside',
  ]);
  expect(graph('shape=cylinder&C=0,1,0&r=1.5&E=2.5,4,0&d=0,-1,0')).toEqual(['behind', 'outside']);
  expect(graph('shape=cylinder&C=0,1,0&r=1.5&E=1.5,4,0&d=0,-1,0')).toEqual(['behind', 'on it']);
  // Two roots behind E: "behind behind behind".
  expect(graph('shape=cylinder&C=0,1,0&r=1.5&E=3,1,0.5&d=1,0,0.25')).toEqual(['behind', 'outside']);
});

test('a sphere, an ellipsoid and a bare axis were called by the name of their formula', () => {
  const name = (link: string) => open(link).title;
  expect(name('shape=hyperboloid&a=-1&r=2.5')).toBe('sphere');
  expect(name('shape=hyperboloid&a=-0.25&r=1')).toBe('ellipsoid');
  expect(name('shape=hyperboloid&a=0&r=1')).toBe('cylinder');
  expect(name('shape=cone&c=0')).toBe('axis');
  expect(open('shape=hyperboloid&a=-0.25&r=1').scene.description).toContain('and an ellipsoid: ');
});

test('a sphere and an ellipsoid were refused without a word of how to get one', () => {
  expect(open('shape=sphere').title).toBe('sphere');
  expect(decode('#/explore?shape=sphere', INITIAL).problems).toEqual([]);
  const [said] = decode('#/explore?shape=ellipsoid', INITIAL).problems;
  expect(said).toBe("opened without shape: 'ellipsoid' is called a hyperboloid with a < 0 here");
  expect(decode('#/explore?shape=constructor').problems).toEqual([
    "opened without shape: 'constructor' is not a shape",
  ]);
});

test('a ray through a figure in its plane was not said from which t to which t', () => {
  const square = 'shape=square&P=0,0,0&L=1&axis=z&E=-1,0.5,0&d=1,0,0';
  const { pieces, text } = open(square).verdict;
  expect(text).toBe('the line lies in the plane and in the square from t = 1 to t = 2');
  expect(pieces).toContainEqual({ quantity: 't.from', value: 1 });
  expect(pieces).toContainEqual({ quantity: 't.to', value: 2 });
});

test('a method whose bounds hold both signs was said to overflow', () => {
  const link = 'shape=cylinder&C=0,0,0&r=0.1&E=3,0,0.1&d=-0.7,0,0&method=interval';
  expect(verdict(link)).toBe('cannot decide: the sign of D is not certain');
});
