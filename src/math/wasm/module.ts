import type { Code } from './expression.ts';
import { leb } from './ops.ts';

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

/** The module of these functions with an exported memory `memory` of so many pages of 64 KiB (WebAssembly Core Specification 2.0, section 5.5). */
export function moduleOf(functions: readonly Func[], pages: number): Uint8Array {
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
    ...section(
      3,
      functions.map((_, i) => leb(i)),
    ),
    ...section(5, [[0x01, ...leb(pages), ...leb(pages)]]),
    ...section(7, [
      [...text('memory'), 0x02, 0],
      ...functions.map(({ name }, i) => [...text(name), 0x00, ...leb(i)]),
    ]),
    ...section(10, bodies),
  ]);
}
