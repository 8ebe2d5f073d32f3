import { describe, expect, test } from 'vitest';
import { inSymbols, LATEX, walkOf, walkSide } from '../../src/math/formula.ts';
import { intersect } from '../../src/math/index.ts';
import { SHAPES } from '../../src/math/shapes/index.ts';
import { initialShape } from '../../src/state/state.ts';
import { CASES } from '../browser/support/cases.ts';

/* What a walk says, for every shape and every class of answer that the course has. */

const textsOf = (steps: ReturnType<typeof walkOf>): string[] =>
  steps.flatMap(({ name, why, lines }) => [
    name,
    why,
    ...lines.flatMap(({ left, right }) =>
      [left, right].map((side) => inSymbols(walkSide(side), LATEX)),
    ),
  ]);

function expectWhole(steps: ReturnType<typeof walkOf>): void {
  for (const text of textsOf(steps)) {
    expect(text.trim()).not.toBe('');
    expect(text).not.toMatch(/NaN|undefined|null|Infinity|\[object/);
  }
  for (const { name, lines } of steps) expect(lines.length, name).toBeGreaterThan(0);
  const names = steps.map(({ name }) => name);
  expect(new Set(names).size).toBe(names.length);
}

describe.each(SHAPES.map(({ kind }) => kind))('%s', (kind) => {
  test.each([false, true])('every text of its walk is whole, straight line: %s', (linear) => {
    expectWhole(walkOf(initialShape(kind), linear));
  });
});

test.each(CASES)('$shape.kind, $title: the walk is the one of its A', ({ shape, ray }) => {
  const { details } = intersect(shape, ray, 'exact');
  const linear = details.family === 'curved' && details.signs.A === 0;
  const steps = walkOf(shape, linear);
  expectWhole(steps);
  const names = steps.map(({ name }) => name);
  expect(names.includes('A = 0')).toBe(linear);
  expect(names.includes('square')).toBe(details.family === 'curved' && !linear);
});

test('the cases hold straight lines of more than one shape', () => {
  const straight = CASES.filter(({ shape, ray }) => {
    const { details } = intersect(shape, ray, 'exact');
    return details.family === 'curved' && details.signs.A === 0;
  });
  expect(new Set(straight.map(({ shape }) => shape.kind)).size).toBeGreaterThan(2);
});
