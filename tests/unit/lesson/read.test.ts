import * as fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { stepAt } from '../../../src/lesson/lesson.ts';
import type { Prose } from '../../../src/lesson/prose.ts';
import { isLesson, readLesson } from '../../../src/lesson/read.ts';
import { changesOf, innerState, toStep } from '../../../src/lesson/step-state.ts';
import { withSteps, writeLesson } from '../../../src/lesson/write.ts';
import { collected } from '../../../src/pages/lesson/own-lesson.ts';
import { GALLERY } from '../../../src/state/gallery/index.ts';
import type { Settings } from '../../../src/state/state.ts';
import { update } from '../../../src/state/update.ts';
import { decode, encode } from '../../../src/state/url.ts';
import { read } from '../docs/documents.ts';

const SEED = 271828;
const LINK = '#/explore?shape=cylinder&C=0,1,0&r=1.25&E=3,1,1&d=-0.8,-0.2,-0.6';
const textOf = (body: string, head = `link: ${LINK}`): string =>
  `---\ntitle: A lesson\n---\n\n## a step\n\n${head}\n\n${body}\n`;
const stepOf = (body: string, head?: string) => readLesson(textOf(body, head), 'x');

describe('a lesson is read', () => {
  test('the one of docs/USING.md, without complaint', () => {
    const [, block = ''] = read('docs/USING.md').match(/```markdown\n([\s\S]*?)```/) ?? [];
    const { lesson, problems } = readLesson(block, 'own');
    expect(problems).toEqual([]);
    const [, step] = lesson.steps;
    expect(step?.free).toBe('r');
    expect(step?.guess).toEqual({ type: 'free', truth: 1 });
    for (const part of [step?.text, step?.question, step?.answer, step?.notes]) {
      expect(part?.length).toBeGreaterThan(0);
    }
    expect(step?.text.slice(0, 3).map(({ type }) => type)).toEqual([
      'paragraph',
      'slider',
      'paragraph',
    ]);
    expect(step?.answer.map(({ type }) => type)).toEqual(['paragraph', 'display']);
  });

  test('HTML in it is text', () => {
    const { lesson } = stepOf('So <b onclick="x">bold</b> <script>alert(1)</script> {t1}.');
    const [block] = lesson.steps[0]?.text ?? [];
    const parts = block?.type === 'paragraph' ? block.inside : [];
    expect(parts.map(({ type }) => type).filter((t) => t !== 'text')).toEqual(['live']);
    const words = parts.map((part) => (part.type === 'text' ? part.text : '')).join('');
    expect(words).toContain('<script>alert(1)</script>');
  });

  test.each([
    ['a link of nowhere', 'link: http://x', /is no link of Graze/],
    ['no link', 'free: r', /no link/],
    ['what is not there to be free', `link: ${LINK}\nfree: k`, /'k' cannot be free/],
    ['a guess of something else', `link: ${LINK}\nfree: r\nguess: c = 1`, /cannot be guessed/],
    ['a word that means nothing', `link: ${LINK}\ncolour: red`, /'colour' means nothing/],
    ['a lesson in a lesson', 'link: #/lesson/ray', /cannot be a lesson/],
  ])('%s is said', (_, head, words) => {
    expect(stepOf('Text.', head).problems.join()).toMatch(words);
  });

  test.each([
    ['an example that is not there', 'example: klein-bottle', /no example 'klein-bottle'/],
    ['a link beside an example', `example: cone-hit\nlink: ${LINK}`, /the example counts/],
    ['D of a plane', 'link: #/explore?shape=plane\nguess: sign', /'sign' cannot be predicted/],
    ['a choice on another page', 'link: #/check\nguess: points', /'points' cannot be predicted/],
  ])('%s is said', (_, head, words) => {
    expect(stepOf('Text.', head).problems.join()).toMatch(words);
  });

  test('every example is a step with its question and answer, word for word', () => {
    const told = (prose: Prose): string =>
      prose
        .flatMap((block) => (block.type === 'paragraph' ? block.inside : []))
        .map((part) => (part.type === 'text' ? part.text : `(${part.type})`))
        .join('');
    for (const { id, link, asks, answer } of GALLERY) {
      const { lesson, problems } = stepOf('Text.', `example: ${id}`);
      const [step] = lesson.steps;
      expect(problems, id).toEqual([]);
      expect(step, id).toMatchObject({ link, guess: { type: 'open' }, hide: false });
      expect([told(step?.question ?? []), told(step?.answer ?? [])]).toEqual([asks, answer]);
    }
  });

  test('a question of its own, and something to predict, come before those of the example', () => {
    const own = stepOf('### Question\n\nMine?', 'example: cone-tangent\nguess: points');
    const [step] = own.lesson.steps;
    expect(own.problems).toEqual([]);
    expect(step?.guess).toEqual({ type: 'prediction', ask: 'points' });
    expect(JSON.stringify(step?.question)).toContain('Mine?');
    expect(step && innerState(step, {}).revealed).toBe(0);
    expect(step && innerState(step, { guess: '2' }).revealed).toBeNull();
  });

  test('an open question hides nothing', () => {
    const [step] = stepOf('### Question\n\nWhy?', `link: ${LINK}\nguess: open`).lesson.steps;
    expect(step?.guess).toEqual({ type: 'open' });
    expect(step && innerState(step, {}).revealed).toBeNull();
  });

  test('a script is no link', () => {
    const { lesson } = stepOf('[a](javascript:alert(1)) [b](https://example.org) [c](#/explore)');
    const [block] = lesson.steps[0]?.text ?? [];
    const parts = block?.type === 'paragraph' ? block.inside : [];
    const hrefs = parts.flatMap((part) => (part.type === 'link' ? [part.href] : []));
    expect(hrefs).toEqual(['https://example.org', '#/explore']);
  });

  test(`any text is read, and written again means the same (seed ${SEED})`, () => {
    fc.assert(
      fc.property(fc.string({ unit: 'binary', maxLength: 300 }), (body) => {
        const { lesson } = stepOf(body);
        const again = readLesson(writeLesson(lesson), 'x').lesson;
        expect(again.steps.map(({ source }) => source)).toEqual(
          lesson.steps.map(({ source }) => source),
        );
      }),
      { seed: SEED, numRuns: 100 },
    );
  });

  test('only what begins with front matter is one', () => {
    expect(isLesson(textOf('x'))).toBe(true);
    expect(isLesson('{"graze":1}')).toBe(false);
    expect(isLesson('t,x,y\n1,2,3')).toBe(false);
  });
});

