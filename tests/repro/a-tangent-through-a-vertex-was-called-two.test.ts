import { expect, test } from 'vitest';
import { accelerate, decelerate } from '../../src/math/accelerate.ts';
import { unlike } from '../fuzz/unlike.ts';
import { disagreement } from '../unit/math/against-exact.ts';

/*
 * The bound of f on grids spoke of the point's leading parts alone. Where these are 0, at the
 * vertex of a cone as thin as a hair, what was left over of a coordinate is all there is, and its
 * rounding made D positive.
 */
const shape = { kind: 'cone', vertex: [1.5, -1, -1.5], slope: 1.1409811e-14 } as const;
const ray = { origin: [1.5, 15.5, 16.5], direction: [0, -2.75, -3] } as const;

test('a ray through the vertex of a very thin cone is a tangent', () => {
  expect(disagreement(shape, ray)).toBeNull();
  expect(unlike({ shape, ray })).toBeNull();
});

test('and so with WebAssembly', () => {
  accelerate();
  try {
    expect(disagreement(shape, ray)).toBeNull();
  } finally {
    decelerate();
  }
});
