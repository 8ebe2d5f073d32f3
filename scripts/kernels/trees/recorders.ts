import type { Arithmetic } from '../../../src/math/arithmetic/arithmetic.ts';
import { doubleDoubleOver, type Pair } from '../../../src/math/arithmetic/double-double.ts';
import { type Directed, type Ends, intervalOver } from '../../../src/math/arithmetic/interval.ts';
import { errorsOver } from '../../../src/math/float/floats.ts';
import type { Format, Graph, Node } from './graph.ts';

/** An arithmetic that records what it does, and what a kernel must know of its numbers. */
export interface Recorder<T> {
  readonly arithmetic: Arithmetic<T>;
  /** An input, or a number of the shape. */
  lift(x: Node): T;
  isNegative(x: T): Node;
  isPositive(x: T): Node;
  /** As the trees see it: a sign that is known to be 0. */
  isZero(x: T): Node;
  /** As the trees see it: no sign is known. */
  isUnknown(x: T): Node;
  select(where: Node, then: T, otherwise: T): T;
  /** |x| < bound, whatever number x is. */
  isWithin(x: T, bound: number): Node;
  shown(x: T): Node;
  /** The lesser and the greater one, as they are shown. */
  sorted(a: T, b: T): readonly [Node, Node];
}

/**
 * What is done with a number system. `most`: numbers below it are far from where roots, places and
 * normals leave the range. Null `box`: the inputs may be any; else |x| < most, and for `least` not
 * between 0 and that.
 */
export interface System {
  readonly format: Format;
  /** Whether a number of it is one of the format. */
  readonly isPlain: boolean;
  /** Whether a loop of TypeScript is faster if it finds the roots of a block's hits at a time. */
  readonly inBlocks: boolean;
  readonly box: { readonly least: number; readonly most: number } | null;
  readonly greatest: number;
  /** Of roots. */
  readonly large: number;
  /** |A| above `tiny` and |B|, |D| below `wide` keep every root below `large`. */
  readonly tiny: number;
  readonly wide: number;
  /**
   * Where the numbers may be of any size: |D| below `wide` and |B| below this are far enough from
   * the range's end for what the trees multiply by powers of two. Then `large` is of a root times
   * the sum of all inputs. Null: they may not.
   */
  readonly reach: number | null;
  make(g: Graph): Recorder<unknown>;
}

const known = <T>(recorder: Recorder<T>): Recorder<unknown> => recorder as Recorder<unknown>;

function noSign(): never {
  throw new RangeError('a recording knows no sign: the formula asks for one by bySign only');
}

function plain(g: Graph, id: string): Recorder<Node> {
  const zero = g.of(0);
  return {
    arithmetic: {
      id,
      of: g.of,
      add: g.add,
      sub: g.sub,
      mul: g.mul,
      div: g.div,
      neg: g.neg,
      sqr: (a) => g.mul(a, a),
      sqrt: g.sqrt,
      sign: noSign,
      whereNegative: (a, then, otherwise) =>
        signedSum(g, a, then, otherwise) ?? g.select(g.less(a, zero), then, otherwise),
      toNumber: noSign,
    },
    lift: (x) => x,
    isNegative: (x) => g.less(x, zero),
    isPositive: (x) => g.less(zero, x),
    isZero: g.isZero,
    // An infinity came from an overflow, as in arithmetic/float64.ts.
    isUnknown: (x) => g.not(g.isZero(g.sub(x, x))),
    select: g.select,
    isWithin: g.isWithin,
    shown: (x) => x,
    sorted: (a, b) => sortedByDenominator(g, a, b) ?? [g.min(a, b), g.max(a, b)],
  };
}

/**
 * (x − s)/w and (x + s)/w for a root s, which is not negative: their order is the sign of w, since
 * rounding is monotone. So no comparison depends on whether there are roots at all.
 */
function sortedByDenominator(g: Graph, a: Node, b: Node): readonly [Node, Node] | null {
  const [under, over] = [a.args[0], b.args[0]];
  const [x, s] = under?.args ?? [];
  if (a.op !== 'div' || b.op !== 'div' || a.args[1] !== b.args[1] || !x || !s) return null;
  if (under?.op !== 'sub' || over !== g.add(x, s) || s.op !== 'sqrt') return null;
  const w = a.args[1] as Node;
  const turned = g.signed(g.less(w, g.of(0)), s);
  return [g.div(g.sub(x, turned), w), g.div(g.add(x, turned), w)];
}

