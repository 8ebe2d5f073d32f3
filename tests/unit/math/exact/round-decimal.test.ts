import { Decimal } from 'decimal.js';
import { expect, test } from 'vitest';
import type { Dyadic } from '../../../../src/math/exact/dyadic.ts';
import * as dy from '../../../../src/math/exact/dyadic.ts';
import { bracket } from '../../../../src/math/exact/faithful.ts';
import { isqrt } from '../../../../src/math/exact/isqrt.ts';
import type { Surd } from '../../../../src/math/exact/surd.ts';
import * as surd from '../../../../src/math/exact/surd.ts';
import { nextUp } from '../../../../src/math/float/ulp.ts';
import { integer, pick, randomSign, seeded, uniform, wide } from '../../../../src/math/rng.ts';
import { many } from '../../many.ts';

/*
 * decimal.js knows nothing of binary, and `Number(text)` rounds a decimal text once: together they
 * are an oracle that shares no line with the code under test.
 */
const d = dy.fromNumber;
/** m·2^e as a decimal text, exactly: 2^-k = 5^k/10^k. */
const text = ({ m, e }: Dyadic) => (e < 0 ? `${m * 5n ** BigInt(-e)}e${e}` : `${m << BigInt(e)}`);

interface Oracle {
  of(x: Dyadic): Decimal;
  value(s: Surd): Decimal;
}

function oracle(precision: number): Oracle {
  const Digits = Decimal.clone({ precision, toExpNeg: -9e15, toExpPos: 9e15 });
  const of = (x: Dyadic) => new Digits(text(x));
  const top = ({ u, v, D }: Surd) => of(D).sqrt().mul(of(v)).add(of(u));
  return { of, value: (s) => top(s).div(of(s.w)) };
}

const show = (s: Surd) =>
  Object.entries(s)
    .map(([key, { m, e }]) => `${key} = ${m}·2^${e}`)
    .join(', ');

function check(s: Surd, { of, value }: Oracle): void {
  const exact = value(s);
  const want = Number(exact.toString());
  if (!Object.is(surd.toNumber(s), want)) expect.fail(`want ${want}: ${show(s)}`);
  const [low, high] = bracket(s);
  const below = !Number.isFinite(low) || exact.gte(of(d(low)));
  const above = !Number.isFinite(high) || exact.lte(of(d(high)));
  if (!below || !above) expect.fail(`bracket: ${show(s)}`);
  if (low !== high && nextUp(low) !== high) expect.fail(`bracket too wide: ${show(s)}`);
}

test(`${many(3000)} ordinary surds (seed 8)`, () => {
  const random = seeded(8);
  const x = () => d(uniform(random, -10, 10));
  const truth = oracle(120);
  for (let i = 0; i < many(3000); i++) check(surd.surd(x(), x(), x(), dy.abs(x())), truth);
});

test(`${many(1500)} surds of wide range, many beyond the doubles (seed 9)`, () => {
  const random = seeded(9);
  const x = () => d(wide(random, -600, 500));
  const truth = oracle(300);
  for (let i = 0; i < many(1500); i++) check(surd.surd(x(), x(), x(), dy.abs(x())), truth);
});

test(`${many(1500)} surds whose terms cancel to the last bits (seed 10)`, () => {
  const random = seeded(10);
  const truth = oracle(300);
  for (let i = 0; i < many(1500); i++) check(cancelling(random), truth);
});

test(`${many(1500)} surds that cancel 1 to 200 bits (seed 13)`, () => {
  const random = seeded(13);
  const truth = oracle(300);
  for (let i = 0; i < many(1500); i++)
    check(cancellingBits(random, integer(random, 1, 200)), truth);
});

test(`${many(300)} surds near or at a midpoint, some subnormal (seed 11)`, () => {
  const random = seeded(11);
  // Ties must be exact here: k·2^-1150 with k < 2^1160 has up to 1160 digits.
  const truth = oracle(1300);
  for (let i = 0; i < many(300); i++) check(nearMidpoint(random), truth);
});

/** u = −fl(v√D), a few ulp off. */
function cancelling(random: () => number): Surd {
  const D = Math.abs(wide(random, -300, 300));
  const v = wide(random, -100, 100);
  let u = -v * Math.sqrt(D);
  for (let i = integer(random, 0, 3); i > 0; i--) u = nextUp(u);
  return surd.surd(d(u), d(v), d(wide(random, -100, 100)), d(D));
}

/** ±(√D − √D cut to so many bits behind its point), over w. */
function cancellingBits(random: () => number, bits: number): Surd {
  const D = d(uniform(random, 1, 2));
  const root = isqrt((D.m << BigInt(2 * bits)) >> BigInt(-D.e));
  const v = d(randomSign(random));
  const u = dy.mul(dy.neg(v), { m: root, e: -bits });
  return surd.surd(u, v, d(wide(random, -5, 5)), D);
}

/** A midpoint of two doubles, of any size down to half the smallest subnormal. */
function midpoint(random: () => number): { middle: Dyadic; step: Dyadic } {
  const x = wide(random, pick(random, [-1074, -10]), pick(random, [-1030, 10]));
  const step = dy.sub(d(nextUp(x)), d(x));
  return { middle: dy.add(d(x), dy.shift(step, -1)), step };
}

/** (u + v√D)/w with a square D and an exact tie, or with a hair down to 2^-300 of a step. */
function nearMidpoint(random: () => number): Surd {
  const { middle, step } = midpoint(random);
  const w = d(wide(random, -20, 20));
  if (random() < 0.3) {
    const root = d(pick(random, [1, 3, 5]));
    const v = d(integer(random, 1, 9) * randomSign(random));
    // u takes back what v√D adds.
    return surd.surd(dy.sub(dy.mul(middle, w), dy.mul(v, root)), v, w, dy.sqr(root));
  }
  const hair = { m: BigInt(integer(random, -1, 1)), e: step.e - integer(random, 5, 300) };
  const D = d(integer(random, 1, 50));
  return surd.surd(dy.mul(middle, w), dy.mul(hair, w), w, D);
}
