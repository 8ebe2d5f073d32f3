/* Text that a person typed or pasted, or that a link carries, to numbers. */

export { hintOn, parseNumber, parseTyped } from './parse-number.ts';
export { looksLikeTriple, parseTriple, type Triple, tripleTexts } from './parse-triple.ts';
