import { METHODS } from '../math/index.ts';
import type { EffectId } from '../scene/effects/index.ts';
import { type Forced, planEffects } from '../scene/effects/plan.ts';
import type { Scene } from '../scene/types.ts';
import { encoded } from './colour.ts';
import type { Ledger, TraceSettings } from './types.ts';
import { MOST_BOUNCES } from './weight.ts';

/*
 * The cheapest picture that is found, by questions asked, that differs from the whole one by no
 * more than is allowed. Not every combination is tried. Nothing is estimated: each candidate is
 * traced, and ends when it has broken the budget.
 */

/** What a picture may differ by; see state/picture/budget.ts. */
interface Allowed {
  readonly levels: number;
  readonly beyond: number;
}

/** Levels of 255, not rounded, of linear light. */
const levelOf = (light: number): number => 255 * encoded(light < 1 ? light : 1);

/** Upper ends of the classes that differences are counted in, in levels; the last one has all. */
export const CLASSES = [0, 0.5, 1, 2.55, 5.1, 12.75, 25.5, 255] as const;

/** Differences of the pixels of a picture from the whole one, as they are traced. */
export interface Differences {
  /** Looks at the pixels that have been traced since. */
  look(film: Float64Array, block: Uint8Array): void;
  /** Pixels that have been looked at, and those of them that differ by more than is allowed. */
  seen(): number;
  over(): number;
  /** The largest difference in levels, and its pixel; −1 before any. */
  worst(): number;
  at(): number;
  /** Pixels by CLASSES. */
  counts(): readonly number[];
  /** Whether more pixels differ by more than may. */
  breaks(): boolean;
}

export function differencesFrom(whole: Float64Array, { levels, beyond }: Allowed): Differences {
  const pixels = whole.length / 3;
  const known = new Uint8Array(pixels);
  const counts = CLASSES.map(() => 0);
  let [seen, over, worst, at] = [0, 0, 0, -1];

  const apart = (film: Float64Array, i: number): number => {
    let most = 0;
    for (let k = 3 * i; k < 3 * i + 3; k++) {
      const [a, b] = [film[k] as number, whole[k] as number];
      if (a !== b) most = Math.max(most, Math.abs(levelOf(a) - levelOf(b)));
    }
    return most;
  };

  return {
    look(film, block) {
      for (let i = 0; i < pixels; i++) {
        if (known[i] === 1 || block[i] !== 0) continue;
        known[i] = 1;
        seen += 1;
        const difference = apart(film, i);
        const of = CLASSES.findIndex((end) => difference <= end);
        counts[of] = (counts[of] ?? 0) + 1;
        if (difference > levels) over += 1;
        if (difference > worst) [worst, at] = [difference, i];
      }
    },
    seen: () => seen,
    over: () => over,
    worst: () => worst,
    at: () => at,
    counts: () => counts,
    breaks: () => over > beyond * pixels,
  };
}

/** What became of a candidate. */
export interface Outcome {
  readonly keeps: boolean;
  /** Of the whole candidate, if it keeps the budget. */
  readonly ledger: Ledger;
  readonly questions: number;
}

/** What is asked for next, and why. */
export interface Wanted {
  readonly settings: TraceSettings;
  readonly step: 'whole' | 'effects' | 'bounces' | 'methods';
}

export interface Choice {
  /** The cheapest one that keeps the budget of those traced; the whole one if none is cheaper. */
  readonly settings: TraceSettings;
  /** The same by the other methods that keep it, which ask about the same rays. */
  readonly methods: readonly TraceSettings[];
}

const DEPTHS = [0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48] as const;

/**
 * Asks for one candidate after another. First effects are left out, the dearest first, as long as
 * the rest keeps the budget and asks less; then the least number of bounces is looked for; then the
 * methods that are less accurate are tried.
 *
 * @param whole settings of the picture of which nothing is left out.
 */
export function* searchBudget(
  scene: Scene,
  whole: TraceSettings,
): Generator<Wanted, Choice, Outcome> {
  let settings = whole;
  let best = yield { settings, step: 'whole' };

  function* tries(next: TraceSettings, step: Wanted['step']): Generator<Wanted, boolean, Outcome> {
    const found = yield { settings: next, step };
    if (!found.keeps || found.questions >= best.questions) return false;
    settings = next;
    best = found;
    return true;
  }

  const tried = new Set<string>();
  for (;;) {
    const forced = nextWithout(scene, settings.forced, best.ledger, tried);
    if (!forced) break;
    tried.add(keyOf(forced));
    yield* tries({ ...settings, forced }, 'effects');
  }
  if (bounced(best.ledger)) {
    for (const bounces of DEPTHS.filter((n) => n < (settings.bounces ?? MOST_BOUNCES))) {
      if (yield* tries({ ...settings, bounces }, 'bounces')) break;
    }
  }
  const methods: TraceSettings[] = [];
  const trusted = METHODS.findIndex(({ id }) => id === whole.method);
  for (const { id } of METHODS.slice(0, Math.max(0, trusted))) {
    const other = { ...settings, method: id };
    const { keeps } = yield { settings: other, step: 'methods' };
    if (keeps) methods.push(other);
  }
  return { settings, methods };
}

const keyOf = (forced: Forced): string => JSON.stringify(Object.entries(forced).sort());
const bounced = ({ kinds }: Ledger): boolean => kinds.reflected.rays + kinds.refracted.rays > 0;

/** Without the dearest effect that runs, asks something and has not been tried; null: none left. */
function nextWithout(
  scene: Scene,
  forced: Forced,
  { effects }: Ledger,
  tried: ReadonlySet<string>,
): Forced | null {
  const priceOf = (id: EffectId): number => effects[id]?.questions ?? 0;
  const running = planEffects(scene, forced)
    .filter(({ id, runs }) => runs && priceOf(id) > 0)
    .sort((a, b) => priceOf(b.id) - priceOf(a.id));
  for (const { id } of running) {
    const without: Forced = { ...forced, [id]: 'off' };
    if (!tried.has(keyOf(without))) return without;
  }
  return null;
}
