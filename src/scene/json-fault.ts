import { quote } from '../math/shapes.ts';

/** Nesting depth that counts as a fault; no scene is nested as deeply. */
const DEEPEST = 500;

const SPACE = /[ \t\n\r]*/y;
const STRING = /"(?:[^"\\\p{Cc}]|\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4}))*"/uy;
const SIMPLE = /true|false|null|-?(?:0|[1-9]\d*)(?:\.\d+)?(?:[eE][+-]?\d+)?/y;

/**
 * Words on where a text violates JSON (RFC 8259); null if it does not. Messages of JSON.parse
 * differ between browsers, and some name no place.
 */
export function jsonFault(text: string): string | null {
  let at = 0;
  const skip = (pattern: RegExp): boolean => {
    pattern.lastIndex = at;
    const found = pattern.exec(text);
    at += found?.[0].length ?? 0;
    return found !== null;
  };
  const take = (letter: string): boolean => {
    skip(SPACE);
    const found = text[at] === letter;
    at += found ? 1 : 0;
    skip(SPACE);
    return found;
  };
  /** Items with commas between them, up to `end`. */
  const list = (end: string, item: () => boolean): boolean => {
    if (take(end)) return true;
    do {
      if (!item()) return false;
    } while (take(','));
    return take(end);
  };
  const value = (depth: number): boolean => {
    if (depth > DEEPEST) return false;
    if (take('{')) return list('}', () => skip(STRING) && take(':') && value(depth + 1));
    if (take('[')) return list(']', () => value(depth + 1));
    return text[at] === '"' ? skip(STRING) : skip(SIMPLE);
  };
  skip(SPACE);
  if (value(0)) {
    skip(SPACE);
    if (at === text.length) return null;
  }
  return placeOf(text, at);
}

function placeOf(text: string, at: number): string {
  const lines = text.slice(0, at).split('\n');
  const place = `line ${lines.length}, column ${(lines.at(-1)?.length ?? 0) + 1}`;
  if (at >= text.length)
    return `${place}: the text ends too early, after ${quote(text.slice(-20))}`;
  return `${place}: ${quote(text.slice(at, at + 20))} does not belong there`;
}
