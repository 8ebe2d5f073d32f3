import { describe, expect, test } from 'vitest';
import { BUSY, multipleOf, priceOf, rounded, spreadOf } from '../../../src/lab/price.ts';
import { detailsOf, headlineOf } from '../../../src/lab/sentence.ts';
import type { MeasuredRow } from '../../../src/lab/session.ts';
import { seeded } from '../../../src/math/rng.ts';

/**
 * Rounds of a task that takes `ms` by itself, on a machine whose other work adds to up to two in
 * three of them.
 */
function rounds(ms: number, count: number, busy: number, random: () => number): number[] {
  return Array.from({ length: count }, (_, k) =>
    k % 3 === 0 || random() > busy ? ms : ms * (1 + 3 * random()),
  );
}

describe('a price', () => {
  test('is the lower quartile: one round that stalls changes nothing, whichever it is', () => {
    const steady = priceOf([3, 3, 3, 3, 3, 3, 3]);
    expect(steady).toEqual({ value: 3, figures: 3, low: 3, most: 3 });
    for (let k = 0; k < 7; k++) {
      const stalled = priceOf([3, 3, 3, 3, 3, 3, 3].map((ms, i) => (i === k ? 900 : ms)));
      expect(stalled).toEqual(steady);
    }
  });

  test('has as many figures as the best quarter of the rounds lets stand', () => {
    const ms = 1.23456;
    const spread = (share: number) => priceOf([ms, ...Array(7).fill(ms * (1 + share))]);
    expect([0, 0.005, 0.05, 0.25, 0.5, 9].map((s) => spread(s).value)).toEqual([
      1.23, 1.24, 1.3, 1.5, 2, 10,
    ]);
    // Three rounds that agree may do so by chance.
    expect(priceOf([ms, ms, ms]).value).toBe(1.2);
    expect(priceOf([]).value).toBeNaN();
  });

  test('stays within what was taken, whoever else works on the machine; seed 41', () => {
    const random = seeded(41);
    for (let k = 0; k < 500; k++) {
      const ms = 10 ** (4 * random() - 2);
      const price = priceOf(rounds(ms, 15, random(), random));
      expect(price.low).toBe(ms);
      expect(Math.abs(price.value - ms)).toBeLessThanOrEqual(0.5 * ms);
      expect(price.most).toBeGreaterThanOrEqual(price.low);
    }
  });

  test('as a multiple: what is shown divided by what is shown; seed 42', () => {
    const random = seeded(42);
    for (let k = 0; k < 500; k++) {
      const [own, base] = [0, 0].map(() =>
        priceOf(rounds(10 ** (3 * random()), 9, random(), random)),
      ) as [ReturnType<typeof priceOf>, ReturnType<typeof priceOf>];
      const times = multipleOf(own, base);
      expect(times.figures).toBe(Math.min(own.figures, base.figures));
      expect(times.value).toBe(rounded(own.value / base.value, times.figures));
      expect(multipleOf(base, base).value).toBe(1);
    }
  });
});

describe('the sentence about prices', () => {
  const quality = {
    rays: 100,
    judged: { right: 100, misses: 0, invents: 0, misnames: 0, undecided: 0 },
    ...{
      wrong: 0,
      listed: 0,
      undecided: 0,
      digits: 15.95,
      leastDigits: 15.95,
      ulps: 0,
      mostUlps: 0,
    },
  };
  const rowsOf = (
    all: Readonly<Record<string, readonly number[]>>,
    mostUlps = 0,
  ): MeasuredRow[] => {
    const base = priceOf(all.textbook ?? []);
    return Object.entries(all).map(([id, times]) => {
      const ns = id === 'textbook' ? base : priceOf(times);
      const own = id === 'textbook' ? { ...quality, mostUlps } : quality;
      const timing = { ns, times: multipleOf(ns, base) };
      return { id, quality: own, roots: timing, classes: timing };
    });
  };
  const even = (ms: number): number[] => Array(8).fill(ms);
  const words = (rows: MeasuredRow[], question: 'roots' | 'classes' = 'roots') =>
    `${headlineOf(rows, (id) => id)} ${detailsOf(rows, question, (id) => id)}`;

  test('says "about" and that the machine was busy where the figures do not stand', () => {
    const shaky = [1.37, 1.37, 1.5, 1.5, 1.5, 4, 4, 4.9];
    const rows = rowsOf({ textbook: even(1), certified: shaky }, 5);
    expect(spreadOf(rows[1]?.roots?.ns ?? priceOf([]))).toBeGreaterThan(BUSY);
    expect(words(rows)).toContain(
      'both roots, faithful to the last digit, cost about 1.5 times the textbook formula ' +
        '(certified).',
    );
    expect(words(rows)).toContain(
      'The machine was busy; one round in four took at least 173 % longer',
    );
    const steady = rowsOf({ textbook: even(1), certified: even(1.37) }, 5);
    expect(words(steady)).toContain('cost 1.37 times the textbook formula');
    expect(words(steady)).not.toMatch(/costs? about|busy/);
  });

  test('says neither 0.6 times nor 1 times, nor compares a method with itself', () => {
    const cheaper = words(rowsOf({ textbook: even(1), certified: even(0.646) }, 5));
    expect(cheaper).toContain('cost less than the textbook formula, 0.646 of its price');
    const same = words(rowsOf({ textbook: even(1), certified: even(2) }));
    expect(same).toContain(
      'nothing right is clearly cheaper, with both roots to the last digit, too.',
    );
    for (const text of [cheaper, same]) expect(text).not.toMatch(/\btimes\b|\(textbook\)/);
  });

  test('names the question that is priced', () => {
    const rows = rowsOf({ textbook: even(1), certified: even(2) }, 5).map((row) =>
      row.id === 'textbook' ? { ...row, quality: { ...row.quality, wrong: 3 } } : row,
    );
    expect(words(rows)).toContain('A verdict that is right for all of these rays costs 2 times');
    expect(words(rows)).toContain('both roots, faithful to the last digit, cost 2 times');
  });
});