/**
 * (s − b)k where b < 0 and −(b + s)k elsewhere: (|b| + s)k with the other sign than b, to the bit.
 */
function signedSum(g: Graph, b: Node, then: Node, otherwise: Node): Node | null {
  const [difference, k] = then.args as [Node, Node];
  const s = difference?.args[0];
  if (then.op !== 'mul' || difference?.op !== 'sub' || !s) return null;
  if (difference !== g.sub(s, b) || otherwise !== g.mul(g.neg(g.add(b, s)), k)) return null;
  return g.signed(g.not(g.less(b, g.of(0))), g.mul(g.add(g.abs(b), s), k));
}

/** k, if the number is this power of two, by which scaling is exact in the box. */
function scaleOf(x: Node): Node | null {
  const isPower = x.op === 'constant' && x.value > 0 && Number.isInteger(Math.log2(x.value));
  return isPower ? x : null;
}

function doubleDouble(g: Graph): Recorder<Pair<Node>> {
  const ops = doubleDoubleOver(g);
  const zero = g.of(0);
  const scaled = (a: Pair<Node>, k: Node): Pair<Node> => ({
    hi: g.mul(a.hi, k),
    lo: g.mul(a.lo, k),
  });
  const arithmetic: Arithmetic<Pair<Node>> = {
    id: 'double-double',
    ...ops,
    mul(a, b) {
      const [k, l] = [scaleOf(a.hi), scaleOf(b.hi)];
      return l ? scaled(a, l) : k ? scaled(b, k) : ops.mul(a, b);
    },
    div(a, b) {
      const k = scaleOf(b.hi);
      return k ? scaled(a, g.of(1 / k.value)) : ops.div(a, b);
    },
    sign: noSign,
    whereNegative: (a, then, otherwise) => {
      const negative = g.less(a.hi, zero);
      return {
        hi: g.select(negative, then.hi, otherwise.hi),
        lo: g.select(negative, then.lo, otherwise.lo),
      };
    },
    toNumber: noSign,
  };
  return {
    arithmetic,
    lift: (hi) => ({ hi, lo: zero }),
    isNegative: ({ hi }) => g.less(hi, zero),
    isPositive: ({ hi }) => g.less(zero, hi),
    isZero: ({ hi }) => g.isZero(hi),
    isUnknown: ({ hi }) => g.not(g.isFinite(hi)),
    select: (where, a, b) => ({
      hi: g.select(where, a.hi, b.hi),
      lo: g.select(where, a.lo, b.lo),
    }),
    isWithin: ({ hi }, bound) => g.isWithin(hi, bound),
    shown: ({ hi }) => hi,
    sorted: (a, b) => [g.min(a.hi, b.hi), g.max(a.hi, b.hi)],
  };
}

/** float/directed.ts where neither an operand nor a result is near an end of the range. */
function inRange(g: Graph): Directed<Node> {
  const { sumError, productError, squareError } = errorsOver(g);
  const zero = g.of(0);
  const step = g.of(2 ** -53 * (1 + 2 ** -52));
  const lower = (x: Node, error: Node): Node =>
    g.sub(x, g.keep(g.less(error, zero), g.mul(g.abs(x), step)));
  const upper = (x: Node, error: Node): Node =>
    g.add(x, g.keep(g.less(zero, error), g.mul(g.abs(x), step)));
  const sum = (end: typeof lower) => (a: Node, b: Node) => {
    const s = g.add(a, b);
    const isOne = a.op === 'constant' || b.op === 'constant' ? s === a || s === b : false;
    return isOne ? s : end(s, sumError(a, b, s));
  };
  const product = (end: typeof lower) => (a: Node, b: Node) => {
    const p = g.mul(a, b);
    if (p.op !== 'mul') return p;
    return end(p, a === b ? squareError(a, p) : productError(a, b, p));
  };
  // Of a/b − q: that of the remainder a − q·b, over b.
  const quotient = (end: typeof lower) => (a: Node, b: Node) => {
    const q = g.div(a, b);
    const p = g.mul(q, b);
    const rest = g.sub(g.sub(a, p), productError(q, b, p));
    return end(q, g.signed(g.less(b, zero), rest));
  };
  const rooted = (end: typeof lower) => (a: Node) => {
    const s = g.sqrt(a);
    const p = g.mul(s, s);
    return end(s, g.sub(g.sub(a, p), squareError(s, p)));
  };
  return {
    addDown: sum(lower),
    addUp: sum(upper),
    mulDown: product(lower),
    mulUp: product(upper),
    divDown: quotient(lower),
    divUp: quotient(upper),
    sqrtDown: rooted(lower),
    sqrtUp: rooted(upper),
  };
}

