import Decimal from 'decimal.js';
import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { intersect } from '../../../src/math/index.ts';
import { asTyped } from '../../../src/state/as-typed.ts';
import { rayOf, shapeOf } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';
import { verdictWords } from '../../../src/state/verdict-words.ts';
import { parseNumber } from '../../../src/text/parse.ts';
import {
  cross,
  dot,
  type Fraction,
  fraction,
  from,
  minus,
  over,
  plus,
  sign,
  times,
} from './fraction.ts';
import { borderScene, type FractionScene, KINDS, linkOf } from './typed-scenes.ts';

const SEED = 16180;

/**
 * What the page says of a link: the case of the typed numbers, and whether it is another one than
 * that of the stored.
 */
function saidOf(link: string) {
  const state = decode(link);
  expect(state.problems).toEqual([]);
  const [shape, ray] = [shapeOf(state), rayOf(state)];
  const found = intersect(shape, ray, 'exact');
  const said = asTyped({ ...state, texts: state.typed, shape }, ray, found);
  const stored = verdictWords(found, shape, ray);
  const { differs, notes } = said;
  return {
    differs,
    notes,
    stored,
    class: differs?.class ?? found.class,
    text: (differs?.typed ?? stored).text,
  };
}

/** What has to be in the words, and what may not be. */
interface Expected {
  readonly class: string;
  readonly words: Readonly<Record<string, boolean>>;
}

const four = fraction(4);
const two = fraction(2);

/** (x−Cx)² + (z−Cz)² = a(y−Cy)² + ρ. */
function curved({ kind, E, d, points, scalars }: FractionScene): Expected {
  const zero = fraction(0);
  const { c, r, a: flare } = scalars;
  const a = kind === 'cone' && c ? times(c, c) : (flare ?? zero);
  const rho = r ? times(r, r) : zero;
  const p = from(E, points.V ?? points.C ?? E);
  const form = (u: typeof E, v: typeof E): Fraction =>
    minus(plus(times(u[0], v[0]), times(u[2], v[2])), times(a, u[1], v[1]));
  const [A, B, C] = [form(d, d), times(two, form(d, p)), minus(form(p, p), rho)];
  const D = sign(minus(times(B, B), times(four, A, C)));
  const linear = sign(B) !== 0 ? 'one' : sign(C) === 0 ? 'contained' : 'none';
  const quadratic = D > 0 ? 'two' : D === 0 ? 'tangent' : 'none';
  const verdict = sign(A) === 0 ? linear : quadratic;
  const hit = ['two', 'tangent', 'one'].includes(verdict);
  const atE = sign(C) === 0 && (verdict !== 'tangent' || sign(B) === 0);
  return {
    class: verdict,
    words: {
      'E itself': hit && atE,
      'inside for ever: no root': verdict === 'none' && sign(A) === 0 && sign(C) < 0,
    },
  };
}

function flat(scene: FractionScene): Expected {
  const { E, d, points, scalars, kind } = scene;
  const [zero, one] = [fraction(0), fraction(1)];
  const N = points.N ?? [zero, zero, one];
  const p = from(E, points.P ?? points.C ?? E);
  const [rate, offset] = [dot(N, d), dot(N, p)];
  if (sign(rate) === 0) {
    if (sign(offset) !== 0) return { class: 'none', words: { beside: true } };
    const meets = kind === 'plane' ? null : kind === 'circle' ? byRim(scene) : byCorners(scene);
    const words = { 'passes beside': meets === 'beside', touches: meets === 'touches' };
    return { class: 'contained', words };
  }
  const t = over(times(fraction(-1), offset), rate);
  const x = ([0, 1, 2] as const).map((i) => plus(p[i], times(t, d[i])));
  const sides =
    kind === 'plane'
      ? []
      : kind === 'circle'
        ? [minus(plus(...x.map((c) => times(c, c))), times(scalars.r ?? zero, scalars.r ?? zero))]
        : x.slice(0, 2).flatMap((c) => [times(fraction(-1), c), minus(c, scalars.L ?? zero)]);
  const inside = sides.every((side) => sign(side) <= 0);
  const equal = sides.filter((side) => sign(side) === 0).length;
  return {
    class: inside ? 'one' : 'none',
    words: {
      'at E itself': sign(t) === 0,
      'on the rim': inside && kind === 'circle' && equal === 1,
      'on an edge': inside && kind === 'square' && equal === 1,
      'at a corner': inside && kind === 'square' && equal === 2,
    },
  };
}

