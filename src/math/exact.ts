/** Door: exact numbers (u + v√D)/w and the method that answers in them. */

export { decimalDigits } from './exact/decimal.ts';
export { exactOf } from './exact/of-typed.ts';
export {
  add,
  compare,
  div,
  fromNumber,
  isZero,
  mul,
  neg,
  type Surd,
  sign,
  sub,
  toNumber,
} from './exact/surd.ts';
export { exact as exactMethod } from './methods/exact.ts';
