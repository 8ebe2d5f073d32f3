import { describe, expect, test } from 'vitest';
import { LESSON_IDS, lessonOf } from '../../../src/lesson/lessons/index.ts';
import { READY_MAPS } from '../../../src/state/accuracy/ready-maps.ts';
import { readAccuracy } from '../../../src/state/accuracy/settings.ts';
import { decode } from '../../../src/state/url.ts';
import { holdsOnMaps } from '../lesson/map-claims.ts';

const lessons = LESSON_IDS.flatMap((id) => lessonOf(id)?.lesson.steps ?? []);

/** Words that can be false, and what must be claimed where they stand. */
const VOCABULARY: readonly (readonly [RegExp, RegExp])[] = [
  [/one double/, /a pixel is 1 double/],
  [/away/, /E beyond/],
  [/(is wrong in a|float32 is wrong)/, /map 1 wrong/],
  [/in no pixel|in every pixel|exact none|none does/, /map 2 right everywhere/],
  [/along D = 0|line D = 0/, /map 1 along D = 0/],
  [/never wrong/, /map 2 never wrong/],
  [/cannot tell/, /map 2 cannot tell/],
  [/\btears\b|torn/, /map 1 tears/],
  [/not there/, /map 1 only invents/],
  [/many rays/, /map 1 wrong in a tenth/],
];

describe.each(READY_MAPS.map((map) => [map.id, map] as const))('the map %s', (_, map) => {
  const state = decode(map.link);

  test('opens without complaint', () => {
    expect([...state.problems, ...readAccuracy(state.settings.accuracy).problems]).toEqual([]);
  });

  test('has one sentence, and every claim of it holds', () => {
    expect(map.sentence.endsWith('.')).toBe(true);
    expect(map.sentence.split(/\.\s/)).toHaveLength(1);
    expect(map.claims.filter((claim) => holdsOnMaps(claim, state) !== true)).toEqual([]);
    for (const [words, claim] of VOCABULARY) {
      if (words.test(map.sentence)) {
        expect(
          map.claims.some((one) => claim.test(one)),
          `${words}`,
        ).toBe(true);
      }
    }
  });

  test('is a step of a lesson', () => {
    expect(lessons.some((step) => JSON.stringify(step).includes(map.link))).toBe(true);
  });
});
