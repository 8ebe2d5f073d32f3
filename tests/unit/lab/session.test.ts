import { describe, expect, test } from 'vitest';
import { answer } from '../../../src/lab/answer.ts';
import { digitCount } from '../../../src/lab/digits.ts';
import type { LabReply } from '../../../src/lab/messages.ts';
import { type Batch, batchesOf, rayAt } from '../../../src/lab/plan.ts';
import { multipleOf, priceOf } from '../../../src/lab/price.ts';
import { qualityOf } from '../../../src/lab/quality.ts';
import { detailsOf, grouped, headlineOf, priceText } from '../../../src/lab/sentence.ts';
import {
  familyOf,
  type Measured,
  type MeasuredRow,
  measureSession,
} from '../../../src/lab/session.ts';
import { DIAL_FAMILIES, difficulties, linesOf, sweepSession } from '../../../src/lab/sweep.ts';
import { timedBatches, timedTasks } from '../../../src/lab/timed.ts';
import { accelerate, decelerate } from '../../../src/math/accelerate.ts';
import { type Rays, targetOf } from '../../../src/math/batch.ts';
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
  timed: 128,
  order: 'random' as const,
  budget: { least: 64, most: 1e9 },
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
  test('tells what is right first, then times after each round, then that it is complete', () => {
    const all = allOf('typical');
    expect(all[0]?.columns.typescript).toHaveLength(METHODS.length);
    expect(all[0]?.columns.typescript.every(({ roots, classes }) => !roots && !classes)).toBe(true);
    const timed = all.findIndex(({ columns }) => columns.typescript.some(({ roots }) => roots));
    expect(all[timed]?.round).toBe(1);
    const last = all.at(-1);
    expect(last?.complete).toBe(true);
    expect(last?.share).toBe(1);
    expect(last?.rays).toBe(192);
    for (const row of last?.columns.typescript ?? []) {
      expect(row.roots?.times).toMatchObject({ value: 1, low: expect.closeTo(1, 1) });
      // Every call lasts one tick of 10 ms, for 384 rays.
      expect(row.classes?.ns.low).toBeCloseTo(1e7 / 384, 6);
      expect(row.classes?.ns.value).toBe(26_000);
    }
    const shares = all.map(({ share }) => share);
    expect([...shares].sort((a, b) => a - b)).toEqual(shares);
  });

  test.each(
    FAMILIES().flatMap(({ id }) => [[id, 'TypeScript'] as const, [id, 'WebAssembly'] as const]),
  )('%s, by %s: certified and exact judge every ray right', (id, how) => {
    const [first] =
      how === 'WebAssembly' ? accelerated(id) : measureSession(request(id), ticking());
    for (const { id: method, quality } of first?.columns.typescript ?? []) {
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
    const row = first?.columns.typescript.find(({ id }) => id === 'textbook');
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
    const family = FAMILIES().find(({ id }) => id === 'near-tangent-far');
    if (!family) throw new Error('no such family');
    const batches = batchesOf(family, { seed: 3, shapes: 2, count: 200 });
    for (const method of METHODS) {
      let wrong = 0;
      let undecided = 0;
      let listed = 0;
      for (const { shape, rays } of batches) {
        for (let i = 0; i < rays.count; i++) {
          const ray = {
            origin: [rays.Ex[i] as number, rays.Ey[i] as number, rays.Ez[i] as number],
            direction: [rays.dx[i] as number, rays.dy[i] as number, rays.dz[i] as number],
          } as const;
          const found = method.intersect(shape, ray).class;
          if (found !== 'two' && found !== 'none') listed += 1;
          if (found === 'undecided') undecided += 1;
          else if (found !== intersect(shape, ray, 'exact').class) wrong += 1;
        }
      }
      const quality = qualityOf(method, batches);
      const { id } = method;
      expect({ id, ...quality }).toMatchObject({ id, wrong, undecided, listed });
    }
  });
});

