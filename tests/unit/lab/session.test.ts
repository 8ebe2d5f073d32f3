import { describe, expect, test } from 'vitest';
import { answer } from '../../../src/lab/answer.ts';
import { digitCount } from '../../../src/lab/digits.ts';
import type { LabReply } from '../../../src/lab/messages.ts';
import { batchesOf } from '../../../src/lab/plan.ts';
import { multipleOf, priceOf } from '../../../src/lab/price.ts';
import { qualityOf } from '../../../src/lab/quality.ts';
import { grouped, priceText, sentenceOf } from '../../../src/lab/sentence.ts';
import { type Measured, type MeasuredRow, measureSession } from '../../../src/lab/session.ts';
import { DIAL_FAMILIES, difficulties, linesOf, sweepSession } from '../../../src/lab/sweep.ts';
import { accelerate, decelerate } from '../../../src/math/accelerate.ts';
import { FAMILIES } from '../../../src/math/families.ts';
import { intersect } from '../../../src/math/index.ts';
import { METHODS } from '../../../src/math/methods/index.ts';

const PLAN = { rounds: 3, least: 10, steps: 1, warmUp: 1 };
/** Each reading is 10 ms later: every sample is one call. */
const ticking = () => {
  let now = 0;
  return () => {
    now += 10;
    return now;
  };
};
const request = (family: string, difficulty?: number) => ({
  family,
  seed: 7,
  shapes: 3,
  count: 64,
  plan: PLAN,
  difficulty,
});
/** What is told before anything is timed, as the page's worker finds it. */
function accelerated(family: string): Measured[] {
  expect(accelerate()).toBe(true);
  try {
    const { value } = measureSession(request(family), ticking()).next();
    return value ? [value] : [];
  } finally {
    decelerate();
  }
}
const allOf = (family: string): Measured[] => [...measureSession(request(family), ticking())];
const titleOf = (id: string): string => METHODS.find((one) => one.id === id)?.title ?? id;

describe('a session', () => {
  test('tells what is right before it has a time, then times after each round, then that it is complete', () => {
    const all = allOf('typical');
    expect(all[0]?.rows).toHaveLength(METHODS.length);
    expect(all[0]?.rows.every(({ roots, classes }) => !roots && !classes)).toBe(true);
    const timed = all.findIndex(({ rows }) => rows.some(({ roots }) => roots));
    expect(all[timed]?.round).toBe(1);
    const last = all.at(-1);
    expect(last?.complete).toBe(true);
    expect(last?.share).toBe(1);
    expect(last?.rays).toBe(192);
    for (const row of last?.rows ?? []) {
      expect(row.roots?.times).toMatchObject({ value: 1, least: expect.closeTo(1, 1) });
      // Every call lasts one tick of 10 ms, for 192 rays.
      expect(row.classes?.ns.least).toBeCloseTo(1e7 / 192, 6);
      expect(row.classes?.ns.value).toBe(52_000);
    }
    const shares = all.map(({ share }) => share);
    expect([...shares].sort((a, b) => a - b)).toEqual(shares);
  });

  test.each(
    FAMILIES.flatMap(({ id }) => [[id, 'TypeScript'] as const, [id, 'WebAssembly'] as const]),
  )('%s, by %s: certified and exact judge every ray right', (id, how) => {
    const [first] =
      how === 'WebAssembly' ? accelerated(id) : measureSession(request(id), ticking());
    for (const { id: method, quality } of first?.rows ?? []) {
      expect(quality.rays).toBe(192);
      const { judged } = quality;
      expect(judged.right + quality.wrong + quality.undecided).toBe(192);
      if (method !== 'certified' && method !== 'exact') continue;
      expect([quality.wrong, quality.undecided]).toEqual([0, 0]);
      if (!Number.isNaN(quality.mostUlps)) {
        expect(quality.mostUlps).toBeLessThanOrEqual(method === 'exact' ? 0 : 1);
      }
    }
  });

  test('far away the textbook loses hits, and the ray that is offered shows it', () => {
    const [first] = measureSession(request('far-origin', 7.6), ticking());
    const row = first?.rows.find(({ id }) => id === 'textbook');
    expect(row?.quality.judged.misses).toBeGreaterThan(10);
    // More than one ray in ten fails, and fewer than half: nine of ten have no digit, and half
    // would have some.
    const share = (row?.quality.wrong ?? 0) / 192;
    expect([share > 0.1, share < 0.5, row?.quality.digits]).toEqual([true, true, 0]);
    const worst = row?.quality.worst;
    if (!worst) throw new Error('a worst ray was expected');
    expect(intersect(worst.shape, worst.ray, 'textbook').class).not.toBe(
      intersect(worst.shape, worst.ray, 'exact').class,
    );
  });

  test('an unknown family is said to be unknown', () => {
    const replies: LabReply[] = [];
    answer({ type: 'measure', request: request('nowhere') }, ticking(), (reply) =>
      replies.push(reply),
    );
    expect(replies).toEqual([{ type: 'failed', message: "unknown family 'nowhere'" }]);
  });
});

