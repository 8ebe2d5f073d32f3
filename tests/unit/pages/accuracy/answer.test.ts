import { describe, expect, test } from 'vitest';
import type { LabReply } from '../../../../src/lab/messages.ts';
import { type Measured, type MeasureRequest, measureSession } from '../../../../src/lab/session.ts';
import { METHODS } from '../../../../src/math/index.ts';
import { answerWords } from '../../../../src/pages/accuracy/answer-words.ts';
import type { LabWorker } from '../../../../src/pages/accuracy/lab-jobs.ts';
import { createMeasuring } from '../../../../src/pages/accuracy/measuring.ts';
import { columnOf } from '../../../../src/pages/accuracy/reference.ts';
import reference from '../../../../src/pages/accuracy/reference-prices.json';
import { measureRequest } from '../../../../src/pages/accuracy/requests.ts';
import { isEmulated } from '../../../../src/state/accuracy/column.ts';
import { INITIAL_ACCURACY } from '../../../../src/state/accuracy/settings.ts';
import { isFloat32, METHOD_IDS } from '../../math/shorthand.ts';

const ticking = () => {
  let now = 0;
  return () => {
    now += 10;
    return now;
  };
};
const asked: MeasureRequest = {
  ...{ family: 'far-origin', seed: 7, shapes: 2, count: 32, timed: 32, order: 'random' },
  budget: { least: 32, most: 1e9 },
  plan: { rounds: 2, least: 10, steps: 1, warmUp: 0 },
};
const all = [...measureSession(asked, ticking())];
const [counted, last] = [all[0], all.at(-1)] as readonly [Measured, Measured];
const inTypeScript = { ...INITIAL_ACCURACY, target: 'typescript' } as const;
/** As if every method had a kernel of its own in SIMD. */
const withSimd: Measured = {
  ...last,
  simd: true,
  noSimd: '',
  columns: { ...last.columns, simd: last.columns.typescript },
};

describe('a column', () => {
  test('holds the reference until this device has a price, and then none of it', () => {
    const before = columnOf(inTypeScript, counted, reference);
    expect(before.isFaint).toBe(true);
    for (const { id, roots, classes } of before.rows) {
      const { both, classes: alone } = reference;
      // A method of which only the roots were priced has no other figure.
      type Known = Readonly<Record<string, { readonly low: number; readonly high: number }>>;
      const [pair, verdict]: Known[] = [both.typescript.random, alone.typescript.random];
      expect(roots?.times.low).toBe(pair?.[id]?.low);
      expect(classes?.times.most).toBe(verdict?.[id]?.high);
    }
    const after = columnOf(inTypeScript, last, reference);
    expect(after).toMatchObject({ isFaint: false, rows: last.columns.typescript });
  });

  test('is the one that is asked for, or says why not', () => {
    expect(columnOf(INITIAL_ACCURACY, null, reference)).toMatchObject({ target: 'simd', why: '' });
    const instead = columnOf(INITIAL_ACCURACY, counted, reference);
    expect(instead).toMatchObject({ target: 'typescript', why: counted.noSimd });
    expect(counted.noSimd).not.toBe('');
    const reason = 'The WebAssembly of this engine has no SIMD.';
    const [refused] = measureSession(asked, ticking(), reason);
    expect(columnOf(INITIAL_ACCURACY, refused as Measured, reference).why).toBe(reason);
    expect(columnOf(inTypeScript, counted, reference).why).toBe('');
    expect(columnOf(INITIAL_ACCURACY, withSimd, reference)).toMatchObject({
      target: 'simd',
      why: '',
    });
  });
});

