/* How generated files look. */

export const header = (what: string): string => `/*
 * ${what}
 * Made by \`npm run kernels\` from the formula trees; not to be edited.
 */
`;

/** 'elliptic-cylinder' as a name and as a key. */
export const nameOf = (id: string): string =>
  id.replace(/-(\w)/g, (_, letter) => letter.toUpperCase());
export const keyOf = (id: string): string => (nameOf(id) === id ? id : `'${id}'`);

export const COLUMNS = 96;

/** Lines that are too long in as many as they need, which end in an operator or a comma. */
export const wrapped = (text: string): string =>
  `${text.split('\n').flatMap(cutLine).join('\n')}\n`;

function cutLine(line: string): string[] {
  if (line.length <= COLUMNS) return [line];
  const cut = line.slice(0, COLUMNS).match(/^.*(?:\|\||&&|[-+*/&|<=,]) /)?.[0].length ?? 0;
  if (cut === 0) throw new RangeError(`no place to cut ${line}`);
  return [line.slice(0, cut - 1), ...cutLine(line.slice(cut))];
}
