import { expect, test } from 'vitest';
import { misplaced } from '../unit/math/against-exact.ts';

/*
 * A underflowed to 0 where t is long enough for A·δ to count: the step to the exact root was a
 * millionth too long, and its bound did not know.
 */
test.each([-4.75e-176, -4.75e-170, -4.75e-200, 3e-161])(
  'the points and normals on a far cylinder, d = %d',
  (dx) => {
    const shape = { kind: 'cylinder', center: [-24246075984, 0, 0], radius: 1 } as const;
    const ray = { origin: [0, 0, 0.172], direction: [dx, 0, 0] } as const;
    expect(misplaced({ shape, ray })).toEqual([]);
  },
);
