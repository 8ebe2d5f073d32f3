import { describe, expect, test } from 'vitest';
import { whereLost, whyLost } from '../../../src/lab/explain.ts';
import { lossesOf } from '../../../src/lab/losses.ts';
import { plainText } from '../../../src/lab/plain-text.ts';
import { operationsOf } from '../../../src/lab/steps.ts';
import { thisRay } from '../../../src/lab/this-ray.ts';
import { toNumber } from '../../../src/math/exact/surd.ts';
import { FAMILIES } from '../../../src/math/families.ts';
import { METHODS } from '../../../src/math/methods/index.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { seeded } from '../../../src/math/rng.ts';
import type { Shape } from '../../../src/math/shapes/index.ts';

const cone: Shape = { kind: 'cone', vertex: [0, 3, 0], slope: 0.5 };
const far: Ray = { origin: [15000, 3300, 3100], direction: [-0.93, -0.18, -0.2] };
const method = (id: string) => METHODS.find((one) => one.id === id) ?? METHODS[0];

const called =
  (id: string) =>
  ({ letter, digits }: { letter: unknown; digits: number | null }) =>
    digits !== null && JSON.stringify(letter) === JSON.stringify({ op: 'scalar', id });

describe('the trace of a method', () => {
  test('has the numbers of the method and of exact, 5 rays of each family (seed 11)', () => {
    const random = seeded(11);
    let compared = 0;
    for (const family of FAMILIES()) {
      for (let k = 0; k < 5; k++) {
        const { shape, ray } = family.make(random);
        for (const one of METHODS) {
          if (!one.parts) continue;
          const found = one.intersect(shape, ray);
          const truth = method('exact').intersect(shape, ray);
          const { details } = found;
          const { details: exact } = truth;
          if (details.family !== 'curved' || exact.family !== 'curved') continue;
          const all = operationsOf(one, shape, ray);
          for (const id of ['A', 'B', 'C', 'D'] as const) {
            const step = all.find(called(id));
            expect(step?.own).toBe(details[id]);
            expect(step?.exact && toNumber(step.exact)).toBe(exact[id]);
            compared += 1;
          }
          const roots = all.filter(
            ({ letter }) => plainText(letter ?? { op: 'scalar', id: '' }) === 't',
          );
          // Enclosures are cut where they cross, so an interval's root may have another middle than
          // its last step.
          if (one.id === 'interval' || found.class === 'undecided') continue;
          expect(roots.map(({ own }) => own).sort((a, b) => a - b)).toEqual(
            found.hits.map(({ t }) => t),
          );
        }
      }
    }
    expect(compared).toBeGreaterThan(1000);
  });
});

describe('where digits go', () => {
  test('far away the textbook loses them in D, the moment form in nothing to speak of', () => {
    const { worst, steps } = lossesOf(method('textbook'), cone, far);
    expect(worst?.text).toBe('B² − 4 A C');
    expect(worst?.lost).toBeGreaterThan(3);
    expect(whyLost(worst as NonNullable<typeof worst>)).toBe(
      'D = B² − 4 A C: the first 3 digits of B² and 4 A C cancel, and what was rounded ' +
        'behind them moves to the front; 11 of 16 digits are left.',
    );
    expect(steps.map(({ text }) => text)).toContain('2 dx (Ex − Vx)');
    expect(steps.filter(({ text }) => text === 'Ex − Vx')).toHaveLength(1);
    expect(steps.map(({ text }) => text)).not.toContain('dx² + dz²');
    expect(lossesOf(method('moment'), cone, far).worst?.lost ?? 0).toBeLessThan(1);
    expect(lossesOf(method('exact'), cone, far).worst).toBeNull();
  });

  test('in single precision they are gone before anything is computed', () => {
    const { worst } = lossesOf(method('textbook32'), cone, far);
    expect(worst?.inputs).toHaveLength(0);
    expect(worst?.digits).toBeLessThan(9);
  });

  test('near the surface the small root loses them where −B and √D cancel; stable does not', () => {
    const cylinder: Shape = { kind: 'cylinder', center: [0, 0, 0], radius: 2 };
    const near: Ray = { origin: [2.00000001, 1, 0], direction: [-1, 0.3, 0.1] };
    expect(lossesOf(method('textbook'), cylinder, near).worst?.text).toMatch(/√D|− r²/);
  });

  test('what underflows is lost, though no double is nearer; what overflows too', () => {
    const at = (size: number): [Shape, Ray] => [
      { kind: 'cone', vertex: [0, 0, 0], slope: 1 },
      { origin: [size, 0, 0], direction: [size, 3 * size, 0] },
    ];
    const tiny = lossesOf(method('textbook'), ...at(1e-170)).worst;
    expect([tiny?.text, tiny?.own, tiny?.digits]).toEqual(['dx²', 0, 0]);
    expect(whyLost(tiny as NonNullable<typeof tiny>)).toBe(
      'dx² is smaller than the smallest number there is: no digit is left.',
    );
    const huge = lossesOf(method('textbook'), ...at(1e170)).worst;
    expect([huge?.text, huge?.own, huge?.digits]).toEqual(['dx²', Number.POSITIVE_INFINITY, 0]);
    const row = thisRay(...at(1e-170)).rows.find((one) => one.method.id === 'textbook');
    expect(row && whereLost(row, lossesOf(method('textbook'), ...at(1e-170)))).toBe(
      'dx²: underflow',
    );
  });

  test('every family, every method: words without gaps, seed 12', () => {
    const random = seeded(12);
    for (const family of FAMILIES()) {
      const { shape, ray } = family.make(random);
      for (const row of thisRay(shape, ray).rows) {
        const losses = lossesOf(row.method, shape, ray);
        const texts = [
          whereLost(row, losses),
          ...(losses.worst ? [whyLost(losses.worst)] : []),
          ...losses.steps.map(({ text }) => text),
        ];
        for (const text of texts) expect(text).not.toMatch(/undefined|NaN|null|\[object|^$/);
        for (const { lost, digits } of losses.steps) {
          expect(lost).toBeGreaterThanOrEqual(0);
          if (digits !== null) expect(digits).toBeLessThanOrEqual(15.95);
        }
      }
    }
  });
});

describe('the table of this ray', () => {
  test('tells the digits of a far ray', () => {
    const { rows } = thisRay(cone, far);
    const counts = Object.fromEntries(
      rows.map(({ method: { id }, roots }) => [id, roots.map(({ count }) => count)]),
    );
    expect(counts).toMatchObject({
      textbook32: [5, 5],
      textbook: [14, 14],
      stable: [14, 14],
      moment: [16, 16],
      compensated: [16, 16],
      interval: [16, 15],
      certified: [16, 16],
      exact: [16, 16],
    });
    for (const { roots } of rows) {
      for (const { marked, count } of roots) {
        expect(marked.right.replace(/[^0-9]/g, '')).toHaveLength(count);
      }
    }
  });

  test('the top methods are right on every family, seed 13', () => {
    const random = seeded(13);
    for (const family of FAMILIES()) {
      const { shape, ray } = family.make(random);
      const { rows, reference } = thisRay(shape, ray);
      for (const {
        method: { id },
        judgement,
        roots,
      } of rows) {
        expect(
          roots.every(({ digits }) => (digits === null) === (reference.hits.length === 0)),
        ).toBe(true);
        if (id !== 'exact' && id !== 'certified') continue;
        expect(judgement).toBe('right');
        for (const { ulps } of roots) expect(ulps).toBeLessThanOrEqual(id === 'exact' ? 0 : 1);
      }
    }
  });
});
