import { expect, test } from 'vitest';
import { derivationFor } from '../../src/check/compose.ts';
import { judge } from '../../src/check/judge.ts';
import { checkOwn } from '../../src/check/own-numbers.ts';
import { question } from '../../src/check/session.ts';
import type { Input } from '../../src/check/types.ts';

const causesOf = (seed: number, number: number, texts: Record<string, string>): string[] =>
  judge(derivationFor(question(seed, number - 1)), texts).causes.map(({ id }) => id);

const CYLINDER: Input = {
  shape: { kind: 'cylinder', center: [1, 0, 2], radius: 2 },
  ray: { origin: [-4, 1, 3], direction: [2, 0.5, -0.3] },
};
const PLANE: Input = {
  shape: { kind: 'plane', normal: [1, 2, -2], point: [4, 0, 1] },
  ray: { origin: [1, 2, 3], direction: [1, -1, 0.5] },
};
const own = (input: Input, texts: Record<string, string>) => {
  const { causes, way, firstWrong } = checkOwn(input, texts);
  return { causes: causes.map(({ id }) => id), way: way?.id, firstWrong: firstWrong?.id };
};

test('t₂ = t₁ is not "the roots swapped": t₁ is right', () => {
  expect(causesOf(7, 6, { t1: '-3', t2: '-3' })).toEqual([]);
  expect(own(CYLINDER, { t1: '1.537', t2: '1.537' })).toEqual({ causes: [], firstWrong: 't2' });
});

test.each([
  [123, 'D'],
  [7, 'C'],
])('seed %i: with line %s rightly found, only the cure is wrong', (seed, line) => {
  expect(causesOf(seed, 16, { line, cure: 'stable' })).toEqual([]);
});

test('N normalised throughout is another way, not N·E in place of N·(E − P)', () => {
  const texts = { 'N.(E-P)': '-1', 'N.d': '-2/3', t1: '-1.5', P1: '-0.5, 3.5, 2.25' };
  expect(own(PLANE, texts)).toEqual({ causes: [], way: 'unit-normal' });
  expect(own(PLANE, { 'N.(E-P)': '-6', 'N.d': '-4', t1: '-1.5' })).toEqual({
    causes: [],
    way: 'other-normal',
  });
});

test('half b, carried through, is another way', () => {
  const half = { A: '4.09', B: '-10.3', C: '22', D: '16.11', t1: '1.537', t2: '3.4995' };
  expect(own(CYLINDER, half)).toEqual({ causes: [], way: 'half-b' });
  expect(own(CYLINDER, { A: '4.09', B: '-10.3', C: '22' })).toEqual({
    causes: ['half-b'],
    firstWrong: 'B',
  });
  const whole = { ...half, B: '-20.6' };
  expect(own(CYLINDER, whole)).toEqual({ causes: [], way: 'quarter-d' });
  expect(own(CYLINDER, { ...half, C: '30', D: '-16.61', t1: '-', t2: '-' })).toEqual({
    causes: ['plus-r2'],
    way: 'half-b',
    firstWrong: 'C',
  });
});

test('with t right, P = E − t d happens on the line P', () => {
  const lines = { 'N.(E-P)': '-3', 'N.d': '-2', t1: '-1.5' };
  expect(own(PLANE, { ...lines, P1: '2.5, 0.5, 3.75' }).causes).toEqual(['flat-backwards']);
  expect(own(PLANE, { ...lines, P1: '-1.5, 1.5, -0.75' }).causes).toEqual(['flat-from-origin']);
});

test('two mistakes at once are both named', () => {
  expect(causesOf(123, 4, { A: '5', B: '2', C: '34' })).toEqual(['half-b', 'plus-r2']);
});

test.each([
  ['(−B ± √D)/2 · A, as a program has it', { t1: '384', t2: '896' }, ['times-a']],
  ['−B ± √D/2A', { A: '16', B: '-80', t1: '79', t2: '81' }, ['only-root-over-2a']],
  ['the root forgotten', { D: '1024', t1: '-29.5', t2: '34.5' }, ['no-root']],
  ['√D for D', { D: '32', t1: '1.5', t2: '3.5' }, ['root-for-d']],
  ['a quarter of D', { B: '-80', D: '256', t1: '2', t2: '3' }, ['quarter-d']],
])('named: %s', (_, texts, expected) => {
  const input: Input = {
    shape: { kind: 'cylinder', center: [0, 0, 0], radius: 4 },
    ray: { origin: [-10, 0, 0], direction: [4, 0, 0] },
  };
  expect(own(input, texts as Record<string, string>).causes).toEqual(expected);
});

test('named: C/B for −C/B, a tangent taken for a miss, P − E for E − P', () => {
  const linear: Input = {
    shape: { kind: 'cone', vertex: [0, 0, 0], slope: 1 },
    ray: { origin: [3, 1, 0], direction: [1, 1, 0] },
  };
  expect(own(linear, { A: '0', B: '4', C: '8', t1: '2' }).causes).toEqual(['linear-sign']);
  const touching: Input = {
    shape: { kind: 'cylinder', center: [0, 0, 0], radius: 2 },
    ray: { origin: [-4, 0, 2], direction: [1, 0, 0] },
  };
  const none = { A: '1', B: '-8', C: '16', D: '0', t1: 'none', t2: 'none' };
  expect(own(touching, none).causes).toEqual(['strict']);
  const turned = { 'N.(E-P)': '3', 'N.d': '-2', t1: '1.5', P1: '2.5, 0.5, 3.75' };
  expect(own(PLANE, turned).causes).toEqual(['flat-P-minus-E']);
});
