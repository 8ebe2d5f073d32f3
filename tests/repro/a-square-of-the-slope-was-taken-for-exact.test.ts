import { expect, test } from 'vitest';
import { misplaced } from '../unit/math/against-exact.ts';

/*
 * c² = 1.1e-319 has a few digits only, and a d of 1e113 along y makes of them what is no longer
 * negligible.
 */
test('points on a cone as thin as 1e-160, far along its axis', () => {
  const shape = { kind: 'cone', vertex: [0, 0, 0], slope: -3.3e-160 } as const;
  const ray = { origin: [0, 0, 1], direction: [0, -1.73e113, 6.65e-48] } as const;
  expect(misplaced({ shape, ray })).toEqual([]);
});

test('and with E far along it', () => {
  const shape = { kind: 'cone', vertex: [0, 0, 0], slope: 3.3e-160 } as const;
  const ray = { origin: [0, 3e159, 1], direction: [0, 1e20, 6.65e-48] } as const;
  expect(misplaced({ shape, ray })).toEqual([]);
});
