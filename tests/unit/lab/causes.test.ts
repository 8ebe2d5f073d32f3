import { describe, expect, test } from 'vitest';
import { absorbedBy, type Cause, inputsOf } from '../../../src/lab/causes.ts';
import { whyLost } from '../../../src/lab/explain.ts';
import { lossesOf, type StepLoss } from '../../../src/lab/losses.ts';
import type { Operation } from '../../../src/lab/trace.ts';
import * as surd from '../../../src/math/exact/surd.ts';
import { FAMILIES } from '../../../src/math/families.ts';
import { METHODS } from '../../../src/math/methods/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';
import { isFloat32 } from '../math/shorthand.ts';

const { compare, fromNumber, sub, add, mul, div, sign } = surd;
type Surd = surd.Surd;

const abs = (x: Surd): Surd => (sign(x) < 0 ? surd.neg(x) : x);
const ZERO = fromNumber(0);

/** The operation on the method's own numbers, without rounding. */
function unrounded({ expr, inputs }: Operation): Surd | null {
  const own = inputs.map((input) => input.own);
  if (!own.every(Number.isFinite)) return null;
  const [a = ZERO, b = ZERO] = own.map(fromNumber);
  if (expr.op === 'sum') return expr.terms.at(-1)?.sign === 1 ? add(a, b) : sub(a, b);
  if (expr.op === 'product') return mul(a, b);
  if (expr.op === 'square') return mul(a, a);
  if (expr.op === 'quotient') return sign(b) === 0 ? null : div(a, b);
  return null;
}

const chain = (step: Operation): Operation[] => [step, ...absorbedBy(step).flatMap(chain)];

/** The definitions of causes.ts, each worked out from the step's exact numbers anew. */
function holds(step: StepLoss, cause: Cause, format: string): boolean {
  const least = fromNumber(format === 'float32' ? 2 ** -126 : 2 ** -1022);
  const most = fromNumber(format === 'float32' ? (2 - 2 ** -23) * 2 ** 127 : Number.MAX_VALUE);
  const links = cause.kind in { overflow: 1, underflow: 1 } ? chain(step) : [];
  const isHere = (is: (link: Operation) => boolean): boolean =>
    'within' in cause && (cause.within ? links.slice(1).some(is) : is(step));
  const terms = inputsOf(step).map(({ exact }) => abs(exact ?? ZERO));
  const largest = terms.reduce((a, b) => (compare(a, b) < 0 ? b : a), ZERO);
  const isSum = step.expr.op === 'sum';
  const exact = step.exact ?? ZERO;
  switch (cause.kind) {
    case 'input':
      if (!Number.isFinite(step.own)) return step.inputs.length === 0;
      return step.inputs.length === 0 && compare(exact, fromNumber(step.own)) !== 0;
    case 'division':
      return step.expr.op === 'quotient' && [0, Number.NaN].includes(step.inputs[1]?.sign ?? 1);
    case 'overflow':
      if (links.every(({ own }) => Number.isFinite(own))) return false;
      return cause.within || compare(abs(unrounded(step) ?? ZERO), most) > 0;
    case 'underflow':
      return isHere((link) => {
        if (link.expr.op === 'sum') return false;
        const truth = unrounded(link);
        const tiny = truth !== null && sign(truth) !== 0 && compare(abs(truth), least) < 0;
        return (
          tiny && compare(truth, fromNumber(link.own)) !== 0 && cause.flushed === (link.own === 0)
        );
      });
    case 'zero':
      return isSum && sign(exact) === 0 && step.own !== 0;
    case 'total': {
      const errors = step.inputs.map(({ own, exact: x }) => abs(sub(fromNumber(own), x ?? ZERO)));
      return isSum && compare(abs(exact), errors.reduce(add, ZERO)) <= 0;
    }
    case 'cancellation': {
      const shrunk = mul(abs(exact), fromNumber(10 ** cause.digits));
      return isSum && cause.digits >= 1 && compare(shrunk, largest) <= 0;
    }
    default:
      return true;
  }
}

const formatOf = (id: string): string => (isFloat32(id) ? 'float32' : 'float64');

/** Every cause that is named on a ray, by any method. */
function check(shape: Shape, ray: Ray, seen: Map<string, number>): void {
  for (const method of METHODS) {
    for (const step of lossesOf(method, shape, ray).steps) {
      if (!step.cause) continue;
      seen.set(step.cause.kind, (seen.get(step.cause.kind) ?? 0) + 1);
      const where = `${method.id}: ${step.text}, ${JSON.stringify(step.cause)}, own ${step.own}`;
      expect(holds(step, step.cause, formatOf(method.id)), where).toBe(true);
      const words = whyLost(step);
      if (step.expr.op === 'sum') expect(words).not.toContain('smallest number');
      if (words.includes('no digit is left')) expect(step.digits ?? 0).toBeLessThan(1);
    }
  }
}

describe('a cause that is named holds, worked out exactly', () => {
  test('on 6 rays of each family by every method, seed 31', () => {
    const random = seeded(31);
    const seen = new Map<string, number>();
    for (const family of FAMILIES()) {
      for (let k = 0; k < 6; k++) {
        const { shape, ray } = family.make(random);
        check(shape, ray, seen);
      }
    }
    expect([...seen.keys()].toSorted()).toEqual(
      expect.arrayContaining(['cancellation', 'input', 'overflow', 'total', 'underflow', 'zero']),
    );
  });

  test('where squares and products of squares leave the range, either way', () => {
    const seen = new Map<string, number>();
    const shapes: Shape[] = [
      { kind: 'cone', vertex: [0, 0, 0], slope: 1 },
      { kind: 'cylinder', center: [0, 0, 0], radius: 1 },
      { kind: 'plane', normal: [1, 2, 3], point: [0, 0, 0] },
    ];
    for (const shape of shapes) {
      for (const power of [-320, -305, -170, -160, -80, -40, -20, 20, 40, 80, 154, 170, 299, 307]) {
        const size = 10 ** power;
        check(shape, { origin: [3 * size, 0, size / 7], direction: [-size, 0.3 * size, 0] }, seen);
        check(shape, { origin: [3, 0.1, 0.2], direction: [-size, 3 * size, size / 9] }, seen);
        check(shape, { origin: [3 * size, size, 0], direction: [-1, 0.2, 0.1] }, seen);
      }
    }
    expect(seen.get('underflow')).toBeGreaterThan(20);
    expect(seen.get('overflow')).toBeGreaterThan(20);
  });
});
