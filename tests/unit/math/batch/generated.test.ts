import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';
import { generate } from '../../../../scripts/kernels/trees/generate.ts';
import { NUMBERS, STRAIGHT } from '../../../../src/math/batch/generated/index.ts';

/*
 * The kernels that are committed are those that the formula trees give: `npm run kernels`. A shape
 * or method that is newer than they are has none yet: it is answered by its trees
 * (tests/unit/adding.alone.test.ts).
 */

const FOLDER = fileURLToPath(new URL('../../../../src/math/batch/generated/', import.meta.url));
const made = { kinds: Object.keys(NUMBERS), methods: Object.keys(STRAIGHT) };
const files = generate(made);

test.each(files.map(({ path, text }) => [path, text] as const))('%s', (path, text) => {
  expect(readFileSync(FOLDER + path, 'utf8') === text, 'npm run kernels').toBe(true);
});

test('there is no other file beside them', () => {
  expect(readdirSync(FOLDER).sort()).toEqual(files.map(({ path }) => path).sort());
});
