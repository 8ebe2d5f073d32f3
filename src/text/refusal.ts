/**
 * Why a text is no number. Thrown where it is found, and turned into a result by the two parsers.
 */
export class Refusal extends Error {}

/** Quotes what was typed; a long text is cut, so that the reason stays one line. */
export function quoted(text: string): string {
  const line = text.trim().replace(/\s+/g, ' ');
  return line.length > 32 ? `'${line.slice(0, 31)}…'` : `'${line}'`;
}

export const BEYOND = 'is beyond the largest double';
export const BELOW = 'is below the smallest double';
