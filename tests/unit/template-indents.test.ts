import { expect, test } from 'vitest';
import { withoutIndents } from '../../scripts/template-indents.ts';

const changed = (source: string): string => withoutIndents('x.ts', source);
/** ${code} in a template of the source. */
const hole = (code: string): string => `$\{${code}}`;

test('lines of templates lose their indents, in templates within templates too', () => {
  const source = (indent: string): string => {
    const inner = `svg\`\n${indent}<g>${hole('b')}</g>\``;
    return `const x = html\`<p\n${indent}class=${hole('cls')}>\n${indent}${hole(inner)}\n</p>\`;`;
  };
  expect(changed(source('    '))).toBe(source(''));
});

test('nothing else does: other texts, and the code between', () => {
  const object = hole('{\n    c: 1,\n  }');
  const source = `const x = \`a\n    b\`;\nif (x) {\n  y(html\`<p>${object}</p>\`);\n}`;
  expect(changed(source)).toBe(source);
});
