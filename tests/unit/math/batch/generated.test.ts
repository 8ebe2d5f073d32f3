import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { generate } from '../../../../scripts/kernels/trees/generate.ts';

/* The kernels that are committed are those that the formula trees give: `npm run kernels`. */

const FOLDER = fileURLToPath(new URL('../../../../src/math/batch/generated/', import.meta.url));
const files = generate();

test.each(files.map(({ path, text }) => [path, text] as const))('%s', (path, text) => {
  expect(readFileSync(FOLDER + path, 'utf8') === text, 'npm run kernels').toBe(true);
});

test('there is no other file beside them', () => {
  expect(readdirSync(FOLDER).sort()).toEqual(files.map(({ path }) => path).sort());
});
