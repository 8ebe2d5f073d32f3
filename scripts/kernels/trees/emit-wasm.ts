import { NONE } from '../../../src/math/batch/batch.ts';
import { IMPORT } from '../../../src/math/batch/simd-memory.ts';
import { ASK, CLASS_BIT } from '../../../src/math/batch/straight-loop.ts';
import { leb, signedLeb } from '../wasm/ops.ts';
import type { Node } from './graph.ts';
import { INPUTS, type Program } from './program.ts';

/* The same programs for WebAssembly: two rays at a time in float64, four in float32. */

type Code = readonly number[];
type Width = 32 | 64;

const simd = (opcode: number): Code => [0xfd, ...leb(opcode)];
/** WebAssembly Core Specification 2.0, section 5.4: of four float32 and of two float64. */
const OPCODES: Readonly<Partial<Record<Node['op'], Readonly<Record<Width, number>>>>> = {
  add: { 32: 228, 64: 240 },
  sub: { 32: 229, 64: 241 },
  mul: { 32: 230, 64: 242 },
  div: { 32: 231, 64: 243 },
  sqrt: { 32: 227, 64: 239 },
  // b < a ? b : a and a < b ? b : a: one instruction, where min and max are many.
  min: { 32: 234, 64: 246 },
  max: { 32: 235, 64: 247 },
  less: { 32: 67, 64: 73 },
  atMost: { 32: 69, 64: 75 },
  equal: { 32: 65, 64: 71 },
};
const AND = simd(78);
const OR = simd(80);
const XOR = simd(81);
const NOT = simd(77);
const SELECT = simd(82);
const BITMASK = { 32: simd(164), 64: simd(196) } as const;
const UNEQUAL = { 32: simd(66), 64: simd(72) } as const;
const TO_INTEGER = { 32: simd(248), 64: simd(252) } as const;
const SHIFT_LEFT = simd(171);
const PLUS_INTEGERS = simd(174);
const SPLAT_INTEGER = simd(17);
const LANES: Code = [...simd(12), ...new Uint8Array(Int32Array.of(0, 1, 2, 3).buffer)];
const DEMOTE = simd(94);
const PROMOTE = simd(95);
const SHUFFLE = simd(13);
/** The first four, or the last four, of the float32 of two vectors of which each has two. */
const bytes = (first: number, second: number): number[] =>
  [first, second].flatMap((at) => Array.from({ length: 8 }, (_, k) => at + k));

const get = (local: number): Code => [0x20, ...leb(local)];
const tee = (local: number): Code => [0x22, ...leb(local)];
const set = (local: number): Code => [0x21, ...leb(local)];
const i32 = (x: number): Code => [0x41, ...signedLeb(x)];
const memory = (opcode: Code, align: number, offset: number): Code => [
  ...opcode,
  ...leb(align),
  ...leb(offset),
];
const PLUS = [0x6a];

/** The parameters: addresses in bytes, and how many rays, a multiple of those of a vector. */
const PARAMS = [...INPUTS, 't0', 't1', 'margin', 'marked', 'numbers', 'count', 'roots'] as const;
const param = (name: (typeof PARAMS)[number]): Code => get(PARAMS.indexOf(name));
const END = PARAMS.length;
const AT = END + 1;
const RAY = END + 2;
const BITS = END + 3;
const LEFT = END + 4;
const INTS = 5;
const VECTORS = END + INTS;

export interface Func {
  /** It is exported by. */
  readonly names: readonly string[];
  readonly vectors: number;
  readonly body: Code;
}