describe('quality', () => {
  test('is the count that the objects give, ray by ray', () => {
    const family = FAMILIES.find(({ id }) => id === 'near-tangent-far');
    if (!family) throw new Error('no such family');
    const batches = batchesOf(family, { seed: 3, shapes: 2, count: 200 });
    for (const method of METHODS) {
      let wrong = 0;
      let undecided = 0;
      for (const { shape, rays } of batches) {
        for (let i = 0; i < rays.count; i++) {
          const ray = {
            origin: [rays.Ex[i] as number, rays.Ey[i] as number, rays.Ez[i] as number],
            direction: [rays.dx[i] as number, rays.dy[i] as number, rays.dz[i] as number],
          } as const;
          const found = method.intersect(shape, ray).class;
          if (found === 'undecided') undecided += 1;
          else if (found !== intersect(shape, ray, 'exact').class) wrong += 1;
        }
      }
      const quality = qualityOf(method, batches);
      expect([method.id, quality.wrong, quality.undecided]).toEqual([method.id, wrong, undecided]);
    }
  });
});

describe('the sentence', () => {
  const base = priceOf([10, 10, 10, 10]);
  const timing = (ratio: number) => {
    const ns = priceOf([10, 10, 10, 10].map((ms) => ms * ratio));
    return { ns, times: multipleOf(ns, base) };
  };
  const [quality] = allOf('typical')[0]?.rows ?? [];
  const row = (
    id: string,
    parts: Partial<MeasuredRow['quality']>,
    roots: number,
    classes: number,
  ): MeasuredRow => ({
    id,
    quality: {
      ...(quality as MeasuredRow).quality,
      rays: 3072,
      wrong: 0,
      undecided: 0,
      mostUlps: 0,
      ...parts,
    },
    roots: timing(roots),
    classes: timing(classes),
  });

  test('says what exact verdicts and faithful roots cost, with the numbers of the table', () => {
    const rows = [
      row('textbook', { wrong: 1234, mostUlps: 1e9 }, 1, 1),
      row('moment', { mostUlps: 5 }, 1.1, 1.3),
      row('interval', { undecided: 1 }, 0.5, 0.5),
      row('certified', { mostUlps: 1 }, 2.004, 1.0561),
      row('exact', {}, 220.4, 180),
    ];
    expect(sentenceOf(rows, 'roots', titleOf)).toBe(
      'On these rays, the textbook formula misjudges 1\u202f234 of 3\u202f072. Faithful roots for all of them cost 2 times as much as the textbook formula’s (certified).',
    );
    expect(sentenceOf(rows, 'classes', titleOf)).toBe(
      'On these rays, the textbook formula misjudges 1\u202f234 of 3\u202f072. Right verdicts alone, without roots, cost 1.06 times as much as the textbook formula’s (certified).',
    );
    expect(priceText(timing(1.0561).times)).toBe('1.06');
    expect(priceText(timing(220.4).times)).toBe('220');
    expect(grouped(1234567)).toBe('1\u202f234\u202f567');
  });

  test('does not call roots faithful where no ray has one', () => {
    const none = { digits: Number.NaN, leastDigits: Number.NaN };
    expect(sentenceOf([row('textbook', none, 1, 1)], 'roots', titleOf)).toBe(
      'On these rays, the textbook formula has every verdict right. It is the cheapest method, too, with right answers for all of them, both roots asked for.',
    );
  });

  test('says nothing before there is a time', () => {
    expect(sentenceOf(allOf('typical')[0]?.rows ?? [], 'roots', titleOf)).toBe('');
  });
});

