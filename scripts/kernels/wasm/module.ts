import { type Code, leb } from './ops.ts';

/** A function from i32 parameters to an i32; its locals are i32 first and v128 after. */
export interface Func {
  readonly name: string;
  readonly params: number;
  readonly ints: number;
  readonly vectors: number;
  readonly body: Code;
}

const I32 = 0x7f;
const V128 = 0x7b;
const END = 0x0b;
/** Kinds of what is imported and exported, and limits without an upper one. */
const FUNCTION = 0x00;
const MEMORY = 0x02;
const AT_LEAST = 0x00;
const HEADER = [0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00];

const vector = (items: readonly Code[]): number[] => [...leb(items.length), ...items.flat()];
const section = (id: number, items: readonly Code[]): number[] => {
  const bytes = vector(items);
  return [id, ...leb(bytes.length), ...bytes];
};
const text = (name: string): number[] => [
  ...leb(name.length),
  ...[...name].map((c) => c.charCodeAt(0)),
];

/** The memory that a module imports, by these names, of at least so many pages of 64 KiB. */
export interface ImportedMemory {
  readonly module: string;
  readonly name: string;
  readonly pages: number;
}

/**
 * The module of these functions, which import their memory (WebAssembly Core Specification 2.0,
 * section 5.5).
 */
export function moduleOf(functions: readonly Func[], memory: ImportedMemory): Uint8Array {
  const types = functions.map(({ params }) => [0x60, ...vector(Array(params).fill([I32])), 1, I32]);
  const bodies = functions.map(({ ints, vectors, body }) => {
    const code = [
      ...vector([
        [...leb(ints), I32],
        [...leb(vectors), V128],
      ]),
      ...body,
      END,
    ];
    return [...leb(code.length), ...code];
  });
  return Uint8Array.from([
    ...HEADER,
    ...section(1, types),
    ...section(2, [
      [...text(memory.module), ...text(memory.name), MEMORY, AT_LEAST, ...leb(memory.pages)],
    ]),
    ...section(
      3,
      functions.map((_, i) => leb(i)),
    ),
    ...section(
      7,
      functions.map(({ name }, i) => [...text(name), FUNCTION, ...leb(i)]),
    ),
    ...section(10, bodies),
  ]);
}
