/** Instructions, as bytes. */
export type Code = readonly number[];

/*
 * The instructions that the kernels need, as bytes (WebAssembly Core Specification 2.0, section
 * 5.4; vectors of two doubles: f64x2).
 */

/** Unsigned LEB128. */
export function leb(value: number): number[] {
  const bytes: number[] = [];
  let rest = value;
  do {
    const low = rest & 0x7f;
    rest >>>= 7;
    bytes.push(rest > 0 ? low | 0x80 : low);
  } while (rest > 0);
  return bytes;
}

/** Signed LEB128 of a 32-bit number. */
export function signedLeb(value: number): number[] {
  const bytes: number[] = [];
  for (let rest = value; ; rest >>= 7) {
    const low = rest & 0x7f;
    const done = (rest >> 7 === 0 && !(low & 0x40)) || (rest >> 7 === -1 && (low & 0x40) !== 0);
    bytes.push(done ? low : low | 0x80);
    if (done) return bytes;
  }
}

const vector = (opcode: number): Code => [0xfd, ...leb(opcode)];
const binary =
  (op: Code) =>
  (a: Code, b: Code): Code => [...a, ...b, ...op];
const unary =
  (op: Code) =>
  (a: Code): Code => [...a, ...op];

export const lt = binary(vector(73));
export const gt = binary(vector(74));
export const le = binary(vector(75));
export const ge = binary(vector(76));
export const not = unary(vector(77));
export const and = binary(vector(78));
export const andNot = binary(vector(79));
export const or = binary(vector(80));
export const abs = unary(vector(236));
export const neg = unary(vector(237));
export const sqrt = unary(vector(239));
export const add = binary(vector(240));
export const sub = binary(vector(241));
export const mul = binary(vector(242));
export const div = binary(vector(243));
export const min = binary(vector(244));
export const max = binary(vector(245));
export const anyTrue = unary(vector(83));
/** The sign bits of both lanes as an i32. */
export const bitmask = unary(vector(196));
/** Lanes of `a` where `mask` is set, else of `b`. */
export const select = (a: Code, b: Code, mask: Code): Code => [...a, ...b, ...mask, ...vector(82)];

export function constant(value: number): Code {
  const bytes = new Uint8Array(Float64Array.of(value, value).buffer);
  return [...vector(12), ...bytes];
}

/**
 * All bits but the sign's, in both lanes: `and` with it is one instruction where f64x2.abs becomes
 * three.
 */
export const MAGNITUDE: Code = [
  ...vector(12),
  ...Array.from({ length: 16 }, (_, k) => (k % 8 === 7 ? 0x7f : 0xff)),
];

export const get = (local: number): Code => [0x20, ...leb(local)];
export const set = (local: number, value: Code): Code => [...value, 0x21, ...leb(local)];

/** log2 of the alignment, and a constant offset. */
const place = (align: number, offset: number): Code => [...leb(align), ...leb(offset)];
export const load = (address: Code, offset: number): Code => [
  ...address,
  ...vector(0),
  ...place(3, offset),
];
export const loadSplat = (offset: number): Code => [...i32(0), ...vector(10), ...place(3, offset)];
/** Two doubles from two addresses. */
export const gather = (low: Code, high: Code, offset: number): Code => [
  ...high,
  ...low,
  ...vector(93),
  ...place(3, offset),
  ...vector(87),
  ...place(3, offset),
  1,
];
export const store = (address: Code, offset: number, value: Code): Code => [
  ...address,
  ...value,
  ...vector(11),
  ...place(3, offset),
];
export const storeLane = (address: Code, offset: number, value: Code, lane: number): Code => [
  ...address,
  ...value,
  ...vector(91),
  ...place(3, offset),
  lane,
];

export const i32 = (value: number): Code => [0x41, ...signedLeb(value)];
export const loadInt = (address: Code, offset: number): Code => [
  ...address,
  0x28,
  ...place(2, offset),
];
export const storeInt = (address: Code, offset: number, value: Code): Code => [
  ...address,
  ...value,
  0x36,
  ...place(2, offset),
];
export const plus = binary([0x6a]);
export const minus = binary([0x6b]);
export const both = binary([0x71]);
export const shiftLeft = binary([0x74]);
export const shiftRight = binary([0x76]);
export const flip = binary([0x73]);
export const less = binary([0x49]);
export const notEqual = binary([0x47]);
export const isZero = unary([0x45]);

/** Moves a pointer or an index on. */
export const forward = (local: number, by: Code): Code => set(local, plus(get(local), by));
/** Writes a 32-bit number where a pointer points, and moves it on. */
export const append = (pointer: number, value: Code): Code => [
  ...storeInt(get(pointer), 0, value),
  ...forward(pointer, i32(4)),
];

const EMPTY = 0x40;
export const when = (condition: Code, then: Code, otherwise: Code = []): Code => [
  ...condition,
  0x04,
  EMPTY,
  ...then,
  ...(otherwise.length > 0 ? [0x05, ...otherwise] : []),
  0x0b,
];
/** Repeats `body` as long as `condition` holds, which is asked before each round. */
export const during = (condition: Code, body: Code): Code => [
  ...[0x02, EMPTY, 0x03, EMPTY],
  ...isZero(condition),
  ...[0x0d, 1],
  ...body,
  ...[0x0c, 0, 0x0b, 0x0b],
];
