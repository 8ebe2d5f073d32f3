import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { classCsv, classReport, type HandIn, marking } from '../../../src/check/class.ts';
import { type Asked, started } from '../../../src/check/progress.ts';
import { plan, question, studentSeed } from '../../../src/check/session.ts';
import { codesIn, handInCode, handInOf, readHandIn } from '../../../src/state/hand-in.ts';
import { shortest } from '../../../src/text/format.ts';
import { many } from '../many.ts';

const SET = 'roots*2,normal,discriminant;shapes=cone,sphere;hints=off';

const asked = fc.record({
  texts: fc.dictionary(
    fc.constantFrom('t1', 't2', 'case', 'N'),
    fc
      .string({ minLength: 1, maxLength: 40 })
      .filter((text) => text === text.trim() && text !== ''),
  ),
  tries: fc.nat(20),
  solvedAt: fc.option(fc.integer({ min: 1, max: 20 })),
  hints: fc.nat(3),
  solutionShown: fc.boolean(),
  causes: fc.subarray(['b2-ac', 'over-a', 'lost-minus']),
}) as fc.Arbitrary<Asked>;

const handIn = fc.record({
  set: fc.constant(SET),
  seed: fc.integer({ min: -999_999_999, max: 999_999_999 }),
  who: fc.string({ maxLength: 40, unit: 'grapheme' }).map((who) => who.trim()),
  asked: fc.array(asked, { minLength: 4, maxLength: 4 }),
}) as fc.Arbitrary<HandIn>;

describe('a hand-in code', () => {
  test('gives back what was put in', () => {
    fc.assert(
      fc.property(handIn, (given) => {
        const code = handInCode(given);
        expect(code).toMatch(/^graze1\.[\w-]+\.[\da-z]{7}$/);
        expect(readHandIn(code)).toEqual(given);
      }),
      { numRuns: many(400), seed: 19 },
    );
  });

  test('is found in a mail, broken into lines and quoted', () => {
    fc.assert(
      fc.property(handIn, fc.integer({ min: 20, max: 76 }), (given, width) => {
        const code = handInCode(given);
        const lines = code.match(new RegExp(`.{1,${width}}`, 'g')) ?? [];
        for (const between of ['\n', '\r\n> ', '=\r\n']) {
          const mail = `Dear all,\n\nmine is ${lines.join(between)}\n\nBest, Bo`;
          expect(codesIn(`${mail}\n${code} and\t${code}`)).toEqual([code, code, code]);
        }
      }),
      { numRuns: many(60), seed: 19 },
    );
  });

  test('that was changed in any place is refused', () => {
    const code = handInCode({ set: SET, seed: 41, who: 'Ada', asked: [] });
    for (let i = 7; i < code.length; i++) {
      if (code[i] === '.') continue;
      const other = code[i] === 'a' ? 'b' : 'a';
      expect(() => readHandIn(code.slice(0, i) + other + code.slice(i + 1))).toThrow(
        'check value does not fit',
      );
    }
    expect(() => readHandIn('graze2.x.y')).toThrow('no hand-in code');
  });

  test('of strangers never throws anything else', () => {
    fc.assert(
      fc.property(fc.string({ maxLength: 200 }), (text) => {
        for (const code of codesIn(`graze1.${text}.abcdefg`)) {
          expect(() => readHandIn(code)).toThrow(/check value|no hand-in/);
        }
      }),
      { numRuns: many(400), seed: 19 },
    );
  });
});

const texts = (seed: number, index: number): Record<string, string> => {
  const { fields, truth } = question(seed, index, SET);
  return Object.fromEntries(
    fields.map(({ id }) => {
      const answer = truth[id];
      const text =
        typeof answer === 'number'
          ? shortest(answer)
          : typeof answer === 'object'
            ? answer.map(shortest).join('; ')
            : (answer ?? '-');
      return [id, text];
    }),
  );
};

const rightFor = (who: string): HandIn => {
  const own = studentSeed(41, who);
  const progress = started(own, SET);
  const each = plan(own, SET).map((_, i) => [
    i,
    {
      ...{ texts: texts(own, i), tries: 1, solvedAt: 1, hints: 0, solutionShown: false },
      causes: [],
    },
  ]);
  return handInOf({ ...progress, asked: Object.fromEntries(each) }, 41, who);
};

function mark(given: HandIn) {
  const steps = marking(given);
  for (;;) {
    const step = steps.next();
    if (step.done) return step.value;
  }
}

describe('marking', () => {
  test('answers are marked for the numbers of that name, whatever the code says of them', () => {
    expect(mark(rightFor('Ada')).right).toBe(4);
    const stolen = { ...rightFor('Ada'), who: 'Bo' };
    expect(mark(stolen).right).toBeLessThan(2);
    const [first, ...others] = rightFor('Ada').asked;
    if (!first) throw new RangeError('no question');
    const read = { ...first, solvedAt: null, solutionShown: true };
    expect(mark({ ...rightFor('Ada'), asked: [read, ...others] }).right).toBe(3);
  });

  test('known mistakes are named and counted once a student', () => {
    const who = 'Cy';
    const own = studentSeed(41, who);
    const at = plan(own, SET).findIndex(({ exercise }) => exercise === 'roots');
    const [suspect] = question(own, at, SET).suspects;
    const wrong = Object.fromEntries(
      Object.entries(suspect?.answers ?? {}).map(([id, x]) => [id, shortest(x as number)]),
    );
    const all = rightFor(who).asked.map((one, i) => (i === at ? { ...one, texts: wrong } : one));
    const report = classReport([mark({ ...rightFor(who), asked: all }), mark(rightFor('Ada'))]);
    expect(report.misconceptions).toEqual([{ name: suspect?.misconception.says, count: 1, of: 2 }]);
    expect(report.topics[0]).toMatchObject({ name: 'both roots', count: 3, of: 4 });
    expect(report.students.map(({ who: name, right }) => [name, right])).toEqual([
      ['Ada', 4],
      ['Cy', 3],
    ]);
  });

  test('what is unusual is noted: no name, twice, another set, another seed', () => {
    const twice = [mark(rightFor('Ada')), mark(rightFor('Ada')), mark(rightFor(''))];
    const { students } = classReport(twice, { set: 'roots', seed: 7 });
    const notes = students.map((one) => one.notes.join('; '));
    expect(notes[0]).toBe(`no name; another set: ${SET}; another seed: 41`);
    expect(notes[1]).toContain('handed in 2 times');
  });
});

describe('the table of the class as CSV', () => {
  test('has a line for each student and a column for each question', () => {
    const lines = classCsv(classReport([mark(rightFor('Ada')), mark(rightFor('"Bo", =1+1'))]))
      .trim()
      .split('\n');
    expect(lines[0]).toBe(
      'who,set,seed,right,asked,tries,hints,solutions read,misconceptions,notes,q1,q2,q3,q4',
    );
    expect(lines[1]).toContain('"""Bo"", =1+1"');
    expect(lines[2]).toBe(`Ada,"${SET}",41,4,4,4,0,0,,,1,1,1,1`);
  });
});
