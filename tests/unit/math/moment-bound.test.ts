import { describe, expect, test } from 'vitest';
import * as dy from '../../../src/math/exact/dyadic.ts';
import { momentError } from '../../../src/math/methods/certified/class.ts';
import { type Random, seeded, uniform } from '../../../src/math/rng.ts';

/*
 * D/4 by the moment in doubles, against the same exactly: below its bound, and not far below where
 * each part of it rules.
 */

const n = dy.fromNumber;
const square = (x: dy.Dyadic): dy.Dyadic => dy.mul(x, x);

/** For a cylinder with centre C: how much of the bound the error of ρA − m² takes. */
function share(
  r: number,
  [dx, dz]: readonly [number, number],
  [Ex, Ez]: readonly [number, number],
  [Cx, Cz]: readonly [number, number],
): number {
  const rho = r * r;
  const px = Ex - Cx;
  const pz = Ez - Cz;
  const A = dx * dx + dz * dz;
  const m = dz * px - dx * pz;
  const D = rho * A - m * m;
  const exactA = dy.add(square(n(dx)), square(n(dz)));
  const exactM = dy.sub(dy.mul(n(dz), dy.sub(n(Ex), n(Cx))), dy.mul(n(dx), dy.sub(n(Ez), n(Cz))));
  const exact = dy.sub(dy.mul(square(n(r)), exactA), square(exactM));
  const S = (Math.abs(dx) + Math.abs(dz)) * (Math.abs(px) + Math.abs(pz));
  return Math.abs(dy.toNumber(dy.sub(n(D), exact))) / momentError(S, Math.abs(m), rho * A);
}

const pair = (random: Random): readonly [number, number] => [
  uniform(random, 0.5, 2),
  uniform(random, 0.5, 2),
];

const ORIGIN = [0, 0] as const;

const cases: [string, (random: Random) => number][] = [
  [
    'moment alone, along one axis',
    (r) => share(0, [2 ** -40, pair(r)[0]], [-pair(r)[0], 0], [pair(r)[1], 0]),
  ],
  ['ρA alone', (r) => share(uniform(r, 1, 2), pair(r), ORIGIN, ORIGIN)],
];

describe('the bound of D/4 by the moment (seed 71)', () => {
  test.each(cases)('%s', (_, make) => {
    const random = seeded(71);
    let worst = 0;
    for (let k = 0; k < 30000; k++) worst = Math.max(worst, make(random));
    expect(worst).toBeLessThan(1);
    expect(worst).toBeGreaterThan(1 / 8);
  });
});
