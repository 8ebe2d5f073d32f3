import { subscript } from './scripts.ts';

/**
 * The name of a quantity, as in data-quantity, to be read out before its value: 'P1.x' → 'P₁ x',
 * 'N.(E-P)' → 'N·(E − P)', 'walk.A' → 'A'.
 */
export function spokenName(quantity: string): string {
  const before = spoken.get(quantity);
  if (before !== undefined) return before;
  const name = inWords(quantity);
  spoken.set(quantity, name);
  return name;
}

/** Cache: there are few names, and each is read out with every new value. */
const spoken = new Map<string, string>();

const inWords = (quantity: string): string =>
  quantity
    .replace(/^(walk|solution)\./, '')
    .replace(/^typed\./, 'as typed ')
    .replace(/^term.*/, 'term')
    .replace(/\b([tPN])([12])/, (_, letter, n) => `${letter}${subscript(Number(n))}`)
    .replace(/\.([xyz]|[a-z]{2,})$/, ' $1')
    .replace('.', '·')
    .replace('-', ' − ');
