import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createDerive } from '../../../src/state/derive.ts';
import { exploreDetails } from '../../../src/state/explore-details.ts';
import { pitchOf, REFERENCE_HZ, type Score, scoreOf } from '../../../src/state/sonification.ts';
import { INITIAL } from '../../../src/state/state.ts';
import { decode } from '../../../src/state/url.ts';
import { many } from '../many.ts';
import { anyPicture } from './random-state.ts';

const scoreAt = (link: string): Score =>
  scoreOf(createDerive(() => exploreDetails)(decode(`#/explore?${link}`, INITIAL)).graph);

/** t of a moment. */
const tAt = ({ from, to, seconds }: Score, at: number): number =>
  from + ((to - from) * at) / seconds;

describe('the pitch', () => {
  test('is the reference where f is 0, rises with f, and stays within two octaves', () => {
    fc.assert(
      fc.property(
        fc.double(),
        fc.double(),
        fc.double({ min: 1e-300, max: 1e300 }),
        (a, b, half) => {
          fc.pre(!Number.isNaN(a) && !Number.isNaN(b));
          const [p, q] = [pitchOf(a, half), pitchOf(b, half)];
          expect(p).toBeGreaterThanOrEqual(REFERENCE_HZ / 4);
          expect(p).toBeLessThanOrEqual(REFERENCE_HZ * 4);
          if (a <= b) expect(p).toBeLessThanOrEqual(q);
        },
      ),
    );
    expect(pitchOf(0, 1)).toBe(REFERENCE_HZ);
    expect(pitchOf(1, 1)).toBe(2 * REFERENCE_HZ);
    expect(pitchOf(-1, 1)).toBe(REFERENCE_HZ / 2);
    expect(pitchOf(Number.NaN, 1)).toBe(REFERENCE_HZ);
  });
});

describe('what is heard', () => {
  test('of a ray through a cylinder: above, a click, silence, a click, above', () => {
    const score = scoreAt('shape=cylinder&C=0,0,0&r=2.5&E=4,1,1.5&d=-1,0,0');
    expect(score.clicks.map((at) => tAt(score, at))).toEqual([2, 6]);
    expect(score.tones).toHaveLength(2);
    const [before, after] = score.tones;
    expect([before?.begin, before?.end]).toEqual([0, score.clicks[0]]);
    expect([after?.begin, after?.end]).toEqual([score.clicks[1], score.seconds]);
    for (const { pitch } of score.tones) {
      for (const { hertz } of pitch) expect(hertz).toBeGreaterThanOrEqual(REFERENCE_HZ * 0.999999);
    }
    const falls = before?.pitch.map(({ hertz }) => hertz) ?? [];
    expect(falls).toEqual([...falls].sort((a, b) => b - a));
    expect(falls.at(-1)).toBeCloseTo(REFERENCE_HZ, 6);
  });

  test('of a plane: through the reference without a silence', () => {
    const score = scoreAt('shape=plane&N=0,2,0&P=0,0,0&E=0,3,0&d=0,-1,0');
    expect(score.tones.map(({ begin }) => begin)[0]).toBe(0);
    expect(score.tones.at(-1)?.end).toBe(score.seconds);
    const heights = score.tones.flatMap(({ pitch }) => pitch.map(({ hertz }) => hertz));
    expect(Math.max(...heights)).toBeGreaterThan(1.5 * REFERENCE_HZ);
    expect(Math.min(...heights)).toBeLessThan(REFERENCE_HZ);
    expect(score.clicks.map((at) => tAt(score, at))).toEqual([3]);
  });

  test('of a miss: no click and no silence; of a contained ray: the reference', () => {
    const miss = scoreAt('shape=cylinder&C=0,0,0&r=1&E=4,1,1.5&d=-1,0,0');
    expect([miss.clicks, miss.tones.length]).toEqual([[], 1]);
    const held = scoreAt('shape=plane&N=0,1,0&P=0,0,0&E=0,0,0&d=1,0,0');
    for (const { pitch } of held.tones) {
      for (const { hertz } of pitch) expect(hertz).toBe(REFERENCE_HZ);
    }
  });

  test('of any state: in order, within its time, finite, and silent only inside', () => {
    const derive = createDerive(() => exploreDetails);
    fc.assert(
      fc.property(anyPicture, (state) => {
        const { graph } = derive({ ...state, revealed: null });
        const { tones, clicks, seconds } = scoreOf(graph);
        const times = tones.flatMap(({ begin, end }) => [begin, end]);
        expect(times).toEqual([...times].sort((a, b) => a - b));
        for (const at of [...times, ...clicks]) {
          expect(at).toBeGreaterThanOrEqual(0);
          expect(at).toBeLessThanOrEqual(seconds * (1 + 1e-12));
        }
        for (const { pitch } of tones) {
          for (const { at, hertz } of pitch) expect(Number.isFinite(at + hertz)).toBe(true);
        }
        const inside = graph.stretches.some(({ place, to }) => place === 'inside' && to > 0);
        const sounds = tones.reduce((sum, { begin, end }) => sum + end - begin, 0);
        if (!inside) expect(sounds).toBeCloseTo(seconds, 6);
      }),
      { numRuns: many(300) },
    );
  });
});
