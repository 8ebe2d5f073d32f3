import type { Intersection, Ray } from '../../math/index.ts';
import { display } from '../../text/format.ts';
import { subscript } from '../../text/scripts.ts';
import type { StartRule } from '../../tracer/types.ts';
import { type Between, whyCut } from '../heights.ts';
import { crossing } from '../verdict-words.ts';

/** A ray of the tracer, and the rules that decide which of its roots on one surface count. */
export interface RootFilter {
  readonly ray: Ray;
  readonly between: Between | null;
  /** It starts on this surface, and the root there is dropped by identity. */
  readonly leaves: boolean;
  /** Roots count if least ≤ t < most; `most` is ∞ unless a light ends the ray. */
  readonly least: number;
  readonly most: number;
  /** Whether the ray passes through this surface: a shadow ray through glass. */
  readonly passes: boolean;
}

export interface RootFate {
  readonly index: number;
  readonly t: number;
  /** `hit`: the first that counts. `later`: it would count, were there none before. */
  readonly fate: 'hit' | 'later' | 'cut' | 'start' | 'before' | 'beyond' | 'glass';
  /** "t₁ = 4.73241, cut off: y = 1.774 > 1" */
  readonly words: string;
}

/**
 * The least t that counts: for a camera ray, and for one that leaves a surface under a start rule.
 */
export const leastCountedT = (start: StartRule, camera: boolean): number =>
  start.rule === 'epsilon' && !camera
    ? Math.max(start.epsilon, Number.MIN_VALUE)
    : Number.MIN_VALUE;

/**
 * Every root of the whole shape with what became of it: the rules of the tracer (tracer/ask.ts,
 * heights-body.ts), one ray at a time.
 */
export function rootFates(found: Intersection, meeting: RootFilter): RootFate[] {
  const { ray, between, leaves, least, most, passes } = meeting;
  const start = leaves ? startOf(found) : -1;
  let hit = false;
  return found.hits.map(({ t }, i) => {
    const own = (fate: RootFate['fate'], words: string): RootFate => ({
      index: i + 1,
      t,
      fate,
      words: `t${subscript(i + 1)} = ${display(t)}${words ? `, ${words}` : ''}`,
    });
    if (i === start) return own('start', 'where the ray starts: dropped');
    if (!(t >= least)) return own('before', t < 0 ? 'behind the start' : 'before the ray begins');
    const cut = between && cutBy(ray, t, between);
    if (cut) return own('cut', `cut off: ${cut}`);
    if (t >= most) return own('beyond', 'beyond the light');
    if (passes) return own('glass', 'goes through: glass casts no shadow here');
    const words = crossing(found, i);
    if (hit) return own('later', words);
    hit = true;
    return own('hit', ['first hit', words].filter(Boolean).join(', '));
  });
}

/** The height as the tracer computes it. */
function cutBy({ origin, direction }: Ray, t: number, between: Between): string | null {
  const y = origin[1] + t * direction[1];
  const [low, high] = between;
  return y >= low && y <= high ? null : whyCut([0, y, 0], between);
}

/** Index of the root nearest to 0 (scene/drop-start.ts); of two equally near ones the later. */
function startOf({ hits }: Intersection): number {
  return hits.reduce(
    (nearest, { t }, i) => (Math.abs(t) <= Math.abs(hits[nearest]?.t ?? t) ? i : nearest),
    0,
  );
}
