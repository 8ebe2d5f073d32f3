import { InvalidInput } from '../../math/index.ts';
import { DEFAULT_METHOD, findMethod, quote } from '../../math/shapes.ts';
import { EFFECTS, type EffectId } from '../../scene/effects/index.ts';
import type { Forced } from '../../scene/effects/plan.ts';
import { findPreset } from '../../scene/presets/index.ts';
import type { StartRule, TraceSettings } from '../../tracer/types.ts';
import { readBounces } from './bounces.ts';
import { readStartRule, startText, startWords } from './start-rule.ts';

/**
 * The one difference of the other side of a comparison; 'whole' is the picture with everything that
 * the scene calls for.
 */
export type Against =
  | { readonly change: 'method'; readonly method: string }
  | { readonly change: 'start'; readonly start: StartRule }
  | { readonly change: 'effect'; readonly effect: EffectId; readonly force: 'on' | 'off' }
  | { readonly change: 'bounces'; readonly bounces: number }
  | { readonly change: 'boxes' }
  | { readonly change: 'whole' };

const WHOLE = 'whole';
const NO_BOXES = 'off:boxes';

/**
 * In a link: 'method:textbook32', 'start:none', 'start:1e-9', 'off:shadow', 'on:reflection',
 * 'bounces:2', 'off:boxes', 'whole'; '' for no comparison.
 */
export const AGAINST = {
  read(text: string): Against | null {
    if (text === '') return null;
    if (text === WHOLE) return { change: 'whole' };
    if (text === NO_BOXES) return { change: 'boxes' };
    const [word = '', ...rest] = text.split(':');
    const value = rest.join(':');
    if (word === 'method' && findMethod(value)) return { change: 'method', method: value };
    if (word === 'start') return { change: 'start', start: readStartRule(value) };
    if (word === 'bounces') return { change: 'bounces', bounces: readBounces(value) };
    const effect = EFFECTS.find(({ id }) => id === value)?.id;
    if ((word === 'on' || word === 'off') && effect) {
      return { change: 'effect', effect, force: word };
    }
    throw new InvalidInput(`${quote(text)} is nothing to compare with`);
  },
  write(against: Against | null): string {
    if (!against) return '';
    if (against.change === 'whole') return WHOLE;
    if (against.change === 'boxes') return NO_BOXES;
    if (against.change === 'bounces') return `bounces:${against.bounces}`;
    if (against.change === 'method') return `method:${against.method}`;
    if (against.change === 'start') return `start:${startText(against.start)}`;
    return `${against.force}:${against.effect}`;
  },
} as const;

/**
 * The comparison that the button Compare starts: the preset's own, else one without a start rule.
 * It always differs from the main picture.
 */
export function firstAgainst(
  sceneText: string,
  start: StartRule,
  method: string,
  forced: Forced = {},
): string {
  const wanted = findPreset(sceneText)?.compare ?? 'start:none';
  if (wanted === `method:${method}`) return `method:${DEFAULT_METHOD}`;
  const [how, id] = wanted.split(':');
  // An effect that is already forced this way is compared with the opposite.
  if (forced[id as EffectId] === how) return `${how === 'on' ? 'off' : 'on'}:${id}`;
  return wanted === `start:${startText(start)}` ? 'start:from' : wanted;
}

/** The settings of the other side. */
export function otherSide(settings: TraceSettings, against: Against): TraceSettings {
  if (against.change === 'method') return { ...settings, method: against.method };
  if (against.change === 'start') return { ...settings, start: against.start };
  if (against.change === 'boxes') return { ...settings, boxless: true };
  if (against.change === 'bounces') return { ...settings, bounces: against.bounces };
  if (against.change === 'whole') return wholeOf(settings);
  const forced = { ...settings.forced, [against.effect]: against.force };
  return { ...settings, forced };
}

/** The settings with nothing forced, all bounces and the default method. */
export function wholeOf({ bounces: _, ...settings }: TraceSettings): TraceSettings {
  return { ...settings, forced: {}, method: DEFAULT_METHOD };
}

/** Words for a side in a picker: method and start rule, or the effect if that is the difference. */
export function sideWords(settings: TraceSettings, against: Against | null): string {
  const method = findMethod(settings.method)?.title ?? settings.method;
  const start = startWords(settings.start);
  if (against?.change === 'boxes') {
    return `${method}, ${settings.boxless ? 'every surface asked' : 'boxes for many shapes'}`;
  }
  if (against?.change === 'bounces') return `${method}, ${bouncesWords(settings.bounces)}`;
  if (against?.change === 'whole') {
    return lessWords(settings) || `the whole picture, ${method}`;
  }
  if (against?.change !== 'effect') return `${method}, ${start}`;
  const title = EFFECTS.find(({ id }) => id === against.effect)?.title ?? against.effect;
  const forced = settings.forced[against.effect];
  const words = forced === undefined ? `${title} as called for` : `${title} forced ${forced}`;
  return `${method}, ${words}`;
}

/** All in which a picture differs from the whole one, in words; '' if in nothing. */
export function lessWords({ forced, bounces, method }: Less): string {
  const titles = (how: 'on' | 'off'): string =>
    EFFECTS.filter(({ id }) => forced[id] === how)
      .map(({ title }) => title)
      .join(', ');
  const [without, more] = [titles('off'), titles('on')];
  const by = findMethod(method)?.title ?? method;
  const parts = [
    ...(without ? [`without ${without}`] : []),
    ...(more ? [`${more} forced on`] : []),
    ...(bounces === undefined ? [] : [bouncesWords(bounces)]),
    ...(method === DEFAULT_METHOD ? [] : [`by ${by}`]),
  ];
  return parts.join('; ');
}

type Less = Pick<TraceSettings, 'forced' | 'bounces' | 'method'>;

/** Undefined: as many as there can be. */
function bouncesWords(bounces: number | undefined): string {
  if (bounces === undefined) return 'all bounces';
  if (bounces === 0) return 'no bounces';
  return bounces === 1 ? 'at most 1 bounce' : `at most ${bounces} bounces`;
}