describe('the words', () => {
  const words = (column: ReturnType<typeof columnOf>) =>
    answerWords(column, 'roots', INITIAL_ACCURACY);

  test('say whose prices they are, and of the reference nothing about this machine', () => {
    const before = words(columnOf(inTypeScript, counted, reference));
    expect(before.headline).toMatch(
      /^By the reference prices of typical rays in random order, .+ “far away” rays \(E is 10³/,
    );
    expect(before.details).not.toMatch(/busy|cheapest/);
    const after = words(columnOf(inTypeScript, last, reference));
    expect(after.headline).toMatch(
      /^In random order, (a verdict|the textbook).+ these “far away” rays/,
    );
    const turned = { ...INITIAL_ACCURACY, dial: 4 };
    const { headline } = answerWords(columnOf(inTypeScript, last, reference), 'roots', turned);
    expect(headline).toContain('“far away” rays (E is 10⁴ radii away)');
    const sorted = { family: 'typical', order: 'sorted', dial: null } as const;
    const ofSorted = (found: Measured) =>
      answerWords(columnOf({ ...inTypeScript, ...sorted }, found, reference), 'roots', sorted);
    expect(ofSorted(counted).headline).toMatch(
      /^By the reference prices of typical rays with hits first, .+ these “typical” rays/,
    );
    expect(ofSorted(last).headline).toMatch(/^With hits first, .+ these “typical” rays/);
  });

  test('name what is emulated in TypeScript, and what has no price in SIMD', () => {
    const emulated = METHODS.filter(({ id }) => isEmulated(id, 'typescript'));
    expect(emulated.map(({ id }) => id)).toEqual(METHOD_IDS.filter(isFloat32));
    const titles = emulated.map(({ title }) => title).join(' and ');
    expect(words(columnOf(inTypeScript, last, reference)).details).toContain(
      `Emulated here, so without a price of its own: ${titles}.`,
    );
    const rows = last.columns.typescript.map(({ roots, classes, ...row }) =>
      row.id === 'exact' ? row : { ...row, ...(roots && { roots }), ...(classes && { classes }) },
    );
    const noExact = { ...withSimd, columns: { ...last.columns, simd: rows } };
    const { details } = words(columnOf(INITIAL_ACCURACY, noExact, reference));
    expect(details).toContain('Without a price in SIMD: exact.');
    expect(details).not.toContain('Emulated');
  });

  test('promise nothing before verdicts are counted', () => {
    expect(words(columnOf(INITIAL_ACCURACY, null, reference))).toEqual({
      headline: '',
      details: '',
    });
  });
});

describe('measuring', () => {
  const arrived = (): Promise<void> => new Promise((done) => setTimeout(done));

  function bench() {
    const workers: { asked: unknown; reply(data: LabReply): void; ended: boolean }[] = [];
    const waiting: (() => void)[] = [];
    const spawn = async (): Promise<LabWorker> => {
      const worker = {
        asked: null as unknown,
        ended: false,
        onmessage: null as LabWorker['onmessage'],
        onerror: null,
        postMessage(asked: unknown) {
          worker.asked = asked;
        },
        terminate() {
          worker.ended = true;
        },
        reply(data: LabReply) {
          worker.onmessage?.({ data } as MessageEvent<LabReply>);
        },
      };
      workers.push(worker);
      return worker;
    };
    const measuring = createMeasuring(
      spawn,
      () => {},
      (act) => waiting.push(act),
    );
    const rest = async (): Promise<void> => {
      for (const act of waiting.splice(0)) act();
      await arrived();
    };
    return { measuring, workers, rest };
  }

  test('starts by itself when it may, once for the same rays, and briefly', async () => {
    const { measuring, workers, rest } = bench();
    measuring.update(INITIAL_ACCURACY, false);
    await rest();
    expect(workers).toHaveLength(0);
    measuring.update(INITIAL_ACCURACY, true);
    measuring.update({ ...INITIAL_ACCURACY, worth: 'wrong' }, true);
    await rest();
    measuring.update(INITIAL_ACCURACY, true);
    await rest();
    expect(workers.map(({ asked }) => asked)).toEqual([
      { type: 'measure', request: measureRequest(INITIAL_ACCURACY, false) },
    ]);
    measuring.cancel();
    measuring.update(INITIAL_ACCURACY, true);
    await rest();
    expect(workers).toHaveLength(1);
  });

  test('other rays or another order end it, forget what was found, and are measured', async () => {
    const { measuring, workers, rest } = bench();
    measuring.update(INITIAL_ACCURACY, true);
    await rest();
    workers[0]?.reply({ type: 'measured', measured: last });
    expect(measuring.update(INITIAL_ACCURACY, true).found).toBe(last);
    const turned = { ...INITIAL_ACCURACY, dial: 4 };
    const { headline } = answerWords(columnOf(inTypeScript, last, reference), 'roots', turned);
    expect(headline).toContain('“far away” rays (E is 10⁴ radii away)');
    const sorted = { ...INITIAL_ACCURACY, order: 'sorted' } as const;
    expect(measuring.update(sorted, true).found).toBe(null);
    expect(workers[0]?.ended).toBe(true);
    await rest();
    expect(workers[1]?.asked).toEqual({ type: 'measure', request: measureRequest(sorted, false) });
  });

  test('longer keeps what was found until there is more', async () => {
    const { measuring, workers, rest } = bench();
    measuring.update(INITIAL_ACCURACY, true);
    await rest();
    workers[0]?.reply({ type: 'measured', measured: last });
    measuring.update(INITIAL_ACCURACY, true);
    measuring.longer();
    measuring.update(INITIAL_ACCURACY, true);
    await rest();
    workers[1]?.reply({ type: 'measured', measured: counted });
    expect(measuring.update(INITIAL_ACCURACY, true)).toMatchObject({ found: last, now: counted });
    const more = { ...last, round: 3 };
    workers[1]?.reply({ type: 'measured', measured: more });
    expect(measuring.update(INITIAL_ACCURACY, true).found).toBe(more);
  });

  test('rests with the page', async () => {
    const { measuring, workers, rest } = bench();
    measuring.update(INITIAL_ACCURACY, true);
    measuring.rest();
    await rest();
    expect(workers).toHaveLength(0);
  });
});