describe('the sentence', () => {
  const base = priceOf([10, 10, 10, 10]);
  const timing = (ratio: number) => {
    const ns = priceOf([10, 10, 10, 10].map((ms) => ms * ratio));
    return { ns, times: multipleOf(ns, base) };
  };
  const [quality] = allOf('typical')[0]?.columns.typescript ?? [];
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
      listed: 0,
      mostUlps: 0,
      ...parts,
    },
    roots: timing(roots),
    classes: timing(classes),
  });

  const textbook = row('textbook', { wrong: 1234, mostUlps: 1e9 }, 1, 1);
  const exact = row('exact', {}, 220.4, 180);

  test('says what right verdicts and faithful roots cost, with the numbers of the table', () => {
    const rows = [
      textbook,
      row('moment', { mostUlps: 5, undecided: 2 }, 1.1, 1.3),
      row('certified', { mostUlps: 1 }, 2.004, 1.0561),
      exact,
    ];
    expect(headlineOf(rows, titleOf)).toBe(
      'A verdict that is right for all of these rays costs 1.06 times the textbook ' +
        'formula (certified); both roots, faithful to the last digit, cost 2 times the ' +
        'textbook formula.',
    );
    expect(headlineOf(rows, titleOf, 'Elsewhere')).toMatch(/^Elsewhere, a verdict that is right/);
    expect(detailsOf(rows, 'roots', titleOf)).toBe(
      'On these 3\u202f072 rays the textbook formula misjudges 1\u202f234.',
    );
    expect(priceText(timing(1.0561).times)).toBe('1.06');
    expect(priceText(timing(220.4).times)).toBe('220');
    expect(grouped(1234567)).toBe('1\u202f234\u202f567');
  });

  test('says that right answers are cheaper, or as dear, where they are', () => {
    const cheaper = [textbook, row('certified', { mostUlps: 1 }, 1, 0.8)];
    expect(headlineOf(cheaper, titleOf)).toBe(
      'A verdict that is right for all of these rays costs less than the textbook ' +
        'formula, 0.8 of its price (certified); both roots, faithful to the last digit, ' +
        'cost as much as the textbook formula.',
    );
    expect(detailsOf(cheaper, 'classes', titleOf)).toContain(
      'The cheapest for a verdict alone is certified, 0.8 of textbook’s price: it has ' +
        'every verdict right.',
    );
  });

  test('does not call cheaper what spreads to the textbook’s price', () => {
    const right = row('textbook', { mostUlps: 1 }, 1, 1);
    const ns = priceOf([8, 8, 11, 12]);
    const unsure = { ns, times: multipleOf(ns, base) };
    const rows = [right, { ...row('certified', {}, 1, 1), roots: unsure, classes: unsure }];
    expect(headlineOf(rows, titleOf)).toMatch(/^The textbook formula is right .* clearly cheaper/);
    expect(detailsOf(rows, 'roots', titleOf)).not.toContain('cheapest');
  });

  test('names two methods where one has the verdict and another the roots', () => {
    const rows = [textbook, row('moment', { mostUlps: 5 }, 1.1, 1.3), exact];
    expect(headlineOf(rows, titleOf)).toBe(
      'A verdict that is right for all of these rays costs 1.3 times the textbook ' +
        'formula (moment); both roots, faithful to the last digit, cost 220 times the ' +
        'textbook formula (exact).',
    );
  });

  test('what a dearer textbook lists ray by ray is told', () => {
    const lists = row('textbook', { wrong: 377, listed: 380 }, 1, 1);
    const rows = [lists, row('moment', { listed: 3 }, 1.1, 0.5)];
    expect(detailsOf(rows, 'classes', titleOf)).toMatch(
      / the textbook formula lists 380, moment 3\.$/,
    );
    const few = [row('textbook', { wrong: 377, listed: 30 }, 1, 1), row('moment', {}, 1.1, 0.5)];
    expect(detailsOf(few, 'classes', titleOf)).not.toContain('lists');
  });

  test('the cheapest is told with what it gets wrong', () => {
    const rows = [textbook, row('textbook32', { wrong: 2000, undecided: 3 }, 0.4, 0.5), exact];
    expect(detailsOf(rows, 'roots', titleOf)).toContain(
      'The cheapest for both roots is textbook, float32, 0.4 of textbook’s price: it ' +
        'misjudges 2\u202f000 and cannot tell for 3.',
    );
  });

  test('says so where the textbook is right, or nothing is', () => {
    const right = row('textbook', { mostUlps: 9 }, 1, 1);
    expect(headlineOf([right, exact], titleOf)).toMatch(
      /^The textbook formula is right about all of .* nothing right is clearly cheaper; both roots/,
    );
    expect(headlineOf([row('textbook', { mostUlps: 1 }, 1, 1), exact], titleOf)).toBe(
      'The textbook formula is right about all of these rays, and nothing right is ' +
        'clearly cheaper, with both roots to the last digit, too.',
    );
    expect(headlineOf([right], titleOf)).toMatch(
      /; no method gives both roots to the last digit\.$/,
    );
    expect(headlineOf([textbook], titleOf)).toBe(
      'No method that is measured here is right about all of these rays.',
    );
  });

  test('does not call roots faithful where no ray has one', () => {
    const none = { digits: Number.NaN, leastDigits: Number.NaN };
    expect(headlineOf([row('textbook', none, 1, 1)], titleOf)).toBe(
      'The textbook formula is right about all of these rays, and nothing right is ' +
        'clearly cheaper.',
    );
  });

  test('figures that the spread does not let stand are said to be about', () => {
    const unsteady = (ratio: number) => {
      const ns = priceOf([9.2, 10, 10, 10].map((ms) => ms * ratio));
      return { ns, times: multipleOf(ns, base) };
    };
    const certified = { ...row('certified', {}, 1, 1), roots: unsteady(2), classes: unsteady(1.5) };
    expect(headlineOf([textbook, certified], titleOf)).toContain('costs about 1.5 times');
  });

  test('has no price before there is a time', () => {
    const untimed = allOf('typical')[0]?.columns.typescript ?? [];
    expect(headlineOf(untimed, titleOf)).toBe('');
    expect(detailsOf(untimed, 'roots', titleOf)).toMatch(/^On these 192 rays the textbook formula/);
    expect(detailsOf([], 'roots', titleOf)).toBe('');
  });
});

