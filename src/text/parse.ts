/* Reads numbers from text that was typed, pasted, or came by a link. */

export { hintOn, parseNumber, parseTyped } from './parse-number.ts';
export { looksLikeTriple, parseTriple, type Triple, tripleTexts } from './parse-triple.ts';
