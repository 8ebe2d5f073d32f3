/*
 * Running error analysis (Wilkinson 1963): a number and the most that the operations which made it
 * may have put it off, if each is off by as much as it can be. No ray reaches that, since roundings
 * do not all point one way; but a bound must cover it, and should not be much above it.
 */

export interface Off {
  readonly x: number;
  readonly off: number;
}

/**
 * What one operation may cost: `sum` and `product` of its result, `lost` of a product that leaves
 * the doubles.
 */
interface Costs {
  readonly sum: number;
  readonly product: number;
  readonly lost?: number;
}

const U = 2 ** -53;

export const DOUBLES: Costs = { sum: U, product: U };
/** Of float/double-double.ts. */
export const TWICE: Costs = { sum: 3 * U * U, product: 5 * U * U };

export const known = (x: number, relative = 0): Off => ({ x, off: relative * Math.abs(x) });
export const size = ({ x, off }: Off): number => Math.abs(x) + off;
export const negative = ({ x, off }: Off): Off => ({ x: -x, off });

export type Arithmetic = ReturnType<typeof running>;

export function running({ sum, product, lost = 0 }: Costs) {
  const add = (a: Off, b: Off): Off => {
    const [x, off] = [a.x + b.x, a.off + b.off];
    if (size(a) === 0 || size(b) === 0) return { x, off };
    return { x, off: off + sum * (Math.abs(x) + off) };
  };
  /** A product that is split without loss: of two doubles, in twice the digits. */
  const exactly = (a: Off, b: Off): Off => {
    const x = a.x * b.x;
    return { x, off: Math.abs(a.x) * b.off + Math.abs(b.x) * a.off + a.off * b.off + lost };
  };
  const mul = (a: Off, b: Off): Off => {
    const p = exactly(a, b);
    return { x: p.x, off: p.off + product * size(p) };
  };
  const sub = (a: Off, b: Off): Off => add(a, negative(b));
  return { add, sub, mul, exactly, sqr: (a: Off): Off => mul(a, a) };
}
