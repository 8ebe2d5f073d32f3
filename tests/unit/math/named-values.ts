import { loopOf } from '../../../src/math/wasm/source.ts';

type Numbers = Readonly<Record<string, number>>;

/**
 * What every name in a loop's text stands for, for one ray: as the loop itself computes it, both
 * sides of its branches. `constant` gives what the loop takes from arrays before it begins;
 * `elements` are the ray's own, by array.
 */
export function namedValues(
  source: string,
  name: string,
  hasY: boolean,
): (constant: (array: string, key: string) => number, elements: Numbers) => Numbers {
  const { constants, statements } = loopOf(source, name, hasY);
  const named = statements.filter(({ writes }) => !writes);
  const run = new Function(
    'constant',
    'elements',
    [
      ...constants.map(({ name, array, key }) => `const ${name} = constant('${array}', '${key}');`),
      ...named.map(
        ({ target, formula }) => `const ${target} = ${formula.replace(/(\w+)__/g, 'elements.$1')};`,
      ),
      `return { ${named.map(({ target }) => target).join(', ')} };`,
    ].join('\n'),
  );
  return (constant, elements) => run(constant, elements) as Numbers;
}
