import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { displayTriple, shortest } from '../../../src/text/format.ts';
import { looksLikeTriple, parseTriple, type Triple } from '../../../src/text/parse.ts';
import { anyDouble, SEED } from './doubles.ts';

describe('parseTriple: meaning', () => {
  it.each<[string, Triple]>([
    ['1, 2, 3', [1, 2, 3]],
    ['1,2,3', [1, 2, 3]],
    ['(1,2,3)', [1, 2, 3]],
    ['[1,2,3]', [1, 2, 3]],
    ['{1, 2, 3}', [1, 2, 3]],
    ['1 2 3', [1, 2, 3]],
    [' 1  -2  3 ', [1, -2, 3]],
    ['1;2;3', [1, 2, 3]],
    ['1\t2\t3', [1, 2, 3]],
    ['1\n2\n3\n', [1, 2, 3]],
    ['1,\n2,\n3,', [1, 2, 3]],
    ['1,5; 2; 3', [1.5, 2, 3]],
    ['1,5 2 3', [1.5, 2, 3]],
    ['1,5, 2, 3,25', [1.5, 2, 3.25]],
    ['1,5\t2,5\t3,5', [1.5, 2.5, 3.5]],
    ['Vec3(1,2,3)', [1, 2, 3]],
    ['vec3(1.0, 2.0, 3.0)', [1, 2, 3]],
    ['vec3(1.f, 2.0f, .5f);', [1, 2, 0.5]],
    ['new THREE.Vector3(1, 2, 3)', [1, 2, 3]],
    ['glm::vec3(1, 2, 3)', [1, 2, 3]],
    ['np.array([1, 2, 3])', [1, 2, 3]],
    ['E = (3, 1, 1)', [3, 1, 1]],
    ['1/3, sqrt(2), -2^-40', [1 / 3, Math.SQRT2, -(2 ** -40)]],
    ['(1+2) (3) (4)', [3, 3, 4]],
    ['(1+2), (3), (4)', [3, 3, 4]],
    ['(−0.8, −0.2, −0.3)', [-0.8, -0.2, -0.3]],
    ['-0, 0, -0', [-0, 0, -0]],
  ])('%j', (text, value) => {
    expect(parseTriple(text)).toEqual({ ok: true, value });
    expect(looksLikeTriple(text)).toBe(true);
  });
});

describe('parseTriple: reasons', () => {
  it.each([
    ['', 'type three numbers, such as (1, 2, 3)'],
    ['1, 2', "'1, 2' is not three numbers"],
    ['1, 2, 3, 4', "'1, 2, 3, 4' is not three numbers"],
    ['1,,3', "'1,,3' is not three numbers"],
    ['(1, 2, 3', "'(1' is not a number"],
    ['1, abc, 3', "'abc' is not a number"],
    ['1, 1/0, 3', "'1/0' is infinite"],
    ['1, 1e400, 3', "'1e400' is beyond the largest double"],
    ['sqrt(1, 2, 3)', "'sqrt(1' is not a number"],
    ['foo bar baz', "'foo' is not a number"],
    ['1 '.repeat(400), "'1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1…' is too long for three numbers"],
  ])('%j: %s', (text, reason) => {
    expect(parseTriple(text)).toEqual({ ok: false, reason });
  });

  it.each(['1', '1,5', '1/3', '1 - 3', '2 · 3', 'foo bar baz', '', '1, 2', 'a b c', '(1+2)'])(
    '%j is not meant for three boxes',
    (text) => expect(looksLikeTriple(text)).toBe(false),
  );

  it('takes a triple with a fault for a triple, so that the fault is said', () => {
    expect(looksLikeTriple('(1, abc, 3)')).toBe(true);
  });
});

describe('parseTriple: round trips', () => {
  it(`reads back the bits of a link and of code (seed ${SEED})`, () => {
    fc.assert(
      fc.property(fc.tuple(anyDouble, anyDouble, anyDouble), (v) => {
        const text = v.map(shortest);
        expect(parseTriple(text.join(','))).toEqual({ ok: true, value: v });
        expect(parseTriple(`vec3(${text.join(', ')})`)).toEqual({ ok: true, value: v });
        expect(parseTriple(text.join(' '))).toEqual({ ok: true, value: v });
        expect(parseTriple(text.join(';').replaceAll('.', ','))).toEqual({ ok: true, value: v });
      }),
      { seed: SEED, numRuns: 1000 },
    );
  });

  it('reads what displayTriple shows', () => {
    expect(parseTriple(displayTriple([3, -0.5, 1e7]))).toEqual({ ok: true, value: [3, -0.5, 1e7] });
  });
});
