import { SPLITTER } from '../../../src/math/float/eft.ts';
import type { Floats } from '../../../src/math/float/floats.ts';

/** A value of the straight-line program: a number, or a condition. */
export interface Node {
  readonly op: Op;
  readonly args: readonly Node[];
  /** Of a constant. */
  readonly value: number;
  /** Of an input or of a number of the shape. */
  readonly name: string;
  /** The same for all rays. */
  readonly uniform: boolean;
}

export type Op =
  | 'input'
  | 'number'
  | 'constant'
  | 'add'
  | 'sub'
  | 'mul'
  | 'div'
  | 'neg'
  | 'abs'
  | 'sqrt'
  | 'min'
  | 'max'
  | 'less'
  | 'atMost'
  | 'equal'
  | 'and'
  | 'or'
  | 'not'
  | 'select'
  | 'keep'
  | 'signed'
  | 'unless';

const OF_NUMBERS: Readonly<Partial<Record<Op, (a: number, b: number) => number>>> = {
  add: (a, b) => a + b,
  sub: (a, b) => a - b,
  mul: (a, b) => a * b,
  div: (a, b) => a / b,
  neg: (a) => -a,
  abs: (a) => Math.abs(a),
  sqrt: (a) => Math.sqrt(a),
};

export interface Format {
  /** Bits of a number: float32 or float64. */
  readonly width: 32 | 64;
  /**
   * Whether the sign of a zero counts. Where it does not, and all numbers are finite, x + 0 is x
   * and x · 0 is 0.
   */
  readonly strict: boolean;
}

/** Records operations; the same one on the same values is one node. */
export class Graph implements Floats<Node, Node> {
  readonly format: Format;
  /** Conditions of rays that are left to the trees, since `take`. */
  private rare: Node[] = [];
  private readonly known = new Map<string, Node>();
  private readonly ids = new Map<Node, number>();

  constructor(format: Format) {
    this.format = format;
  }

  input = (name: string): Node => this.make('input', [], 0, name);
  number = (name: string): Node => this.make('number', [], 0, name);
  of = (x: number): Node =>
    this.make('constant', [], this.format.width === 32 ? Math.fround(x) : x);

  add = (a: Node, b: Node): Node => {
    if (this.format.strict) return this.make('add', [a, b]);
    if (isZero(a)) return b;
    // A rounded sum and what it lost are the exact sum, which rounds to the same.
    return isZero(b) || this.isLostBy(a, b) ? a : this.make('add', [a, b]);
  };
  sub = (a: Node, b: Node): Node => {
    if (this.format.strict) return this.make('sub', [a, b]);
    if (isZero(b)) return a;
    if (isZero(a)) return this.neg(b);
    if (a === b) return this.of(0);
    const [x, y] = [doubled(a), doubled(b)];
    if (x && y && x.by === y.by) return this.mul(this.sub(x.of, y.of), x.by);
    return this.make('sub', [a, b]);
  };
  mul = (a: Node, b: Node): Node => {
    if (isConstant(a, 1)) return b;
    if (isConstant(b, 1)) return a;
    if (this.format.strict) return this.make('mul', [a, b]);
    if (isZero(a) || isZero(b)) return this.of(0);
    // So that 2x is cut where x is, and once (errorsOver).
    const x = isConstant(a, SPLITTER) ? doubled(b) : null;
    return x ? this.mul(this.mul(a, x.of), x.by) : this.make('mul', [a, b]);
  };
  /** By a power of two it is a product, to the bit. */
  div = (a: Node, b: Node): Node => {
    if (b.op === 'constant' && isPowerOfTwo(b.value)) return this.mul(a, this.of(1 / b.value));
    return this.make('div', [a, b]);
  };
  neg = (a: Node): Node => (a.op === 'neg' ? (a.args[0] as Node) : this.make('neg', [a]));
  abs = (a: Node): Node => this.make('abs', [a]);
  sqrt = (a: Node): Node => this.make('sqrt', [a]);
  min = (a: Node, b: Node): Node => (a === b ? a : this.make('min', [a, b]));
  max = (a: Node, b: Node): Node => (a === b ? a : this.make('max', [a, b]));
  less = (a: Node, b: Node): Node => this.make('less', [a, b]);
  atMost = (a: Node, b: Node): Node => this.make('atMost', [a, b]);
  and = (a: Node, b: Node): Node => (a === b ? a : this.make('and', [a, b]));
  or = (a: Node, b: Node): Node => (a === b ? a : this.make('or', [a, b]));
  not = (a: Node): Node => (a.op === 'not' ? (a.args[0] as Node) : this.make('not', [a]));
  select = (where: Node, then: Node, otherwise: Node): Node =>
    then === otherwise ? then : this.make('select', [where, then, otherwise]);
  keep = (where: Node, a: Node): Node => this.make('keep', [where, a]);
  /** −a where the condition holds, else a. */
  signed = (where: Node, a: Node): Node => this.make('signed', [where, a]);
  /** NaN where the condition holds, else a. */
  unless = (where: Node, a: Node): Node => this.make('unless', [where, a]);

