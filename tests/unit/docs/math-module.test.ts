import { describe, expect, test } from 'vitest';
import { codeBlocks, read } from './documents.ts';
import { runExample } from './examples.ts';

describe.each(['README.md', 'docs/MATH-MODULE.md'])('%s', (path) => {
  const examples = codeBlocks(read(path), 'ts');

  test('has examples', () => expect(examples.length).toBeGreaterThan(0));

  test.each(examples.map((code, i) => [i + 1, code] as const))('example %i', async (_, code) => {
    await runExample(code);
  });
});

describe('an example is refused', () => {
  test.each([
    ['whose value is another one', '1 + 1; // → 3'],
    ['that throws something else', 'JSON.parse("{"); // throws InvalidInput: no'],
    ['that throws nothing', '1 + 1; // throws RangeError: no'],
    ['that claims nothing', '1 + 1;'],
    ['that imports what is not there', "import { x } from './src/math/index.ts';\nx; // → 1"],
  ])('%s', async (_, code) => {
    await expect(runExample(code)).rejects.toThrow();
  });
});
