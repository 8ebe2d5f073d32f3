import type { Scene } from '../types.ts';
import type { EffectBody } from './body.ts';
import type { FieldSet } from './fields.ts';

/** Whether a scene needs an effect, and why, in words that follow its name. */
interface Need {
  readonly needed: boolean;
  /** Whether nature would show it, and Graze leaves it out as a simplification. */
  readonly leftOut: boolean;
  readonly reason: string;
}

/** The kinds of rays that effects fire. */
type FiredKind = 'shadow' | 'reflected' | 'refracted';

/** An effect without its code, which `load` loads as a chunk of its own. */
interface EffectDefinition<Id extends string> {
  readonly id: Id;
  readonly title: string;
  /** One sentence on what it is. */
  readonly idea: string;
  /** Fields that it adds to scenes, materials or lights; one set per place at most. */
  readonly fields: readonly FieldSet<Id>[];
  /** Words for its rays, if another effect fires rays of the same kind: 'by mirrors'. */
  readonly rays: Readonly<Partial<Record<FiredKind, string>>>;
  neededBy(scene: Scene): Need;
  load(): Promise<EffectBody>;
}

/** Keeps the id's literal type, for the union of all ids; `fields` and `rays` may be left out. */
export const defineEffect = <const Id extends string>(
  effect: Omit<EffectDefinition<Id>, 'fields' | 'rays'> &
    Partial<Pick<EffectDefinition<Id>, 'fields' | 'rays'>>,
): EffectDefinition<Id> => ({ fields: [], rays: {}, ...effect });

export const needed = (reason: string): Need => ({ needed: true, leftOut: false, reason });
/** The effect is not needed, as it would change nothing in nature either. */
export const notNeeded = (reason: string): Need => ({ needed: false, leftOut: false, reason });
/** The effect is left out, although nature would show it; the reason names the simplification. */
export const leftOut = (reason: string): Need => ({ needed: false, leftOut: true, reason });

/** 'one light', '3 lights', … */
export const counted = (n: number, one: string, many = `${one}s`): string =>
  n === 1 ? `one ${one}` : `${n} ${many}`;