  /** The same number, with 0 for −0, whatever the format. */
  unsigned = (a: Node): Node => this.make('add', [a, this.of(0)]);

  /** The same number, with 0 for −0 where the sign of a zero does not count. */
  unsignedIfLoose = (a: Node): Node => (this.format.strict ? a : this.unsigned(a));

  /** Two zeros are equal, whatever their signs. */
  equal = (a: Node, b: Node): Node => this.make('equal', [a, b]);
  isZero = (a: Node): Node => this.equal(a, this.of(0));
  /** |a| < bound: false for NaN. */
  isWithin = (a: Node, bound: number): Node => this.less(this.abs(a), this.of(bound));

  /** Neither an infinity nor NaN: x − x would count as 0 where the format is not strict. */
  isFinite = (a: Node): Node => this.atMost(this.abs(a), this.of(Number.MAX_VALUE));

  rarely = (m: Node): boolean => {
    this.rare.push(m);
    return false;
  };

  /** What `rarely` was told since the last time. */
  take(): readonly Node[] {
    const taken = [...new Set(this.rare)];
    this.rare = [];
    return taken;
  }

  /** Whether e is sumError of the sum s (float/eft.ts). */
  private isLostBy(s: Node, e: Node): boolean {
    if (s.op !== 'add' || e.op !== 'add') return false;
    const [a, b] = s.args as [Node, Node];
    const part = this.sub(s, a);
    return e.args[0] === this.sub(a, this.sub(s, part)) && e.args[1] === this.sub(b, part);
  }

  private make(op: Op, args: readonly Node[], value = 0, name = ''): Node {
    const fold = OF_NUMBERS[op];
    if (fold && args.length > 0 && args.every((a) => a.op === 'constant')) {
      const [a, b] = args as [Node, Node];
      return this.of(fold(a.value, b?.value ?? 0));
    }
    const exactly = Object.is(value, -0) ? '-0' : String(value);
    const key = [op, name, exactly, ...args.map((a) => this.ids.get(a))].join(' ');
    const found = this.known.get(key);
    if (found) return found;
    const uniform = op === 'input' ? false : args.every((a) => a.uniform);
    const made: Node = { op, args, value, name, uniform };
    this.ids.set(made, this.ids.size);
    this.known.set(key, made);
    return made;
  }
}

const isConstant = (a: Node, x: number): boolean => a.op === 'constant' && a.value === x;
const isZero = (a: Node): boolean => isConstant(a, 0);
/** x · by for a power of two above 1: exact, also where numbers are subnormal. */
function doubled(a: Node): { readonly of: Node; readonly by: Node } | null {
  const [of, by] = a.args as [Node, Node];
  return a.op === 'mul' && by.op === 'constant' && by.value > 1 && isPowerOfTwo(by.value)
    ? { of, by }
    : null;
}
export const isPowerOfTwo = (x: number): boolean =>
  Math.abs(x) > 2 ** -100 && Math.abs(x) < 2 ** 100 && Number.isInteger(Math.log2(Math.abs(x)));

/** Whether `node` is worked out from `from`. */
export function dependsOn(node: Node, from: Node): boolean {
  const seen = new Set<Node>();
  const walk = (n: Node): boolean => {
    if (n === from) return true;
    if (seen.has(n)) return false;
    seen.add(n);
    return n.args.some(walk);
  };
  return walk(node);
}