describe('the rays that are timed', () => {
  const family = familyOf('mix');
  const sample = { seed: 5, shapes: 3, count: 40 };
  const numbers = ({ rays }: { readonly rays: Rays }, from: number, to: number) =>
    [rays.Ex, rays.Ey, rays.Ez, rays.dx, rays.dy, rays.dz].map((all) => [...all.slice(from, to)]);

  test('begin with those whose answers are compared, on the same shapes', () => {
    const compared = batchesOf(family, sample);
    const timed = timedBatches(family, sample, 100, 'random');
    expect(timed.map(({ shape }) => shape)).toEqual(compared.map(({ shape }) => shape));
    timed.forEach((batch, k) => {
      expect(batch.rays.count).toBe(100);
      expect(numbers(batch, 0, 40)).toEqual(numbers(compared[k] as Batch, 0, 40));
    });
  });

  test('sorted, are the same rays with those that meet the shape first', () => {
    const [random, sorted] = (['random', 'sorted'] as const).map((order) =>
      timedBatches(family, sample, 100, order),
    );
    sorted?.forEach((batch, k) => {
      const before = [...(random?.[k]?.rays.Ex ?? [])].sort((a, b) => a - b);
      expect([...batch.rays.Ex].sort((a, b) => a - b)).toEqual(before);
      const meets = Array.from(
        { length: 100 },
        (_, i) => intersect(batch.shape, rayAt(batch, i), 'exact').class !== 'none',
      );
      expect(meets.indexOf(false) < 0 || meets.lastIndexOf(true) < meets.indexOf(false)).toBe(true);
    });
  });

  test('are fewer for a dear method, and no fewer than the least', () => {
    const timed = timedBatches(family, sample, 100, 'random');
    const all = timedTasks(METHODS, timed, ['typescript'], ticking(), { least: 40, most: 1e9 });
    expect(new Set(all.map(({ rays }) => rays))).toEqual(new Set([300]));
    const few = timedTasks(METHODS, timed, ['typescript'], ticking(), { least: 40, most: 1 });
    expect(new Set(few.map(({ rays }) => rays))).toEqual(new Set([120]));
  });

  test('no kernel of TypeScript is timed as SIMD', () => {
    const timed = timedBatches(family, sample, 50, 'random');
    for (const { method, target } of timedTasks(METHODS, timed, ['simd'], ticking(), {
      least: 40,
      most: 1e9,
    })) {
      const found = METHODS.find(({ id }) => id === method) as (typeof METHODS)[number];
      for (const { shape } of timed) expect(targetOf(found, shape, 'simd')).toBe(target);
    }
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
      listed: 0,
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