type Meets = 'beside' | 'touches' | 'crosses';

function byRim({ E, d, points, scalars }: FractionScene): Meets {
  const m = cross(d, from(E, points.C ?? E));
  const r = scalars.r ?? fraction(0);
  const side = sign(minus(dot(m, m), times(r, r, dot(d, d))));
  return side > 0 ? 'beside' : side === 0 ? 'touches' : 'crosses';
}

function byCorners({ E, d, points, scalars }: FractionScene): Meets {
  const p = from(E, points.P ?? E);
  const L = scalars.L ?? fraction(0);
  const ends = [fraction(0), L];
  const signs = ends.flatMap((u) =>
    ends.map((v) => sign(minus(times(d[0], minus(v, p[1])), times(d[1], minus(u, p[0]))))),
  );
  if (signs.every((s) => s > 0) || signs.every((s) => s < 0)) return 'beside';
  const one = signs.filter((s) => s === 0).length === 1;
  return one && Math.abs(signs.reduce<number>((a, b) => a + b, 0)) === 3 ? 'touches' : 'crosses';
}

const expected = (scene: FractionScene): Expected =>
  ['plane', 'circle', 'square'].includes(scene.kind) ? flat(scene) : curved(scene);

/** '0.3 is 0.29999999999999998890', to the last digit. */
function expectExpansions(because: string): void {
  const each = because.replace(/, and \d+ more$/, '').split(', ');
  for (const one of each) {
    const [text = '', digits = ''] = one.split(' is ');
    const stored = parseNumber(text);
    const shown = new Decimal(plainOf(digits));
    expect(
      stored.ok && new Decimal(stored.value.toPrecision(100)).toSignificantDigits(20).eq(shown),
    ).toBe(true);
  }
}

