import { METHODS } from '../../math/index.ts';
import { findMethod } from '../../math/shapes.ts';
import { EFFECTS } from '../../scene/effects/index.ts';
import { planEffects } from '../../scene/effects/plan.ts';
import type { Scene } from '../../scene/types.ts';
import type { TraceSettings } from '../../tracer/types.ts';
import { BOUNCES } from './bounces.ts';
import { AGAINST, type Against, lessWords, otherSide, sideWords, wholeOf } from './comparison.ts';
import { readStartRule, START_TEXTS, startText } from './start-rule.ts';

const MOST = BOUNCES.at(-1) ?? 0;

export interface SideOption {
  readonly value: string;
  readonly words: string;
}

/** Everything in which a side can differ: method, start rule, or one effect switched. */
export function sideOptions(
  scene: Scene,
  settings: TraceSettings,
  current: Against | null,
): readonly SideOption[] {
  const methods = METHODS.filter(({ id }) => id !== settings.method).map(
    ({ id }): Against => ({ change: 'method', method: id }),
  );
  const starts = START_TEXTS.filter((text) => text !== startText(settings.start)).map(
    (text): Against => ({ change: 'start', start: readStartRule(text) }),
  );
  const effects = planEffects(scene, settings.forced).map(
    ({ id, runs }): Against => ({ change: 'effect', effect: id, force: runs ? 'off' : 'on' }),
  );
  const depths = BOUNCES.filter((n) => n < (settings.bounces ?? MOST)).map(
    (n): Against => ({ change: 'bounces', bounces: n }),
  );
  const all: Against[] = [...starts, ...methods, ...effects, ...depths, { change: 'boxes' }];
  const isWhole = JSON.stringify(wholeOf(settings)) === JSON.stringify(settings);
  if (!isWhole) all.push({ change: 'whole' });
  const known = all.map(AGAINST.write);
  if (current && !known.includes(AGAINST.write(current))) all.unshift(current);
  return all.map((against) => ({
    value: AGAINST.write(against),
    words: sideWords(otherSide(settings, against), against),
  }));
}

/** The options for the right side, which is the main picture: methods and start rules. */
export function mainOptions(settings: TraceSettings): readonly SideOption[] {
  return sideOptions({ ...NO_SCENE }, settings, null).filter(
    ({ value }) => value.startsWith('method') || value.startsWith('start'),
  );
}

const NO_SCENE: Scene = {
  title: '',
  camera: { eye: [0, 0, 1], target: [0, 0, 0], angle: 30 },
  background: { low: '#000000', high: '#000000' },
  ambient: 0,
  things: [],
  lights: [],
};

/** Sentences on what both sides share and the one thing in which they differ. */
export function causeWords(scene: Scene, settings: TraceSettings, against: Against): string {
  if (isSame(scene, settings, otherSide(settings, against))) {
    return 'Both sides are the same picture.';
  }
  if (against.change === 'start') return 'The method is the same; only the start rule is not.';
  if (against.change === 'method') return 'The start rule is the same; only the method is not.';
  const method = findMethod(settings.method)?.title ?? settings.method;
  if (against.change === 'boxes') {
    return `Both by ${method}; on the left every surface is asked about every ray, however many.`;
  }
  if (against.change === 'bounces') {
    const after = against.bounces === 1 ? '1 bounce' : `${against.bounces} bounces`;
    return `Both by ${method}; only on the left rays end after ${after}.`;
  }
  if (against.change === 'whole') {
    return `Left: the whole picture. Right: ${lessWords(settings)}.`;
  }
  const title = EFFECTS.find(({ id }) => id === against.effect)?.title ?? against.effect;
  const what = against.force === 'off' ? `is without ${title}` : `has ${title} forced on`;
  return `Both by ${method}; only the left one ${what}.`;
}

/** Whether two settings ask for one picture: an effect may run, or not, for several reasons. */
function isSame(scene: Scene, a: TraceSettings, b: TraceSettings): boolean {
  const asked = ({ method, start, forced, bounces = MOST, boxless }: TraceSettings): string => {
    const plan = planEffects(scene, forced).map((effect) => [effect.runs, effect.forced]);
    return JSON.stringify([method, start, bounces, boxless, plan]);
  };
  return asked(a) === asked(b);
}
