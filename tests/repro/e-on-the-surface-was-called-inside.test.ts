import { expect, test } from 'vitest';
import { intersect } from '../../src/math/index.ts';
import { verdictWords } from '../../src/state/verdict-words.ts';

/*
 * A ray that starts on a cylinder and leaves it: "E is inside, the ray leaves" stood beside t₂ = 0.
 */
test('E on the surface is not inside', () => {
  const cylinder = { kind: 'cylinder', center: [0, 0, 0], radius: 1 } as const;
  const ray = { origin: [1, 0, 0], direction: [1, 0, 0] } as const;
  const found = intersect(cylinder, ray);
  expect(found.hits.map(({ t }) => t)).toEqual([-2, 0]);
  expect(verdictWords(found, cylinder, ray).text).not.toContain('inside');
});
