import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { walkLength } from '../../../src/math/formula.ts';
import { SHAPES } from '../../../src/math/index.ts';
import { INITIAL, initialShape, PAGES, shapeOf } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode, encode } from '../../../src/state/url.ts';
import { anyState } from './random-state.ts';

const SEED = 57721;

describe('a link restores the state, to the bit', () => {
  test(`1000 states of any finite numbers, seed ${SEED}`, () => {
    fc.assert(
      // toEqual compares numbers by Object.is: −0 is not 0.
      fc.property(anyState, (state) => {
        expect(decode(encode(state), INITIAL)).toEqual(state);
      }),
      { seed: SEED, numRuns: 1000 },
    );
  });

  test(`and is the same link again, seed ${SEED}`, () => {
    fc.assert(
      fc.property(anyState, (state) => encode(decode(encode(state))) === encode(state)),
      { seed: SEED, numRuns: 300 },
    );
  });

  test(`after a trip through a program that escapes what it does not know, seed ${SEED}`, () => {
    // What is escaped already it knows.
    const escaped = (link: string) => `#${encodeURI(link.slice(1)).replaceAll('%25', '%')}`;
    const harder = (link: string) => link.replaceAll(',', '%2C').replaceAll('-', '%2d');
    fc.assert(
      fc.property(anyState, (state) => {
        expect(decode(escaped(encode(state)))).toEqual(state);
        expect(decode(harder(encode(state)))).toEqual(state);
      }),
      { seed: SEED, numRuns: 200 },
    );
  });

  test('the other shapes stay as they were', () => {
    const before = update(update(INITIAL, { type: 'shape', kind: 'circle' }), {
      type: 'param',
      key: 'radius',
      value: 0.25,
    });
    const after = decode('#/explore?shape=cone&c=2', before);
    expect(after.shapes.circle).toMatchObject({ radius: 0.25 });
    expect(after.shapes.cone).toMatchObject({ slope: 2 });
  });
});

describe('what was typed', () => {
  const typed = update(INITIAL, {
    type: 'param',
    key: 'slope',
    value: 1 / 3,
    texts: { 'cone.c': '1/3' },
  });

  test('stands in the link, and comes back with the bits', () => {
    expect(encode(typed)).toContain('&c=1/3&');
    const back = decode('#/explore?E=0,3;1/3,√2&c=tan(30°)');
    expect(back.problems).toHaveLength(1);
    const read = decode('#/explore?E=0.3,1/3,√2&c=tan(30°)');
    expect(read.typed).toEqual({ 'E.y': '1/3', 'E.z': '√2', 'cone.c': 'tan(30°)' });
    expect(encode(read)).toContain('E=0.3,1/3,%E2%88%9A2&c=tan(30%C2%B0)');
  });

  test('is the past’s when the number is changed in another way', () => {
    const { typed: texts } = typed;
    expect(texts).toEqual({ 'cone.c': '1/3' });
    expect(update(typed, { type: 'param', key: 'slope', value: 0.5 }).typed).toEqual({});
    expect(update(typed, { type: 'reset', what: { param: 'slope' } }).typed).toEqual({});
    expect(update(typed, { type: 'reset', what: 'all' }).typed).toEqual({});
    expect(update(typed, { type: 'origin', value: [0, 0, 0] }).typed).toBe(texts);
    const elsewhere = update(typed, { type: 'link', hash: '#/explore?shape=plane&E=0,1/7,0' });
    expect(elsewhere.typed).toEqual({ 'cone.c': '1/3', 'E.y': '1/7' });
  });

  test('is kept only where it gives the number, and says more than the number does', () => {
    const put = (value: number, text: string) =>
      update(INITIAL, { type: 'param', key: 'slope', value, texts: { 'cone.c': text } }).typed;
    expect(put(0.25, '1/3')).toEqual({});
    expect(put(0.25, '0.25')).toEqual({});
    expect(put(0.25, ' 0,25 ')).toEqual({});
    expect(put(1e21, '1E+21')).toEqual({});
    expect(put(3, '+3')).toEqual({});
    expect(put(-3, '−3')).toEqual({});
    expect(put(0.25, ' 0,5/2 ')).toEqual({ 'cone.c': '0.5/2' });
  });
});

