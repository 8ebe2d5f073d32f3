/*
 * What a loop over rays computes, read from its own text in TypeScript, so that each formula is written once. Only what such loops need is understood:
 *
 *   const name = formula;             a value of this ray
 *   const name = array[i] as number;  read from an array, by i or j
 *   array[j] = formula;               written to an array
 *
 * Branches are not: a kernel computes both sides and chooses by the names of its conditions.
 */

export interface Statement {
  /** The value's name, or the array's that is written to. */
  readonly target: string;
  readonly writes: boolean;
  /** What is read from an array is named `array__`. */
  readonly formula: string;
}

/** What stands before a loop, and its body up to the brace that closes it. */
const LOOP = /^([\s\S]*?\n)( *)for \(let ([\s\S]*?)\n\2\}/;
const STATEMENT = /const (\w+) =\s([^;{}]*);|(\w+)\[\w+\] =\s([^;{}]*);/g;
const CONSTANT = /const (\w+) = (\w+)\[(?:\w+\.)?(\w+)\] as number;/g;
const ELEMENT = /\(?\b(\w+)\[[ij]\] as number\)?/g;
/** The index itself and answers that are the same for all: the kernel's own business. */
const OWN = /^(i|Number\.NaN)$/;

/** A number that is the same for all rays: `const name = array[key] as number;` before the loop. */
export interface Constant {
  readonly name: string;
  readonly array: string;
  readonly key: string;
}

export interface Loop {
  readonly constants: readonly Constant[];
  readonly statements: readonly Statement[];
}

/**
 * The first loop of an exported function and the constants before it. Of `hasY ? a : b` is taken what `hasY` says. Throws RangeError if there is no such function.
 */
export function loopOf(source: string, name: string, hasY: boolean): Loop {
  const from = source.search(new RegExp(`^export (function|const) ${name}\\b`, 'm'));
  const text = from < 0 ? '' : (source.slice(from).split(/\n(?=export )/)[0] as string);
  const [, before, , loop] = LOOP.exec(text.replace(/\/\/.*/g, '')) ?? [];
  if (!before || !loop) throw new RangeError(`no loop in ${name}`);
  const constants = [...before.matchAll(CONSTANT)]
    .map(([, constant, array, key]) => ({
      name: constant as string,
      array: array as string,
      key: key as string,
    }))
    .filter(({ array }) => array !== 'count');
  return { constants, statements: statementsOf(loop, hasY) };
}

function statementsOf(loop: string, hasY: boolean): Statement[] {
  const found: Statement[] = [];
  for (const [, value, formula, array, written] of loop.matchAll(STATEMENT)) {
    const text = (formula ?? written ?? '').trim();
    if (value === 'i' || OWN.test(text)) continue;
    found.push({
      target: (value ?? array) as string,
      writes: value === undefined,
      formula: text
        .replace(/hasY \? ([^:]+) : ([^:]+)$/, hasY ? '$1' : '$2')
        .replace(ELEMENT, elementOf('$1')),
    });
  }
  return found;
}

/** The name of an array's element in a formula. */
export const elementOf = (array: string): string => `${array}__`;
