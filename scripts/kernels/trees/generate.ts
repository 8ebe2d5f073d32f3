import type { Values } from '../../../src/math/formula/evaluate.ts';
import { METHODS } from '../../../src/math/methods/index.ts';
import type { Formula } from '../../../src/math/shapes/define.ts';
import { SHAPES } from '../../../src/math/shapes/index.ts';
import { BLOCK, loopOf, type Scratch } from './emit-typescript.ts';
import { functionOf, moduleOf } from './emit-wasm.ts';
import { oneRay } from './one-ray-file.ts';
import { type Ask, asksOf, numbersOf, programOf } from './program.ts';
import { SYSTEMS } from './recorders.ts';
import { COLUMNS, header, keyOf, nameOf, wrapped } from './text.ts';

/** A file to be written, by its path below src/math/batch/generated. */
export interface Generated {
  readonly path: string;
  readonly text: string;
}

/** Of the loop that answers. */
function namesOf(kind: string, ask: Ask): readonly [string, ...string[]] {
  const [both, classes] = [`${nameOf(kind)}Both`, `${nameOf(kind)}Classes`];
  return ask === 'either' ? [both, classes] : [ask === 'both' ? both : classes];
}

export interface Surface {
  readonly kind: string;
  readonly formula: Formula;
  readonly symbols: Values<number>;
  /** Whether its trees depend on a parameter that is an axis. */
  readonly turns: boolean;
}

/** A shape of each kind; one whose trees depend on an axis stands for all: see turned.ts. */
export function surfaces(kinds: readonly string[]): Surface[] {
  return SHAPES.filter(({ kind }) => kinds.includes(kind)).map((definition) => {
    const shape = Object.fromEntries([
      ['kind', definition.kind],
      ...definition.params.map(({ key, initial }) => [key, initial]),
      ...definition.params.filter(({ type }) => type === 'axis').map(({ key }) => [key, 'x']),
    ]) as never;
    return {
      kind: definition.kind,
      formula: definition.formula(shape),
      symbols: definition.values(shape),
      turns: definition.params.some(({ type }) => type === 'axis'),
    };
  });
}

/** What is made: for these kinds of shapes, by these methods; unless told otherwise, for all. */
interface Wanted {
  readonly kinds?: readonly string[];
  readonly methods?: readonly string[];
}

/** What is the same in two methods stands in the file of the first. */
function sharing() {
  const known: { key: readonly unknown[]; id: string }[] = [];
  return (id: string, ...key: readonly unknown[]): string | null => {
    const found = known.find((one) => one.key.every((x, k) => x === key[k]));
    if (!found) known.push({ key, id });
    return found?.id ?? null;
  };
}

/** For every method that is made of trees in a number system that kernels can have. */
export function generate({
  kinds = SHAPES.map(({ kind }) => kind),
  methods = METHODS.map(({ id }) => id),
}: Wanted = {}): Generated[] {
  const files: Generated[] = [];
  const ids: [string, string][] = [];
  const all = surfaces(kinds);
  const [sharedForm, sharedRoots] = [sharing(), sharing()];
  for (const { id, title, parts } of METHODS.filter((method) => methods.includes(method.id))) {
    parts?.(({ arithmetic: { id: arithmetic }, form, solver }) => {
      const system = SYSTEMS[arithmetic];
      if (!system) return;
      ids.push([id, arithmetic]);
      const scratch = { count: 0, handed: 0 };
      const loops: string[] = [];
      const functions = all.flatMap(({ kind, formula, symbols }) => {
        const numbers = numbersOf(symbols);
        return asksOf(system).map((ask) => {
          const names = namesOf(kind, ask);
          const program = programOf({ formula, symbols, system, form, solver }, ask);
          loops.push(loopOf(names[0], numbers, program, scratch));
          return functionOf(names, numbers, program);
        });
      });
      if (system.isPlain) {
        const questions = all.map((surface) => ({ ...surface, system, form, solver }));
        const text = oneRay(title, questions, {
          forms: sharedForm(id, system, form),
          roots: sharedRoots(id, system, solver),
        });
        files.push({ path: `${id}-one.ts`, text });
      }
      files.push(
        { path: `${id}.ts`, text: typescript({ title, arithmetic, scratch, loops, kinds: all }) },
        { path: `${id}-simd.ts`, text: wasm(title, moduleOf(functions)) },
      );
    });
  }
  return [...files, { path: 'index.ts', text: index(ids, all) }];
}