const plainOf = (digits: string): string => {
  const [, mantissa = '', power] = /^([−\d.]+)(?: · 10(.+))?$/.exec(digits) ?? [];
  const exponent = [...(power ?? '⁰')].map((c) => (c === '⁻' ? '-' : '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c)));
  return `${mantissa.replace('−', '-')}e${exponent.join('')}`;
};

describe('the case of the typed numbers, against fractions', () => {
  test.each(KINDS)(`%s: 150 scenes on borders and beside them, seed ${SEED}`, (kind) => {
    let differing = 0;
    fc.assert(
      fc.property(borderScene(kind), (scene) => {
        const said = saidOf(linkOf(scene));
        const { class: verdict, words } = expected(scene);
        expect(said.class).toBe(verdict);
        for (const [word, there] of Object.entries(words)) {
          expect([word, said.text.includes(word)]).toEqual([word, there]);
        }
        if (said.differs) {
          differing++;
          expect(said.differs.typed.text).not.toBe(said.differs.stored.text);
          expect(said.differs.stored.text).toBe(said.stored.text);
          expectExpansions(said.differs.because);
        }
        expect(said.notes).toEqual([]);
      }),
      { seed: SEED, numRuns: 150 },
    );
    expect(differing).toBeGreaterThan(10);
  });
});

describe('roots', () => {
  test.each([
    ['shape=cone&V=0,0,0&c=tan(30 deg)&E=1,sqrt(3),0&d=1,√3,0', 'contained'],
    ['shape=cylinder&C=0,0,0&r=sqrt(2)&E=1,5,1&d=1,0,-1', 'tangent'],
    ['shape=cylinder&C=0,0,0&r=sqrt(8)/2&E=sqrt(2),0,0&d=0,1,0', 'contained'],
    ['shape=cylinder&C=0,0,0&r=1&E=sqrt(2)/2,0,√(1/2)&d=0,1,0', 'contained'],
    ['shape=cylinder&C=0,0,0&r=1&E=sin(45°),0,cos(45°)&d=1,0,-1', 'tangent'],
    ['shape=circle&N=0,0,1&C=0,0,0&r=sqrt(2)/10&E=0.1,0.1,2&d=0,0,-1', 'one'],
    ['shape=circle&N=0,0,1&C=0,0,0&r=sqrt(3)&E=sqrt(2),1,2&d=0,0,-1', 'one'],
    ['shape=plane&N=0,√2/2,√(1/2)&P=0.1,0,0&E=.3,-1.1,1.1&d=.2,.3,-.3', 'contained'],
    ['shape=square&axis=z&P=0,0,0&L=sqrt(2)&E=√8/2,0.5,1&d=0,0,-1', 'one'],
    // Two different roots are told apart by bounds.
    ['shape=cylinder&C=0,0,0&r=1&E=sqrt(2),0,sqrt(3)&d=-1,0,-1', 'two'],
    ['shape=cylinder&C=0,0,0&r=1&E=sqrt(2),0,sqrt(3)&d=0,1,0', 'none'],
  ])('%s: %s', (pairs, verdict) => {
    const { class: said, notes } = saidOf(`#/explore?${pairs}`);
    expect([said, notes]).toEqual([verdict, []]);
  });

  test('whose case is open are said to be rounded', () => {
    const { differs, notes } = saidOf(
      '#/explore?shape=cylinder&C=0,0,0&r=sqrt(5+2*sqrt(6))&E=sqrt(2)+sqrt(3),0,0&d=0,0,1',
    );
    expect(differs).toBeNull();
    expect(notes.join(' ')).toContain('sqrt(2)+sqrt(3) is 3.1462643699419725607');
  });
});

describe('what is no fraction and no root', () => {
  test('is said to be rounded', () => {
    const { differs, notes } = saidOf('#/explore?shape=cylinder&r=pi&C=0,0,0&E=pi,0,0&d=0,0,1');
    expect(differs).toBeNull();
    expect(notes).toEqual(['Rounded to doubles: pi is 3.1415926535897931160.']);
  });

  test('and the rest is taken as typed all the same', () => {
    const { differs, notes } = saidOf(
      '#/explore?shape=circle&N=0,0,1&C=0,0,0&r=0.5&E=0.3,0.4,pi&d=0,0,-1',
    );
    expect(differs?.class).toBe('one');
    expect(notes).toHaveLength(1);
  });

  test('an angle without a unit is said to be in radians', () => {
    const { notes } = saidOf('#/explore?shape=cone&c=tan(30)');
    expect(notes[0]).toBe('c: tan is taken in radians; tan(30 deg) in degrees.');
  });
});

describe('a unit d', () => {
  test('is typed before it is rounded', () => {
    const pairs = 'shape=cone&V=0,0,0&c=5/7&E=3,7,4&d=3,7,4&unit=1';
    const { differs, stored } = saidOf(`#/explore?${pairs}`);
    expect(differs?.class).toBe('contained');
    expect(stored.text).not.toContain('every t');
    const whole = saidOf('#/explore?shape=cone&V=0,0,0&c=1.25&E=3,4,4&d=3,4,4&unit=1');
    expect(whole.class).toBe('contained');
  });

  test('counts t in lengths', () => {
    const pairs = 'shape=circle&N=1,1,0&C=0,0,0&r=sqrt(2)&E=1,-1,2&d=0,0,-4&unit=1';
    const { differs } = saidOf(`#/explore?${pairs}`);
    expect(differs?.typed.text).toContain('touches the circle at t = 2');
  });
});

describe('nothing is said', () => {
  test('where the typed numbers are no ray or no shape', () => {
    for (const pairs of [
      'd=0.1+0.2-0.3,0,0',
      'N=0,0.1%2B0.2-0.3,0',
      'd=0.1%2B0.2-0.3,0,0&unit=1',
    ]) {
      const { differs, notes } = saidOf(`#/explore?shape=plane&P=0,0,0&E=1,1,1&${pairs}`);
      expect([differs, notes]).toEqual([null, []]);
    }
  });

  test.each([
    ['of doubles that nobody typed', 'E=0.30000000000000004,0.4,2&d=0,0,-1'],
    ['of whole numbers and halves', 'E=0.5,0,2&d=0,0,-1'],
    ['where the case is the same', 'E=0.6,0.1,2&d=0,0,-1'],
  ])('%s', (_, pairs) => {
    const { differs, notes } = saidOf(`#/explore?shape=circle&N=0,0,1&C=0,0,0&r=0.5&${pairs}`);
    expect([differs, notes]).toEqual([null, []]);
  });
});
