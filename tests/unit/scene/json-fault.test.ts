import * as fc from 'fast-check';
import { expect, test } from 'vitest';
import { sceneFromJson, sceneToJson } from '../../../src/scene/json.ts';
import { jsonFault } from '../../../src/scene/json-fault.ts';
import { plain } from '../../../src/scene/presets/plain.ts';

const isJson = (text: string): boolean => {
  try {
    JSON.parse(text);
    return true;
  } catch {
    return false;
  }
};

test('a fault is found where JSON.parse finds one; one letter changed (seed 3)', () => {
  const text = sceneToJson(plain.scene).slice(0, 700);
  const whole = JSON.stringify({ a: [1, -2.5e-3, 'x\n"y"\\', true, null, {}, []], b: '\u00e9' });
  fc.assert(
    fc.property(
      fc.constantFrom(text, whole, `${whole} `),
      fc.nat(),
      fc.constantFrom('', ',', '"', '}', ']', '{', '0', '-', '.', 'e', '\\', '\n', 'x', ':'),
      (source, k, letter) => {
        const at = k % source.length;
        const broken = source.slice(0, at) + letter + source.slice(at + 1);
        expect(jsonFault(broken) === null).toBe(isJson(broken));
      },
    ),
    { seed: 3, numRuns: 2000 },
  );
});

test('the place is that of the slip', () => {
  expect(jsonFault('{\n  "a": 1,\n  "b" 2\n}')).toMatch(/^line 3, column 7: '2\s/);
  expect(jsonFault('[1, 2')).toBe("line 1, column 6: the text ends too early, after '[1, 2'");
  expect(jsonFault(`${'['.repeat(9000)}`)).toMatch(/^line 1, column \d+/);
  const lines = sceneToJson(plain.scene).split('\n');
  lines[5] = lines[5]?.replace(':', '') ?? '';
  expect(() => sceneFromJson(lines.join('\n'))).toThrow(/^line 6, column \d+: /);
});