function interval(g: Graph): Recorder<Ends<Node>> {
  const ops = intervalOver(g, inRange(g));
  const zero = g.of(0);
  const scaled = (a: Ends<Node>, k: Node): Ends<Node> => ({
    lo: g.mul(a.lo, k),
    hi: g.mul(a.hi, k),
  });
  const arithmetic: Arithmetic<Ends<Node>> = {
    id: 'interval',
    ...ops,
    mul(a, b) {
      const [k, l] = [scaleOf(a.lo), scaleOf(b.lo)];
      return l ? scaled(a, l) : k ? scaled(b, k) : ops.mul(a, b);
    },
    div(a, b) {
      const k = scaleOf(b.lo);
      return k ? scaled(a, g.of(1 / k.value)) : ops.div(a, b);
    },
    sign: noSign,
    whereNegative: (a, then, otherwise) => {
      const negative = g.less(a.hi, zero);
      return {
        lo: g.select(negative, then.lo, otherwise.lo),
        hi: g.select(negative, then.hi, otherwise.hi),
      };
    },
    toNumber: noSign,
  };
  const shown = ({ lo, hi }: Ends<Node>): Node => {
    const half = g.of(0.5);
    const middle = g.add(g.mul(lo, half), g.mul(hi, half));
    return g.select(g.equal(lo, hi), lo, middle);
  };
  return {
    arithmetic,
    lift: (x) => ({ lo: x, hi: x }),
    isNegative: ({ hi }) => g.less(hi, zero),
    isPositive: ({ lo }) => g.less(zero, lo),
    isZero: ({ lo, hi }) => g.and(g.isZero(lo), g.isZero(hi)),
    // Neither only above 0, nor only below, nor 0.
    isUnknown: ({ lo, hi }) =>
      g.not(g.or(g.or(g.less(zero, lo), g.less(hi, zero)), g.and(g.isZero(lo), g.isZero(hi)))),
    select: (where, a, b) => ({
      lo: g.select(where, a.lo, b.lo),
      hi: g.select(where, a.hi, b.hi),
    }),
    isWithin: ({ lo, hi }, bound) => g.less(g.max(g.abs(lo), g.abs(hi)), g.of(bound)),
    shown,
    sorted: (a, b) => [
      shown({ lo: g.min(a.lo, b.lo), hi: g.min(a.hi, b.hi) }),
      shown({ lo: g.max(a.lo, b.lo), hi: g.max(a.hi, b.hi) }),
    ],
  };
}

/** Every number system that kernels are made for, by the `id` of its arithmetic. */
export const SYSTEMS: Readonly<Record<string, System>> = {
  float32: {
    format: { width: 32, strict: true },
    isPlain: true,
    inBlocks: false,
    box: null,
    greatest: 2 ** 128 - 2 ** 104,
    large: 2 ** 126,
    tiny: 2 ** -60,
    wide: 2 ** 60,
    reach: null,
    make: (g) => known(plain(g, 'float32')),
  },
  float64: {
    format: { width: 64, strict: true },
    isPlain: true,
    inBlocks: false,
    box: null,
    greatest: Number.MAX_VALUE,
    large: 2 ** 1022,
    tiny: 2 ** -500,
    wide: 2 ** 500,
    reach: null,
    make: (g) => known(plain(g, 'float64')),
  },
  'double-double': {
    format: { width: 64, strict: false },
    isPlain: false,
    inBlocks: true,
    // The loops do what the trees do, one operation after the other: so what underflows is the
    // same. Only what overflows might not be.
    box: { least: 0, most: 2 ** 480 },
    greatest: 2 ** 900,
    large: 2 ** 500,
    tiny: 0,
    wide: 2 ** 980,
    reach: 2 ** 490,
    make: (g) => known(doubleDouble(g)),
  },
  interval: {
    format: { width: 64, strict: false },
    isPlain: false,
    inBlocks: false,
    box: { least: 2 ** -100, most: 2 ** 100 },
    greatest: 2 ** 900,
    large: 2 ** 500,
    tiny: 2 ** -150,
    wide: 2 ** 900,
    reach: null,
    make: (g) => known(interval(g)),
  },
};
