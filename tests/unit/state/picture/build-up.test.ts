import { describe, expect, test } from 'vitest';
import { planEffects } from '../../../../src/scene/effects/plan.ts';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import { buildUpOf, builtUp } from '../../../../src/state/picture/build-up.ts';

describe.each(PRESETS)('$id, built up', ({ scene }) => {
  const needed = planEffects(scene).filter((one) => one.needed);

  test('begins with camera rays alone, gets one effect after another, and ends whole', () => {
    let forced = {};
    for (let shown = 0; shown <= needed.length; shown++) {
      if (needed.length === 0) break;
      forced = builtUp(scene, forced, 1);
      expect(buildUpOf(scene, forced)).toEqual({ all: needed.length, shown });
      const runs = planEffects(scene, forced).filter((one) => one.runs);
      expect(runs.map(({ id }) => id)).toEqual(needed.slice(0, shown).map(({ id }) => id));
    }
    expect(forced).toEqual({});
  });

  test('back takes away what came last, and leaves alone what else is forced', () => {
    const idle = planEffects(scene).find((one) => !one.needed)?.id;
    const forced = idle ? ({ [idle]: 'on' } as const) : {};
    let now = builtUp(scene, forced, 1);
    for (let k = 0; k < needed.length; k++) {
      const next = builtUp(scene, now, 1);
      expect(builtUp(scene, next, -1)).toEqual(now);
      now = next;
    }
    if (needed.length > 0) expect(now).toEqual(forced);
  });
});