/** Answers with the address behind the last mark. */
export function functionOf(
  names: readonly string[],
  numbers: readonly string[],
  program: Program,
): Func {
  const { format, outputs, rare, special, missed, rareRoots, classes } = program;
  const { width } = format;
  const lanes = 128 / width;
  const written = Object.entries(outputs);
  const left = [
    rare,
    rareRoots,
    missed,
    classes?.margin,
    classes?.rare,
    special.verdict,
    special.t,
  ];
  const asked = left.filter((n): n is Node => n !== null && n !== undefined);
  const roots = [...asked, ...written.map(([, n]) => n)];

  const uses = new Map<Node, number>();
  const inputs: Node[] = [];
  const uniforms: Node[] = [];
  const walk = (n: Node, underUniform: boolean): void => {
    const before = uses.get(n) ?? 0;
    uses.set(n, before + 1);
    const isOuter = n.uniform && !underUniform;
    if (isOuter && !uniforms.includes(n)) uniforms.push(n);
    if (before > 0) return;
    if (n.op === 'input') inputs.push(n);
    for (const a of n.args) walk(a, n.uniform);
  };
  for (const root of roots) walk(root, false);

  const locals = new Map<Node, number>();
  let next = VECTORS;
  const fresh = (n: Node): number => {
    locals.set(n, next);
    next += 1;
    return next - 1;
  };

  const splat = (x: number): Code => {
    const array = width === 32 ? Float32Array.of(x, x, x, x) : Float64Array.of(x, x);
    return [...simd(12), ...new Uint8Array(array.buffer)];
  };
  const signs: Code = splat(-0);
  const magnitudes: Code = [
    ...simd(12),
    ...Array.from({ length: 16 }, (_, k) => (k % (width / 8) === width / 8 - 1 ? 0x7f : 0xff)),
  ];
  // Two vectors of bits that many operations need.
  const [SIGN, MAGNITUDE] = [next++, next++];

  function operation(n: Node): Code {
    const of = (k: number): Code => code(n.args[k] as Node);
    const opcode = OPCODES[n.op];
    if (opcode) return [...n.args.flatMap((a) => code(a)), ...simd(opcode[width])];
    switch (n.op) {
      case 'constant':
        return splat(n.value);
      case 'number':
        return [
          ...param('numbers'),
          ...memory(simd(width === 32 ? 9 : 10), 2, (width / 8) * numbers.indexOf(n.name)),
        ];
      case 'neg':
        return [...of(0), ...get(SIGN), ...XOR];
      case 'abs':
        return [...of(0), ...get(MAGNITUDE), ...AND];
      case 'and':
      case 'keep':
        return [...of(0), ...of(1), ...AND];
      // All ones are a NaN.
      case 'or':
      case 'unless':
        return [...of(0), ...of(1), ...OR];
      case 'not':
        return [...of(0), ...NOT];
      case 'signed':
        return [...of(1), ...of(0), ...get(SIGN), ...AND, ...XOR];
      case 'select':
        return [...of(1), ...of(2), ...of(0), ...SELECT];
      default:
        throw new RangeError(`no instruction for ${n.op}`);
    }
  }

  function code(n: Node): Code {
    const known = locals.get(n);
    if (known !== undefined) return get(known);
    const made = operation(n);
    return (uses.get(n) ?? 0) > 1 ? [...made, ...tee(fresh(n))] : made;
  }

  function load(n: Node): Code {
    const address = [...param(n.name as (typeof INPUTS)[number]), ...get(AT), ...PLUS];
    const two = (offset: number): Code => [...address, ...memory(simd(0), 3, offset)];
    if (width === 64) return two(0);
    return [...two(0), ...DEMOTE, ...two(16), ...DEMOTE, ...SHUFFLE, ...bytes(0, 16)];
  }

  const store = (array: 't0' | 't1' | 'margin', n: Node): Code => storing(array, code(n));

  function storing(array: 't0' | 't1' | 'margin', stored: Code): Code {
    const address = [...param(array), ...get(AT), ...PLUS];
    const at = (offset: number, value: Code): Code => [
      ...address,
      ...value,
      ...memory(simd(11), 3, offset),
    ];
    if (width === 64) return at(0, stored);
    const whole = next++;
    const high = [...get(whole), ...get(whole), ...SHUFFLE, ...bytes(8, 8), ...PROMOTE];
    return [...stored, ...set(whole), ...at(0, [...get(whole), ...PROMOTE]), ...at(16, high)];
  }

  const prologue = [...signs, ...set(SIGN), ...magnitudes, ...set(MAGNITUDE)];
  for (const n of uniforms) {
    if (locals.has(n)) continue;
    const made = operation(n);
    prologue.push(...made, ...set(fresh(n)));
  }
  const body: number[] = [];
  for (const n of inputs) body.push(...load(n), ...set(fresh(n)));
  const gone = missed ? next++ : 0;
  if (missed) body.push(...code(missed), ...set(gone));
  const [MASK, RARE, VERDICT] = [next++, next++, next++];
  const mark = (n: Node | null, and: Code = []): Code =>
    n ? [...get(MASK), ...code(n), ...and, ...OR, ...set(MASK)] : [];

  /** Code that runs or does not: what it works out is not known outside. */
  function block(made: () => Code): Code {
    const known = new Map(locals);
    const inside = made();
    for (const n of [...locals.keys()]) if (!known.has(n)) locals.delete(n);
    return inside;
  }
  function writeRoots(): Code {
    const made: number[] = [];
    const stores = written.map(([array, n]): Code => {
      const value = next++;
      made.push(...code(n), ...(missed ? [...get(gone), ...OR] : []), ...set(value));
      locals.set(n, value);
      return store(array as 't0', n);
    });
    for (const one of stores) made.push(...one);
    return [...made, ...mark(rareRoots, missed ? [...get(gone), ...NOT, ...AND] : [])];
  }

  /** Where `rare` holds: the class, and the roots or the margin that go with it. */
  function settle(): Code {
    const made: number[] = [...code(special.verdict), ...splat(ASK), ...get(RARE), ...SELECT];
    made.push(...get(MASK), ...AND, ...set(VERDICT));
    const over = (array: 't0' | 't1' | 'margin', value: Code): Code => {
      const node = outputs[array];
      const known = node && locals.get(node);
      const address = [...param(array), ...get(AT), ...PLUS];
      const before = known === undefined ? [...address, ...memory(simd(0), 3, 0)] : get(known);
      return storing(array, [...value, ...before, ...get(RARE), ...SELECT]);
    };
    const noRoot = [...get(VERDICT), ...splat(NONE), ...simd((OPCODES.equal as never)[width])];
    const margin = (): Code => over('margin', [...splat(-1), ...splat(1), ...noRoot, ...SELECT]);
    const roots = (): Code => [
      ...over('t0', code(special.t)),
      ...(outputs.t1 ? over('t1', splat(Number.NaN)) : []),
    ];
    if (classes) made.push(...param('roots'), 0x04, 0x40, ...roots(), 0x05, ...margin(), 0x0b);
    else made.push(...(outputs.margin ? margin() : roots()));
    return made;
  }

  if (classes) {
    body.push(...code(rare), ...tee(MASK), ...set(RARE));
    const { margin, rare: unclear } = classes;
    const [both, alone] = [
      block(writeRoots),
      block(() => [...store('margin', margin), ...mark(unclear)]),
    ];
    body.push(...param('roots'), 0x04, 0x40, ...both, 0x05, ...alone, 0x0b);
  } else {
    // The roots first: with them come most of the values that `rare` is made of.
    body.push(...writeRoots(), ...code(rare), ...tee(MASK), ...set(RARE));
  }
  body.push(...get(MASK), ...BITMASK[width], 0x04, 0x40, ...block(settle));
  // Every lane is written; the next one goes over it where it has no mark.
  body.push(...get(VERDICT), ...splat(NONE), ...UNEQUAL[width], ...BITMASK[width], ...set(BITS));
  body.push(...get(VERDICT), ...TO_INTEGER[width], ...i32(CLASS_BIT), ...SHIFT_LEFT);
  body.push(...get(RAY), ...SPLAT_INTEGER, ...PLUS_INTEGERS, ...LANES, ...PLUS_INTEGERS);
  body.push(...set(VERDICT));
  for (let lane = 0; lane < lanes; lane++) {
    body.push(...get(LEFT), ...get(VERDICT), ...memory(simd(90), 2, 0), lane);
    body.push(...get(LEFT), ...get(BITS));
    body.push(...(lane < 2 ? i32(2 - lane) : i32(lane - 2)), lane < 2 ? 0x74 : 0x76);
    body.push(...i32(4), 0x71, ...PLUS, ...set(LEFT));
  }
  body.push(0x0b);
  return {
    names,
    vectors: next - VECTORS,
    body: [
      ...prologue,
      ...param('marked'),
      ...set(LEFT),
      ...[...param('count'), ...i32(3), 0x74, ...set(END)],
      ...[0x02, 0x40, 0x03, 0x40],
      ...[...get(AT), ...get(END), 0x4f, 0x0d, 1],
      ...body,
      ...[...get(AT), ...i32(8 * lanes), ...PLUS, ...set(AT)],
      ...[...get(RAY), ...i32(lanes), ...PLUS, ...set(RAY)],
      ...[0x0c, 0, 0x0b, 0x0b],
      ...get(LEFT),
    ],
  };
}

