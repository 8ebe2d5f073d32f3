import { float64 } from '../../../src/math/arithmetic/float64.ts';
import type { Values } from '../../../src/math/formula/evaluate.ts';
import { dotProduct, squaredNorm, type Triple } from '../../../src/math/formula/evaluate.ts';

/**
 * Reads a formula as a person reads it, and works it out in doubles from the left: LaTeX as the
 * printer writes it, and MathML after `asLatex`. Written apart from the printer, so that a lost
 * pair of parentheses shows in the value.
 */
export function readLatex(text: string, values: Values<number>, branch: 1 | -1 = 1): number {
  const tokens = text.replace(/\\(left|right)(?![a-z])/g, '').match(/\\[a-z]+|[\d.]+|\S/g) ?? [];
  const reader = new Reader(tokens, values, branch);
  const value = scalarOf(reader.sum());
  if (reader.peek() !== undefined) throw new Error(`left over: ${reader.peek()} in ${text}`);
  return value;
}

type Read = number | Triple<number>;

const scalarOf = (x: Read): number => {
  if (typeof x !== 'number') throw new Error('a vector where a number should be');
  return x;
};

class Reader {
  private at = 0;
  constructor(
    private readonly tokens: readonly string[],
    private readonly values: Values<number>,
    private readonly branch: 1 | -1,
  ) {}

  peek(): string | undefined {
    return this.tokens[this.at];
  }

  private take(expected?: string): string {
    const token = this.tokens[this.at++];
    if (token === undefined || (expected !== undefined && token !== expected)) {
      throw new Error(`${token} instead of ${expected}`);
    }
    return token;
  }

  sum(): Read {
    let total = this.signedProduct();
    for (;;) {
      const sign = this.peek();
      if (sign !== '+' && sign !== '-' && sign !== '\\pm') return total;
      this.take();
      const next = this.product();
      total = add(total, next, sign === '\\pm' ? this.branch : sign === '+' ? 1 : -1);
    }
  }

  private signedProduct(): Read {
    if (this.peek() !== '-') return this.product();
    this.take();
    return -scalarOf(this.product());
  }

  private product(): Read {
    let total = this.factor();
    for (;;) {
      const next = this.peek();
      if (next === '\\cdot') this.take();
      else if (next === undefined || !/^([\d.]+|[A-Za-z(]|\\(frac|sqrt|lvert|infty))$/.test(next)) {
        return total;
      } else if (/^[\d.]/.test(next)) throw new Error(`digits run together at ${next}`);
      const factor = this.factor();
      total =
        typeof total === 'number'
          ? total * scalarOf(factor)
          : dotProduct(total, factor as Triple<number>, float64);
    }
  }

  private factor(): Read {
    const base = this.base();
    if (this.peek() !== '^') return base;
    this.take();
    const x = scalarOf(base);
    const exponent = this.peek() === '{' ? this.group() : Number(this.take());
    return exponent === 2 ? x * x : Number(`1e${exponent}`);
  }

  private base(): Read {
    const token = this.take();
    if (token === '(') {
      const parts = [this.sum()];
      while (this.peek() === ',') {
        this.take();
        parts.push(this.sum());
      }
      this.take(')');
      return parts.length === 3 ? (parts as unknown as Triple<number>) : (parts[0] ?? Number.NaN);
    }
    if (token === '\\frac') return this.group() / this.group();
    if (token === '\\sqrt') return Math.sqrt(this.group());
    if (token === '\\infty') return Number.POSITIVE_INFINITY;
    if (token === '\\lvert') {
      const inner = this.sum();
      this.take('\\rvert');
      return Math.sqrt(squaredNorm(inner as Triple<number>, float64));
    }
    if (/^[\d.]+$/.test(token)) return Number(token);
    return this.symbol(token);
  }

  private symbol(id: string): Read {
    if (this.peek() === '_') {
      this.take();
      const axis = 'xyz'.indexOf(this.take());
      return this.values.vectors[id]?.[axis as 0 | 1 | 2] ?? Number.NaN;
    }
    const value = this.values.scalars[id] ?? this.values.vectors[id];
    if (value === undefined) throw new Error(`unknown ${id}`);
    return value;
  }

  private group(): number {
    this.take('{');
    const value = scalarOf(this.sum());
    this.take('}');
    return value;
  }
}

function add(a: Read, b: Read, sign: 1 | -1): Read {
  if (typeof a === 'number') return sign === 1 ? a + scalarOf(b) : a - scalarOf(b);
  const v = b as Triple<number>;
  return [a[0] + sign * v[0], a[1] + sign * v[1], a[2] + sign * v[2]];
}
