import { expect, test } from 'vitest';
import { whereLost, whyLost } from '../../src/lab/explain.ts';
import { lossesOf, type StepLoss } from '../../src/lab/losses.ts';
import { thisRay } from '../../src/lab/this-ray.ts';
import { METHODS } from '../../src/math/methods/index.ts';
import { INITIAL, rayOf, shapeOf } from '../../src/state/state.ts';
import { decode } from '../../src/state/url.ts';

/*
 * "Where did the digits go?" said of B² − 4 A C that came out as 0 that it is smaller than the
 * smallest number there is, while exactly it was 3.64. Sums do not underflow.
 */
const linked = (link: string) => {
  const state = decode(link, INITIAL);
  expect(state.problems).toEqual([]);
  const method = METHODS.find(({ id }) => id === state.method) ?? METHODS[0];
  const [shape, ray] = [shapeOf(state), rayOf(state)];
  const losses = lossesOf(method, shape, ray);
  const row = thisRay(shape, ray).rows.find((one) => one.method.id === state.method);
  return { losses, brief: row ? whereLost(row, losses) : '', worst: losses.worst };
};

test.each([
  [
    '#/accuracy?shape=cylinder&E=1e8,0,0.3&d=-1,0,0&C=0,0,0&r=1&method=textbook',
    'B² − 4 A C',
    '3.64',
  ],
  [
    '#/accuracy?shape=cylinder&E=1e5,0,0.3&d=-1,0,0&C=0,0,0&r=1&method=textbook32',
    'B² − 4 A C',
    '',
  ],
  [
    '#/accuracy?shape=cylinder&E=5,0,1-2^-53&d=-1,0,0&C=0,0,0&r=1&method=textbook',
    'B² − 4 A C',
    '',
  ],
])('a sum that cancels to nothing did not underflow: %s', (link, text, difference) => {
  const { worst, brief } = linked(link);
  expect(worst?.text).toBe(text);
  expect(worst?.cause?.kind).toBe('total');
  expect(brief).toBe(`${text}: all digits cancel`);
  expect(whyLost(worst as StepLoss)).toContain(
    `all leading digits of B² and 4 A C agree; the difference, ${difference}`,
  );
});
