import { describe, expect, test } from 'vitest';
import { judgeGuess, whyNoGuess } from '../../../src/lesson/judge.ts';
import type { Guess } from '../../../src/lesson/lesson.ts';
import { quantityOf } from '../../../src/lesson/quantities.ts';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { decode } from '../../../src/state/url.ts';

// A = 25/16, B = −15/2, C = 135/16: D = 225/64, the roots are 1.8 and 3.
const LINK = '#/explore?shape=cylinder&C=0,1,0&r=1.25&E=3,1,1&d=-1,-0.25,-0.75';
const model = createDerive(() => exploreDetails)(decode(LINK));
const onExplore = { model, value: (name: string) => quantityOf(model, name) };
const words = (guess: Guess, given: string): string => judgeGuess(guess, given, onExplore).words;
const of = (quantity: string): Guess => ({ type: 'quantity', quantity });

describe('a number that Check asks for is marked by its rules', () => {
  test.each([
    ['t1', '1.8', 'Your guess 1.8: right'],
    ['t1', '9/5', 'Your guess 9/5: right'],
    ['D', '3.516', 'Your guess 3.516: right'],
    ['D', '3.5', 'Your guess 3.5: right to 2 digits, give two more'],
    ['t1', '2', 'Your guess 2: too large by 0.2'],
    ['B', '7.5', 'Your guess 7.5: too large by 15'],
    ['P1', '1.2,0.55,-0.35', 'Your guess 1.2,0.55,-0.35: right'],
    ['N1', '12,0,-3.5', 'Your guess 12,0,-3.5: right'],
    ['N1', '1,1,1', 'Your guess 1,1,1: not so'],
  ])('%s = %s', (quantity, given, said) => {
    expect(words(of(quantity), given)).toBe(said);
  });

  test('a known mistake that gives the number is named', () => {
    const { causes } = judgeGuess(of('t1'), '3.6', onExplore);
    expect(causes.map(({ says }) => says)).toEqual(['(−B ± √D)/A in place of (−B ± √D)/2A']);
  });

  test('what is no number is refused with its words', () => {
    expect(whyNoGuess('1,2', of('P1'), model)).toMatch(/three/);
    expect(whyNoGuess('one', of('t1'), model)).toMatch(/one/);
    expect(whyNoGuess('1.8', of('t1'), model)).toBeNull();
  });
});

test('a prediction is judged as on Explore', () => {
  expect(words({ type: 'prediction', ask: 'points' }, '1')).toBe(
    'Your guess, 1: not so. There are 2 points: you said 1 too few.',
  );
  expect(words({ type: 'prediction', ask: 'first' }, 't1')).toBe(
    'Your guess, t₁: right. t₁ = 1.8, t₂ = 3: t₁ is the first with t ≥ 0.',
  );
  expect(words({ type: 'prediction', ask: 'sign' }, '+')).toBe(
    'Your guess, D > 0: right. D = 3.51563.',
  );
  expect(whyNoGuess('t1', { type: 'prediction', ask: 'first' }, model)).toBeNull();
});

test('a class is said in the words of the page', () => {
  const guess: Guess = { type: 'class', quantity: 'class' };
  expect(words(guess, 'two')).toBe('Your guess, two points: right');
  expect(words(guess, 'none')).toBe('Your guess, no point: it is two points');
  expect(whyNoGuess('two', guess, model)).toBeNull();
});

test('a number of what is free, and one of another page, by how far it was off', () => {
  const free: Guess = { type: 'free', truth: 1 };
  expect(words(free, '0.8')).toBe('Your guess 0.8: too small by 0.2');
  expect(words(free, '1')).toBe('Your guess 1: right');
  const beside = { model: null, value: () => 12_110 };
  expect(judgeGuess(of('shadow.rays'), '12000', beside).words).toBe(
    'Your guess 12000: too small by 110',
  );
  // The picture is not traced yet.
  const waiting = { model: null, value: () => null };
  expect(judgeGuess(of('shadow.rays'), '12000', waiting).words).toBe('Your guess: 12000');
});
