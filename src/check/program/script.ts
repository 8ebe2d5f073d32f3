/** Largest number of characters and lines of a program: a longer text blocks the editor. */
export const LONGEST_PROGRAM = 100_000;
const MOST_LINES = 10_000;

/** Why a text is too long to be a program; '' if it is not. */
export function tooLong(text: string): string {
  const may = (size: number, what: string, most: number): string =>
    size > most ? `it has ${size} ${what}, and a program may have up to ${most}` : '';
  return (
    may(text.length, 'characters', LONGEST_PROGRAM) ||
    may(text.split('\n').length, 'lines', MOST_LINES)
  );
}

/**
 * The program without `export`, since it runs inside a function. The default export counts as
 * `intersect` if nothing has that name (the sandbox knows it as `graze_default`). Line numbers do
 * not change.
 */
export const asScript = (source: string): string =>
  source
    .replace(
      /^([ \t]*)export[ \t]+default[ \t]+(?=(?:async[ \t]+)?function[ \t]+intersect\b)/gm,
      '$1',
    )
    .replace(/^([ \t]*)export[ \t]+default[ \t]+/gm, '$1graze_default = ')
    .replace(/^([ \t]*)export[ \t]+(?=async\b|function\b|const\b|let\b|var\b|class\b)/gm, '$1')
    .replace(/^[ \t]*export[ \t]*\{[^}\n]*\}[ \t]*;?/gm, '');

const TYPES = 'number|string|boolean|void|any|unknown|Vec3|Vector3|Ray|Shape|Hit|readonly';
const TYPESCRIPT = new RegExp(
  [
    `[\\w)\\]}?]\\s*:\\s*(?:${TYPES})\\b`,
    '^\\s*(?:export\\s+)?(?:interface|type|enum|declare)\\s+\\w',
    '^\\s*import\\s+type\\b',
    '\\bas\\s+(?:const|number|string|any|unknown)\\b',
  ].join('|'),
  'm',
);
const IMPORT = /^\s*import\b(?!\s*\()/m;

/** Advice for a program that cannot start, if its text shows the cause; '' otherwise. */
export function adviceFor(source: string, message: string): string {
  const syntax = message.startsWith('syntax error');
  if (syntax && TYPESCRIPT.test(source)) {
    return 'This looks like TypeScript: only JavaScript runs here, so take the types away.';
  }
  if (syntax && IMPORT.test(source)) {
    return 'A program stands alone here: write what it imports into it.';
  }
  if (
    /\b(?:module|exports|require) is not defined|variable: (?:module|exports|require)/.test(message)
  ) {
    return 'There are no modules here: a function intersect(shape, ray) is enough.';
  }
  return '';
}