describe('what a link looks like', () => {
  test('of the first state: only what may not be left out', () => {
    expect(encode(decode('#/explore'))).toBe(`#/explore?shape=cone&method=${INITIAL.method}`);
  });

  test('of an empty visit: its numbers too, as a link without them means other ones', () => {
    const { method } = INITIAL;
    const numbers = 'E=2.5,3,2&d=-2,-1,-1&V=0,2.5,0&c=1';
    expect(encode(INITIAL)).toBe(`#/explore?shape=cone&${numbers}&method=${method}`);
    for (const { kind } of SHAPES) {
      const visit = { ...INITIAL, kind };
      expect(decode(encode(visit))).toEqual(visit);
    }
  });

  test('defaults are left out, the rest is in the course’s symbols', () => {
    const hash = '#/explore?E=4,1,0.5&shape=cone&d=-1,0,0&V=0,0,0&c=0.5&method=textbook';
    expect(encode(decode(hash))).toBe(
      '#/explore?shape=cone&E=4,1,0.5&d=-1,0,0&V=0,0,0&method=textbook',
    );
  });

  test('−0, huge and tiny numbers; no plus sign, which some programs turn into a space', () => {
    const state = decode('#/explore?E=-0,1e300,5e-324&t=1e22&method=exact');
    expect(encode(state)).toBe('#/explore?shape=cone&E=-0,1e300,5e-324&method=exact&t=1e22');
    expect(state.E).toEqual([-0, 1e300, 5e-324]);
  });

  test('unit=1, view and t', () => {
    const state = decode('#/explore?unit=1&view=top&t=-0.5');
    expect(state).toMatchObject({ unit: true, view: 'top', bead: -0.5, problems: [] });
    expect(encode(state)).toMatch(/^#\/explore\?shape=cone&unit=1&method=\w+&view=top&t=-0.5$/);
    const free = decode('#/explore?view=30,-12.5,2');
    expect(free.view).toEqual({ azimuth: 30, elevation: -12.5, zoom: 2 });
    expect(encode(free)).toContain('&view=30,-12.5,2');
    const aimed = decode('#/explore?view=30,-12.5');
    expect(aimed.view).toEqual({ azimuth: 30, elevation: -12.5, zoom: null });
    expect(encode(aimed)).toMatch(/&view=30,-12.5$/);
  });

  test('what is hidden stays so on every page about the ray, and after a reload there', () => {
    const hidden = decode('#/explore?shape=cone&hide=1&ask=points');
    for (const page of PAGES) {
      const { id } = page;
      const ray = 'ray' in page && page.ray === true;
      const there = { ...hidden, page: id };
      expect(/[?&]hide=1/.test(encode(there)), id).toBe(ray);
      if (ray) expect(decode(encode(there)), id).toMatchObject({ revealed: 0, problems: [] });
      expect(encode({ ...there, revealed: null }), id).not.toContain('hide');
    }
  });

  test('hide=1 and what is asked; a link without it leaves hiding as it is', () => {
    const state = decode('#/explore?hide=1&ask=points');
    expect(state).toMatchObject({ revealed: 0, ask: 'points', problems: [] });
    expect(encode(state)).toMatch(/&hide=1&ask=points$/);
    expect(decode('#/explore?shape=plane', state)).toMatchObject({ revealed: 0, ask: null });
    expect(decode('#/explore?hide=0', state).revealed).toBeNull();
    expect(decode('#/explore?ask=why').problems).toEqual([
      "opened without ask: 'why' is nothing to predict",
    ]);
  });

  test('derive=4 opens the derivation there; what is no step of it is quoted', () => {
    const state = decode('#/explore?shape=cone&derive=4');
    expect(state).toMatchObject({ derive: 4, problems: [] });
    expect(encode(state)).toMatch(/&derive=4$/);
    expect(decode('#/explore?shape=cone', state).derive).toBeNull();
    for (const { kind } of SHAPES) {
      const last = walkLength(initialShape(kind));
      expect(decode(`#/explore?shape=${kind}&derive=${last}`).derive).toBe(last);
      const wrong = { 0: '0', [last + 1]: String(last + 1), '2.5': '2.5', '-1': '-1' };
      for (const [text, quoted] of Object.entries(wrong)) {
        const { derive, problems } = decode(`#/explore?shape=${kind}&derive=${text}`);
        expect(derive).toBeNull();
        expect(problems).toEqual([
          `opened without derive: ${quoted} is not a step from 1 to ${last}`,
        ]);
      }
    }
    expect(decode('#/explore?derive=abc').problems.join()).toMatch(/^opened without derive: 'abc'/);
  });

  test.each(SHAPES.map(({ kind }) => kind))('%s: every parameter by its symbol', (kind) => {
    const definition = SHAPES.find((shape) => shape.kind === kind);
    const given = (definition?.params ?? []).map(({ type, symbol }) =>
      type === 'vector' ? `${symbol}=7,8,9` : type === 'axis' ? `${symbol}=z` : `${symbol}=3.5`,
    );
    const state = decode(`#/explore?shape=${kind}&${given.join('&')}&method=exact`);
    expect(state.problems).toEqual([]);
    expect(encode(state)).toBe(`#/explore?shape=${kind}&${given.join('&')}&method=exact`);
  });
});

test('the keys that links are known by stay', () => {
  const keys = SHAPES.map(({ kind, params }) => [kind, params.map(({ symbol }) => symbol)]);
  expect(Object.fromEntries(keys)).toMatchObject({
    plane: ['N', 'P'],
    cylinder: ['C', 'r'],
    cone: ['V', 'c'],
    hyperboloid: ['C', 'a', 'r'],
    circle: ['N', 'C', 'r'],
    square: ['P', 'L', 'axis'],
    sphere: ['C', 'r'],
    paraboloid: ['V', 'k'],
  });
});

describe('links written by hand', () => {
  test.each([
    ['expressions', '#/explore?c=1/3', { slope: 1 / 3 }],
    ['roots', '#/explore?c=sqrt(2)', { slope: Math.SQRT2 }],
    ['powers', '#/explore?c=-2^-40', { slope: -(2 ** -40) }],
    ['expressions in a vector', '#/explore?V=1/2,-sqrt(4),2*3', { vertex: [0.5, -2, 6] }],
    ['spaces, as %20', '#/explore?V=1,%202,%203', { vertex: [1, 2, 3] }],
    ['a true minus, escaped', '#/explore?c=%E2%88%922', { slope: -2 }],
    ['a plus sign in an exponent', '#/explore?c=1e+3', { slope: 1000 }],
  ])('%s', (_, hash, expected) => {
    const state = decode(hash);
    expect(shapeOf(state)).toMatchObject(expected);
    expect(state.problems).toEqual([]);
  });

  test.each(['', '#', '#/', '#?'])('%j is an empty visit', (hash) => {
    expect(decode(hash)).toEqual(INITIAL);
  });

  test.each(['#/explore', '#/explore?', 'explore', '/explore', '#explore?&&&'])(
    '%j is a link, with what links have always meant',
    (hash) => {
      const { E, d, shapes, ...rest } = decode(hash);
      expect({ E, d }).toEqual({ E: [3, 1, 1], d: [-0.8, -0.2, -0.3] });
      expect(shapes.cone).toEqual({ kind: 'cone', vertex: [0, 3, 0], slope: 0.5 });
      expect(rest).toEqual((({ E, d, shapes, ...same }) => same)(INITIAL));
    },
  );

  test('a link without a method has the default one', () => {
    expect(decode('#/explore?shape=plane').method).toBe(INITIAL.method);
  });
});

describe('broken links open what can be opened, and say what was wrong', () => {
  const CASES: [string, string, string][] = [
    ['an unknown page', '#/nowhere', "there is no page 'nowhere'"],
    ['an unknown shape', '#/explore?shape=torus', "opened without shape: 'torus' is not a shape"],
    [
      'an unknown method',
      '#/explore?method=magic',
      "opened without method: 'magic' is not a method",
    ],
    ['a foreign key', '#/explore?q=1', "'q' means nothing for a cone"],
    ['a key of another shape', '#/explore?r=1', "'r' means nothing for a cone"],
    ['no number', '#/explore?c=abc', "opened without c: 'abc' is not a number"],
    ['nothing at all', '#/explore?c=', 'opened without c: type a number, such as 1/3 or sqrt(2)'],
    ['two numbers', '#/explore?E=1,2', "opened without E: '1,2' is not three numbers"],
    ['four numbers', '#/explore?E=1,2,3,4', "opened without E: '1,2,3,4' is not three numbers"],
    ['one bad among three', '#/explore?E=1,x,3', "opened without E: 'x' is not a number"],
    [
      'a zero d',
      '#/explore?d=0,0,0',
      'opened without d: direction must not be zero, got (0, 0, 0)',
    ],
    ['an infinity', '#/explore?c=Infinity', "opened without c: 'Infinity' is infinite"],
    ['1/0', '#/explore?c=1/0', "opened without c: '1/0' is infinite"],
    ['NaN', '#/explore?c=NaN', "opened without c: 'NaN' is not a number"],
    [
      'beyond the doubles',
      '#/explore?c=1e999',
      "opened without c: '1e999' is beyond the largest double",
    ],
    [
      'a negative radius',
      '#/explore?shape=cylinder&r=-1',
      'opened without r: radius must be ≥ 0, got -1',
    ],
    [
      'a zero normal',
      '#/explore?shape=plane&N=0,0,0',
      'opened without N: normal must not be zero, got (0, 0, 0)',
    ],
    [
      'a bad axis',
      '#/explore?shape=square&axis=w',
      "opened without axis: axis must be x, y or z, got 'w'",
    ],
    ['unit=yes', '#/explore?unit=yes', "opened without unit: 'yes' is not 0 or 1"],
    ['an unknown view', '#/explore?view=back', "opened without view: 'back' is not a view"],
    [
      'a view of four numbers',
      '#/explore?view=1,2,3,4',
      "opened without view: '1,2,3,4' is not a view",
    ],
    ['a view of one number', '#/explore?view=1', "opened without view: '1' is not a view"],
    ['a view from nowhere', '#/explore?view=1,2,0', "opened without view: '1,2,0' is not a view"],
    ['a bead nowhere', '#/explore?t=x', "opened without t: 'x' is not a number"],
    ['a key twice', '#/explore?c=1&c=2', "'c' stands there twice: the later one is taken"],
    [
      'broken percent signs',
      '#/explore?c=%E0%A4%A',
      "opened without c: '%E0%A4%A' is not a number",
    ],
  ];
  test.each(CASES)('%s', (_, hash, problem) => {
    expect(decode(hash).problems).toEqual([problem]);
  });

  test('keys that are too many are not read, and that is said', () => {
    const keys = Array.from({ length: 42 }, (_, i) => `k${i}=1`).join('&');
    const { problems } = decode(`#/explore?${keys}&`);
    expect(problems[0]).toBe('only the first 40 of 42 keys are read');
    expect(problems).toHaveLength(41);
  });

  test('the rest of the link holds', () => {
    const state = decode('#/explore?shape=cylinder&E=1,2,3&r=-1&C=1,1,1&unit=1');
    expect(state).toMatchObject({ kind: 'cylinder', E: [1, 2, 3], unit: true });
    expect(shapeOf(state)).toEqual({ kind: 'cylinder', center: [1, 1, 1], radius: 1.5 });
    expect(state.problems).toHaveLength(1);
  });

  test('an unknown shape leaves the default one with its own keys', () => {
    expect(shapeOf(decode('#/explore?shape=torus&c=2'))).toMatchObject({ kind: 'cone', slope: 2 });
  });

  test('problems are of this link only', () => {
    const bad = decode('#/explore?c=x');
    expect(decode('#/explore', bad).problems).toEqual([]);
  });
});

describe('hostile links', () => {
  const HOSTILE: [string, string][] = [
    ['__proto__ as a key', '#/explore?__proto__=1&constructor=2&prototype=3'],
    ['__proto__ as a value', '#/explore?shape=__proto__&method=__proto__&view=__proto__'],
    ['properties of objects', '#/explore?shape=toString&method=valueOf&view=hasOwnProperty'],
    ['percent garbage', '#/%%%?%=%&%zz=%zz&E=%,%,%&%E0%A4%A=%FF'],
    ['a page of percent signs', '#/%E0%A4%A'],
    ['markup', '#/explore?shape=<img src=x onerror=alert(1)>&E=<script>'],
    ['a million characters of a number', `#/explore?c=${'9'.repeat(1e6)}`],
    ['a million characters of a page', `#/${'a'.repeat(1e6)}`],
    ['a million characters of a key', `#/explore?${'a'.repeat(1e6)}=1`],
    ['a million keys', `#/explore?${'a=1&'.repeat(250_000)}`],
    ['a million commas', `#/explore?E=${','.repeat(1e6)}`],
    ['a million question marks', `#/explore${'?'.repeat(1e6)}`],
    ['a million brackets', `#/explore?c=${'('.repeat(1e6)}`],
    ['deep brackets within the limit', `#/explore?c=${'('.repeat(99)}1${')'.repeat(99)}`],
    ['equals signs', '#/explore?E==1,2,3&====&=&=1'],
    ['code', '#/explore?c=constructor.constructor("return 1")()&E=eval(1),1,1'],
    ['zero bytes and line ends', '#/explore?c=%00%0A%0D&E=1%0A,2,3'],
    ['half a surrogate', '#/explore?c=\ud800&\udfff=1'],
  ];
  test.each(HOSTILE)('%s', (_, hash) => {
    // Quadratic time in a million characters would be hours: the limit of the test is far away.
    const state = decode(hash);
    expect(Object.keys(state)).toEqual(Object.keys(INITIAL));
    expect(Object.getPrototypeOf(state)).toBe(Object.prototype);
    expect(SHAPES.map(({ kind }) => kind)).toContain(state.kind);
    expect(state.E.every(Number.isFinite)).toBe(true);
    for (const problem of state.problems) expect(problem.length).toBeLessThan(200);
    expect(state.problems.length).toBeLessThan(85);
    // Whatever was opened can be linked to.
    expect(decode(encode(state))).toEqual({ ...state, problems: [] });
  });

  test('no prototype was touched', () => {
    for (const [, hash] of HOSTILE) decode(hash);
    expect(Object.keys(Object.prototype)).toEqual([]);
    expect(({} as Record<string, unknown>)['1']).toBeUndefined();
  });

  test('of keys given twice the last one counts', () => {
    const state = decode('#/explore?c=1&c=2');
    expect(shapeOf(state)).toEqual({ kind: 'cone', vertex: [0, 3, 0], slope: 2 });
  });

  test(`2000 random texts never throw, seed ${SEED}`, () => {
    const pieces = fc.constantFrom(
      ...['#', '/', 'explore', '?', '&', '=', 'shape', 'cone', 'E', 'd', 'c', 'V', 'unit', 'view'],
      ...['1', ',', '-', '.', 'e', '%', '%2C', '(', ')', '/0', 'NaN', '__proto__', '\u2212', ' '],
    );
    const text = fc.oneof(
      fc.string(),
      fc.array(pieces, { maxLength: 40 }).map((p) => p.join('')),
    );
    fc.assert(
      fc.property(text, (hash) => {
        const state = decode(hash);
        expect(decode(encode(state))).toEqual({ ...state, problems: [] });
      }),
      { seed: SEED, numRuns: 2000 },
    );
  });
});
