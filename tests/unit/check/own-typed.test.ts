import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { courseOf } from '../../../src/check/course.ts';
import { checkOwn, ownFields } from '../../../src/check/own-numbers.ts';
import { ABSENT, type Answer, type Input } from '../../../src/check/types.ts';
import { work } from '../../../src/check/work.ts';
import { rayOf, shapeOf } from '../../../src/state/state.ts';
import { typedValues } from '../../../src/state/typed-values.ts';
import { decode } from '../../../src/state/url.ts';
import {
  dot,
  type Fraction,
  fraction,
  from,
  minus,
  type Point,
  plus,
  sign,
  times,
} from '../state/fraction.ts';
import { borderScene, type FractionScene, KINDS, linkOf } from '../state/typed-scenes.ts';

const SEED = 30103;

function inputOf(link: string): Input {
  const state = decode(link);
  const shape = shapeOf(state);
  const typed = typedValues({ ...state, shape, texts: state.typed });
  return { shape, ray: rayOf(state), typed };
}

const exactly = ({ n, d }: Fraction): string => `${n}/${d}`;

/** The first lines by hand, in fractions. */
function byHand({ kind, E, d, points, scalars }: FractionScene): Record<string, string> {
  const zero = fraction(0);
  if (points.N || kind === 'square') {
    const N = points.N ?? [zero, zero, fraction(1)];
    const offset = dot(N, from(E, points.P ?? points.C ?? E));
    return { 'N.(E-P)': exactly(offset), 'N.d': exactly(dot(N, d)) };
  }
  const { c, r, a: flare } = scalars;
  const a = kind === 'cone' && c ? times(c, c) : (flare ?? zero);
  const p = from(E, points.V ?? points.C ?? E);
  const form = (u: Point, v: Point): Fraction =>
    minus(plus(times(u[0], v[0]), times(u[2], v[2])), times(a, u[1], v[1]));
  const [A, B] = [form(d, d), times(fraction(2), form(d, p))];
  const C = minus(form(p, p), r ? times(r, r) : zero);
  const D = minus(times(B, B), times(fraction(4), A, C));
  const t = sign(A) !== 0 && sign(D) === 0 ? { t1: `-(${exactly(B)})/(2*(${exactly(A)}))` } : {};
  return { A: exactly(A), B: exactly(B), C: exactly(C), D: exactly(D), ...t };
}

function asText(value: Answer | undefined): string {
  if (value === undefined) return '';
  return typeof value === 'object' ? value.join(', ') : String(value);
}

describe.each(KINDS)(`%s: 40 scenes on borders, seed ${SEED}`, (kind) => {
  test('what is right in fractions is right', () => {
    fc.assert(
      fc.property(borderScene(kind), (scene) => {
        const report = checkOwn(inputOf(linkOf(scene)), byHand(scene));
        expect(report.lines.filter(({ verdict }) => verdict !== 'correct')).toEqual([]);
        expect(report.causes).toEqual([]);
      }),
      { seed: SEED, numRuns: 40 },
    );
  });

  test('what is right for the stored doubles is right', () => {
    fc.assert(
      fc.property(borderScene(kind), (scene) => {
        const input = inputOf(linkOf(scene));
        const { shape, ray } = input;
        const found = work(courseOf(shape), { shape, ray });
        const texts = ownFields(input).map(({ id }) => [id, asText(found[id])] as const);
        const usable = texts.filter(([, text]) => text !== '' && text !== ABSENT);
        const report = checkOwn(input, Object.fromEntries(usable));
        expect(report.firstWrong).toBeNull();
        expect(report.causes).toEqual([]);
      }),
      { seed: SEED, numRuns: 40 },
    );
  });
});

describe('the rim of a circle in tenths', () => {
  const rim = inputOf('#/explore?shape=circle&N=0,0,1&C=0,0,0&r=0.5&E=0.3,0.4,2&d=0,0,-1');
  const lines = { 'N.(E-P)': '2', 'N.d': '-1', t1: '2', P1: '0.3, 0.4, 0' };

  test('both answers are right, and it is said for which numbers', () => {
    const inside = checkOwn(rim, { ...lines, inside: 'inside' });
    expect(inside.firstWrong).toBeNull();
    expect(inside.causes).toEqual([]);
    expect(inside.says).toBe(
      'All that you typed is right. “the point is …” is right for the numbers as typed, ' +
        'not for the doubles that store them.',
    );
    const outside = checkOwn(rim, { ...lines, inside: 'outside' });
    expect(outside.firstWrong).toBeNull();
    expect(outside.says).toContain('right for the doubles that store the numbers');
  });

  test('a wrong line is still wrong', () => {
    const report = checkOwn(rim, { ...lines, 'N.d': '1', inside: 'inside' });
    expect(report.firstWrong?.id).toBe('N.d');
  });
});

test('a generator of a cone of slope 1/3: A = B = C = 0', () => {
  const cone = inputOf('#/explore?shape=cone&V=0,0,0&c=1/3&E=1,3,0&d=1,3,0');
  const report = checkOwn(cone, { A: '0', B: '0', C: '0', D: '0', t1: '-' });
  expect(report.lines.map(({ verdict }) => verdict)).not.toContain('wrong');
  expect(report.says).toContain('right for the numbers as typed');
});

test('a unit d is typed before it is rounded', () => {
  const cone = inputOf('#/explore?shape=cone&V=0,0,0&c=5/7&E=3,7,4&d=3,7,4&unit=1');
  expect(checkOwn(cone, { A: '0', B: '0', C: '0' }).firstWrong).toBeNull();
});