interface Loops {
  readonly title: string;
  readonly arithmetic: string;
  readonly scratch: Scratch;
  readonly loops: readonly string[];
  readonly kinds: readonly Surface[];
}

/**
 * The loops are closures over arrays that are made with them, so that V8 knows the arrays when it
 * compiles the loops; nothing is made before a loop is asked for.
 */
function typescript({ title, arithmetic, scratch, loops, kinds }: Loops): string {
  return [
    `${header(`The method ${title} over arrays, in ${arithmetic}.`)}
import { lazily } from '../../lazily.ts';
import type { Loop, LoopsByKind } from '../straight-loop.ts';`,
    ['export const LOOPS = lazily((): LoopsByKind => {', ...arraysOf(scratch, loops)].join('\n'),
    wrapped(loops.join('\n\n')).trimEnd(),
    `return {
${kinds.map(({ kind }) => `${keyOf(kind)}: ${loopsOf(kind, arithmetic)},`).join('\n')}
};
});
`,
  ].join('\n\n');
}

/** What the loops read and write beside what they are given. */
export function arraysOf({ count, handed }: Scratch, loops: readonly string[]): string[] {
  const has = (name: string): boolean => loops.some((text) => text.includes(name));
  return [
    ...(has('fround(') ? ['const { fround } = Math;'] : []),
    ...(has('ONE_OR_NAN') ? ['const ONE_OR_NAN = Float64Array.of(1, Number.NaN);'] : []),
    ...(count > 0 ? [`const S = new Float64Array(${count});`] : []),
    ...(handed > 0
      ? [`const W = new Float64Array(${handed * BLOCK});`, `const H = new Int32Array(${BLOCK});`]
      : []),
  ];
}

const loopsOf = (kind: string, arithmetic: string): string =>
  `{ both: ${nameOf(kind)}Both, ` +
  `classes: ${nameOf(kind)}${isPlain(arithmetic) ? 'Classes' : 'Both'} }`;

function wasm(title: string, bytes: Uint8Array): string {
  const lines = Buffer.from(bytes)
    .toString('base64')
    .match(new RegExp(`.{1,${COLUMNS}}`, 'g'));
  const about = header(`The method ${title} over arrays, as a module of WebAssembly in base64.`);
  return `${about}export const MODULE = \`
${lines?.join('\n')}
\`;
`;
}

const isPlain = (arithmetic: string): boolean => SYSTEMS[arithmetic]?.isPlain === true;

function index(ids: readonly (readonly [string, string])[], all: readonly Surface[]): string {
  return `${header('Which loops there are, by method and kind of shape.')}${ids
    .map(([id]) => `import { LOOPS as ${nameOf(id)} } from './${id}.ts';`)
    .join('\n')}
${ids
  .filter(([, arithmetic]) => isPlain(arithmetic))
  .map(([id]) => `import { ONE_RAY as ${nameOf(id)}One } from './${id}-one.ts';`)
  .join('\n')}
${ids.map(([id]) => `import { MODULE as ${nameOf(id)}Simd } from './${id}-simd.ts';`).join('\n')}
import type { Straight } from '../straight-loop.ts';

/** The names of a shape's numbers, in the order in which its loops take them. */
export const NUMBERS: Readonly<Record<string, readonly string[]>> = {
${all
  .map(
    ({ kind, symbols }) =>
      `  ${keyOf(kind)}: [${numbersOf(symbols)
        .map((n) => `'${n}'`)
        .join(', ')}],`,
  )
  .join('\n')}
};

export const STRAIGHT: Readonly<Record<string, Straight>> = {
${ids
  .map(
    ([id, arithmetic]) => `  ${keyOf(id)}: {
    simd: ${nameOf(id)}Simd,
    arithmetic: '${arithmetic}',
    alone: ${isPlain(arithmetic) ? `${nameOf(id)}One` : 'null'},
    loops: ${nameOf(id)},
  },`,
  )
  .join('\n')}
};
`;
}
