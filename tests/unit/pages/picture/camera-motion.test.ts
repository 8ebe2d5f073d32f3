import { describe, expect, test } from 'vitest';
import { createCameraMotion } from '../../../../src/pages/picture/camera-motion.ts';
import { turned } from '../../../../src/state/picture/camera-edits.ts';
import { type PictureSettings, pictureSettings } from '../../../../src/state/picture/settings.ts';
import { EMPTY_LEDGER } from '../../../../src/tracer/ledger.ts';
import type { TraceProgress } from '../../../../src/workers/trace-job.ts';

const STILL = pictureSettings({ scene: 'everything', size: '752x424' });

/** Two workers, half of the work each. */
const tracedIn = (ms: number) => ({
  ledger: { ...EMPTY_LEDGER, camera: { ...EMPTY_LEDGER.camera, ms: 2 * ms } },
  workers: 2,
});

/**
 * A drag without a pause on a device where a frame takes `fixed` ms and `price` ns a pixel; the
 * intervals from each picture to the next, and their pixels.
 */
function drag(frames: number, fixed: number, price: number) {
  const hand = createCameraMotion({ changed: () => {}, rest: () => {} });
  const finished = new Map<PictureSettings, number>();
  const seen = (one: PictureSettings) =>
    ({
      state: finished.has(one) ? 'finished' : 'tracing',
      ...tracedIn(finished.get(one) ?? 0),
    }) as TraceProgress;
  hand.hold();
  const made: { ms: number; pixels: number; shown: PictureSettings | null }[] = [];
  let now = 0;
  for (let k = 0; k < frames; k++) {
    hand.move(turned(0.01, 0));
    const { next, shown } = hand.coarsePictures(STILL, seen, now);
    // The hand goes on while the picture is traced, which stays the same.
    hand.move(turned(0.01, 0));
    expect(hand.coarsePictures(STILL, seen, now).next).toBe(next);
    const pixels = next.width * next.height;
    const ms = fixed + (price * pixels) / 1e6;
    made.push({ ms, pixels, shown });
    now += ms;
    finished.set(next, ms - fixed);
  }
  return made;
}

describe('while the hand goes on', () => {
  test('each finished picture is shown, though another one is asked for at once', () => {
    const made = drag(5, 10, 1000);
    expect(made[0]?.shown).toBeNull();
    for (const { shown } of made.slice(1)) expect(shown).not.toBeNull();
    expect(new Set(made.slice(1).map(({ shown }) => shown)).size).toBe(4);
  });

  test.each([
    ['quick', 5, 200],
    ['usual', 10, 2000],
    ['slow', 20, 8000],
    ['slowly drawing', 35, 2000],
  ])('on a %s device it has 15 pictures a second, and no fewer pixels than they need', (...of) => {
    const [, fixed, price] = of;
    const last = drag(60, fixed, price).slice(-10);
    for (const { ms } of last) expect(ms).toBeLessThan(1000 / 15);
    // A third of the size or less would be wasted time; the finest is bound by the picture.
    const most = (STILL.width * STILL.height) / 1.5 ** 2;
    for (const { ms, pixels } of last) expect(ms > 36 || pixels > 0.9 * most).toBe(true);
    expect(new Set(last.map(({ pixels }) => pixels)).size).toBe(1);
  });

  test('where drawing alone takes too long the picture keeps some size', () => {
    const { pixels, ms } = drag(60, 80, 2000).at(-1) ?? { pixels: 0, ms: 0 };
    expect([pixels > 5000, ms < 100]).toEqual([true, true]);
  });

  test('a pause of the hand is not taken for a slow device', () => {
    const hand = createCameraMotion({ changed: () => {}, rest: () => {} });
    const seen = () => ({ state: 'finished', ...tracedIn(20) }) as TraceProgress;
    hand.hold();
    hand.move(turned(0.01, 0));
    const { next } = hand.coarsePictures(STILL, seen, 0);
    expect(hand.coarsePictures(STILL, seen, 50).next).toBe(next);
    hand.move(turned(0.01, 0));
    expect(hand.coarsePictures(STILL, seen, 5000).next.width).toBe(next.width);
  });
});
