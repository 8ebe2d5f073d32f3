/** Thrown with the reason why a text is no number; the two parsers turn it into a result. */
export class Refusal extends Error {}

/** Quotes a typed text; a long one is cut, so that the reason fits on a line. */
export function quoted(text: string): string {
  const line = text.trim().replace(/\s+/g, ' ');
  return line.length > 32 ? `'${line.slice(0, 31)}…'` : `'${line}'`;
}

export const BEYOND = 'is beyond the largest double';
export const BELOW = 'is below the smallest double';
