import { mkdirSync, writeFileSync } from 'node:fs';
import { generate } from './trees/generate.ts';

/** Writes src/math/batch/generated anew. */
export function writeTrees(root: string): void {
  const folder = `${root}/src/math/batch/generated`;
  mkdirSync(folder, { recursive: true });
  for (const { path, text } of generate()) writeFileSync(`${folder}/${path}`, text);
}
