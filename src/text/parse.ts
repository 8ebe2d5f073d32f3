/* Text that a person typed or pasted, or that a link carries, to numbers. */

export { hintOn, type NumberOptions, parseNumber, parseTyped } from './parse-number.ts';
export { looksLikeTriple, parseTriple, type Triple, tripleTexts } from './parse-triple.ts';
export type { Parsed } from './parsed.ts';
export type { Typed, TypedBinary, TypedUnary } from './typed.ts';