const vector = (items: readonly Code[]): number[] => [...leb(items.length), ...items.flat()];
const section = (id: number, items: readonly Code[]): number[] => {
  const inside = vector(items);
  return [id, ...leb(inside.length), ...inside];
};
const text = (name: string): number[] => [
  ...leb(name.length),
  ...[...name].map((c) => c.charCodeAt(0)),
];

/** The module of these functions, on the memory of all kernels. */
export function moduleOf(functions: readonly Func[]): Uint8Array {
  const type = [0x60, ...vector(PARAMS.map(() => [0x7f])), 1, 0x7f];
  const bodies = functions.map(({ vectors, body }) => {
    const locals = vector([
      [...leb(INTS), 0x7f],
      [...leb(vectors), 0x7b],
    ]);
    const code = [...locals, ...body, 0x0b];
    return [...leb(code.length), ...code];
  });
  return Uint8Array.from([
    ...[0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00],
    ...section(1, [type]),
    ...section(2, [[...text(IMPORT.module), ...text(IMPORT.name), 0x02, 0x00, 1]]),
    ...section(
      3,
      functions.map(() => [0]),
    ),
    ...section(
      7,
      functions.flatMap(({ names }, i) => names.map((name) => [...text(name), 0x00, ...leb(i)])),
    ),
    ...section(10, bodies),
  ]);
}
