import { decimalDigits } from '../../src/math/exact/decimal.ts';
import type { Surd } from '../../src/math/exact/surd.ts';
import { FAMILIES, type Family, type Question, seeded } from '../../src/math/families.ts';
import { InvalidInput } from '../../src/math/index.ts';
import { exactHits } from '../../tests/unit/math/exact-hits.ts';

/*
 * Hard cases with their exact answers, for programs in any language:
 *
 *   { "graze": "hard-cases", "version": 1, "seed": 7, "digits": 40,
 *     "cases": [ { "id", "family", "shape", "ray", "class",
 *                  "hits": [ { "t", "point", "normal" }, … ] }, … ] }
 *
 * One case a line. Numbers of shape and ray are doubles in the digits that restore them. Those of
 * the answer are texts with as many significant digits as "digits" says, rounded to the nearest: of
 * the exact hits, ascending in t, over the whole line, a tangent once.
 */

export const DIGITS = 40;

export interface Asked {
  readonly families: readonly Family[];
  readonly seed: number;
  /** Of each family. */
  readonly count: number;
}

/**
 * The families with these ids, separated by commas; 'all' are all of them.
 *
 * @throws InvalidInput for an id that there is not.
 */
export function familiesFrom(ids: string): readonly Family[] {
  if (ids === 'all') return FAMILIES;
  return ids.split(',').map((id) => {
    const found = FAMILIES.find((family) => family.id === id);
    if (found) return found;
    const known = FAMILIES.map((family) => family.id).join(', ');
    throw new InvalidInput(`unknown family '${id}': there are all, ${known}`);
  });
}

/** The file's text. Each family draws from the seed anew: it is the same beside any other. */
export function casesText({ families, seed, count }: Asked): string {
  const lines = families.flatMap((family) => {
    const random = seeded(seed);
    return Array.from({ length: count }, (_, i) => {
      const question = family.make(random);
      return JSON.stringify({
        id: `${family.id}/${i + 1}`,
        family: family.id,
        ...answer(question),
      });
    });
  });
  return (
    `{ "graze": "hard-cases", "version": 1, "seed": ${seed}, "digits": ${DIGITS}, ` +
    `"cases": [\n${lines.join(',\n')}\n] }\n`
  );
}

function answer({ shape, ray }: Question): object {
  const { class: verdict, hits } = exactHits(shape, ray);
  const texts = hits.map(({ t, point, normal }) => ({
    t: text(t),
    point: point.map(text),
    normal: normal.map(text),
  }));
  return { shape, ray, class: verdict, hits: texts };
}

/** 0.125 as 1.25e-1, zeros at the end left out. */
function text(x: Surd): string {
  const { negative, digits, exponent } = decimalDigits(x, DIGITS);
  const [first = '0', ...rest] = digits.replace(/0+$/, '') || '0';
  return `${negative ? '-' : ''}${first}${rest.length > 0 ? `.${rest.join('')}` : ''}e${exponent}`;
}