describe('a sweep', () => {
  test('goes from one end of the dial to the other', () => {
    expect(difficulties({ title: '', range: [0, 12], usual: [0, 1] }, 5)).toEqual([0, 3, 6, 9, 12]);
    expect(DIAL_FAMILIES.length).toBeGreaterThan(8);
  });

  test('far away: textbook ends in lost hits, certified and exact never do', () => {
    const points = [
      ...sweepSession({ family: 'far-origin', seed: 7, shapes: 3, count: 64, points: 13 }),
    ];
    expect(points.map(({ difficulty }) => difficulty)).toEqual([
      0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12,
    ]);
    const lines = new Map(linesOf(points).map((line) => [line.id, line]));
    expect(lines.get('textbook')?.end?.reason).toBe('misses');
    expect(lines.get('textbook')?.end?.difficulty).toBeGreaterThan(6);
    for (const { end, points: kept } of lines.values()) {
      const last = kept.at(-1)?.quality;
      if (end) expect(end.share).toBeGreaterThan(0.1);
      if (last) expect((last.wrong + last.undecided) / last.rays).toBeLessThanOrEqual(0.1);
    }
    expect(lines.get('interval')?.firstFailure?.quality.wrong ?? 0).toBe(0);
    expect(lines.get('textbook32')?.end?.difficulty).toBeLessThan(5);
    for (const id of ['certified', 'exact']) {
      const line = lines.get(id);
      expect(line?.points).toHaveLength(13);
      expect(line?.end).toBeUndefined();
      expect(line?.firstFailure).toBeUndefined();
      for (const { quality: found } of line?.points ?? [])
        expect(digitCount(found.digits)).toBeGreaterThanOrEqual(id === 'exact' ? 16 : 15);
    }
  });

  test('a line ends where one ray in ten has no digit left, and only then; made data', () => {
    const made = (digits: number, misses: number, undecided: number) => ({
      rays: 100,
      judged: { right: 100 - misses - undecided, misses, invents: 0, misnames: 0, undecided },
      wrong: misses,
      undecided,
      digits,
      leastDigits: 0,
      ulps: 0,
      mostUlps: 0,
    });
    const line = (...qualities: ReturnType<typeof made>[]) =>
      linesOf(
        qualities.map((quality, difficulty) => ({ difficulty, rows: [{ id: 'a', quality }] })),
      )[0];
    const ending = line(made(9, 0, 0), made(8, 1, 2), made(0, 4, 16), made(3, 0, 0));
    expect(ending?.points.map(({ difficulty }) => difficulty)).toEqual([0, 1]);
    expect(ending?.firstFailure).toMatchObject({ difficulty: 1, reason: 'undecided', share: 0.03 });
    expect(ending?.end).toMatchObject({ difficulty: 2, reason: 'undecided', share: 0.2 });
    // No ray has a root: nothing to draw, and nothing failed.
    const rootless = line(made(Number.NaN, 0, 0), made(5, 0, 0));
    expect(rootless?.points.map(({ difficulty }) => difficulty)).toEqual([1]);
    expect([rootless?.end, rootless?.firstFailure]).toEqual([undefined, undefined]);
  });
});
