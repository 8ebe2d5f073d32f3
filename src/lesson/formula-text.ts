import type { FormulaPart } from './prose.ts';

/*
 * A formula in prose stands between backticks: `D = B² − 4AC`, `R(t) = E + t d`, `E_x`, `t_1`,
 * `A = {A}`. Letters are the course's symbols, each by itself but for its index.
 */

const PART = new RegExp(
  [
    /\{([^{}]+)\}|\^(\d+)|([²³⁴])|(\d+(?:\.\d+)?)|(sqrt)/,
    /([A-Za-zε])(?:_?([xyz]\b|[12](?!\d))|([₁₂]))?|(\S)/,
  ]
    .map(({ source }) => source)
    .join('|'),
  'gu',
);
const RAISED: Readonly<Record<string, string>> = { '²': '2', '³': '3', '⁴': '4' };
const LOWERED: Readonly<Record<string, string>> = { '₁': '1', '₂': '2' };
const SIGNS: Readonly<Record<string, string>> = { '-': '−', '*': '·', sqrt: '√' };
/** Letters that have an index; after any other a digit is a factor and x, y, z a symbol. */
const INDEXED = /^[EdNPCVXtR]$/;

export function formulaParts(text: string): FormulaPart[] {
  return [...text.matchAll(PART)].flatMap((match): FormulaPart[] => {
    const [, live, power, raised, digits, root, letter, index = '', lowered = '', sign = ''] =
      match;
    if (live !== undefined) return [{ type: 'live', quantity: live.trim() }];
    if (power !== undefined) return [{ type: 'power', text: power }];
    if (raised !== undefined) return [{ type: 'power', text: RAISED[raised] ?? '' }];
    if (digits !== undefined) return [{ type: 'number', text: digits }];
    if (letter !== undefined) return symbol(letter, index || (LOWERED[lowered] ?? ''));
    return [{ type: 'sign', text: SIGNS[root ?? sign] ?? root ?? sign }];
  });
}

function symbol(base: string, index: string): FormulaPart[] {
  if (index === '' || INDEXED.test(base)) return [{ type: 'symbol', base, index }];
  const after: FormulaPart = /\d/.test(index)
    ? { type: 'number', text: index }
    : { type: 'symbol', base: index, index: '' };
  return [{ type: 'symbol', base, index: '' }, after];
}
