import { readdirSync, readFileSync } from 'node:fs';

export const ROOT = new URL('../../../', import.meta.url);

export const read = (path: string): string => readFileSync(new URL(path, ROOT), 'utf8');

/** Files of the folder itself, as paths from the root. */
export const filesIn = (folder: string): readonly string[] =>
  readdirSync(new URL(folder, ROOT)).map((name) => `${folder}${name}`);

/** Every document that people read, as paths from the root. */
export const DOCUMENTS: readonly string[] = [
  ...readdirSync(ROOT).filter((name) => name.endsWith('.md')),
  ...filesIn('docs/').filter((name) => name.endsWith('.md')),
];

export const SCRIPTS: Readonly<Record<string, string>> = JSON.parse(read('package.json')).scripts;

/** The scripts that a text runs by `npm run x`, `npm start` or `npm test`. */
export const npmScripts = (text: string): readonly string[] =>
  [...text.matchAll(/npm run ([\w:]+)|npm (start|test)\b/g)].map((m) => m[1] ?? m[2] ?? '');

/** What stands in code marks. */
export const codeSpans = (text: string): readonly string[] =>
  [...text.matchAll(/`([^`\n]+)`/g)].map((m) => m[1] ?? '');

/** The lines of blocks that begin with ``` and the given word. */
export const codeBlocks = (text: string, language: string): readonly string[] =>
  [...text.matchAll(new RegExp(`^\`\`\`${language}\n([\\s\\S]*?)^\`\`\`$`, 'gm'))].map(
    (m) => m[1] ?? '',
  );

/** A document's part under a heading, up to the next one of the same depth. */
export function section(text: string, heading: string): string {
  const [, after = ''] = text.split(`\n${heading}\n`);
  const depth = heading.split(' ')[0];
  return after.split(`\n${depth} `)[0] ?? '';
}

/** Lines that may be broken anywhere, as one. */
export const flowing = (text: string): string => text.replace(/\s+/g, ' ').trim();