describe('what a step shows', () => {
  const [step] = stepOf('Text.', `link: ${LINK}\nfree: r`).lesson.steps;
  if (!step) throw new Error('no step');

  test(`a moved number comes back from the settings, to the bit (seed ${SEED})`, () => {
    const finite = fc.double({ min: 0, max: 1e300, noNaN: true });
    fc.assert(
      fc.property(finite, finite, (r, t) => {
        const moved = [
          { type: 'param', key: 'radius', value: r } as const,
          { type: 'bead', t } as const,
        ].reduce(update, innerState(step, {}));
        const changes = Object.entries(changesOf(step, moved, {}));
        const settings = Object.fromEntries(changes.filter(([, x]) => x !== null)) as Settings;
        expect(encode(innerState(step, settings))).toBe(encode(moved));
      }),
      { seed: SEED, numRuns: 200 },
    );
  });

  test('another step leaves what was moved and answered', () => {
    const now: Settings = { id: 'x', file: 'y', step: '2', r: '1', guess: '3' };
    expect(toStep(3)(now)).toEqual({ step: '3', r: null, guess: null });
  });

  test('a step that there is not is the nearest one', () => {
    const lesson = readLesson(
      withSteps(readLesson(textOf('x'), 'x').lesson, ['## a', '## b']),
      'x',
    );
    const given = [undefined, '0', '2', '7', 'x', 'Infinity'];
    expect(given.map((text) => stepAt(lesson.lesson, text))).toEqual([1, 1, 2, 2, 1, 1]);
  });
});

test('a lesson of ten minutes: three states are collected, and open as they were', () => {
  const links = [
    LINK,
    '#/accuracy?shape=cylinder&E=1e8,0,0&d=-1,0,0&method=textbook',
    '#/check?method=certified&seed=41&question=3',
  ];
  const text = links.reduce<string | null>((now, link) => collected(now, link).text, null) ?? '';
  const { lesson, problems } = readLesson(text, 'own');
  expect(problems).toEqual([]);
  expect(lesson.steps.map(({ link }) => link)).toEqual(links);
  const shown = lesson.steps.map((step) => encode(innerState(step, {})));
  expect(shown).toEqual(links.map((link) => encode(decode(link))));
});
