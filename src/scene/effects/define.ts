import type { Scene } from '../types.ts';
import type { EffectBody } from './body.ts';
import type { FieldSet } from './fields.ts';

/** Whether a scene calls for an effect, and why or why not, in words that follow its name. */
interface Need {
  readonly needed: boolean;
  /** Not needed by the scene as Graze simplifies it, though nature would show it. */
  readonly leftOut: boolean;
  readonly reason: string;
}

/** What is known of an effect without its code; `load` fetches that, a chunk of its own. */
interface EffectDefinition<Id extends string> {
  readonly id: Id;
  readonly title: string;
  /** What it is, in a sentence. */
  readonly idea: string;
  /** What it adds to a scene's, a material's or a light's data: at most one set a place. */
  readonly fields: readonly FieldSet<Id>[];
  neededBy(scene: Scene): Need;
  load(): Promise<EffectBody>;
}

/**
 * Keeps the id's literal type, from which the union of all is derived. An effect that says nothing
 * of fields adds none.
 */
export const defineEffect = <const Id extends string>(
  effect: Omit<EffectDefinition<Id>, 'fields'> & Partial<Pick<EffectDefinition<Id>, 'fields'>>,
): EffectDefinition<Id> => ({ fields: [], ...effect });

export const needed = (reason: string): Need => ({ needed: true, leftOut: false, reason });
/** It would change nothing in nature either. */
export const notNeeded = (reason: string): Need => ({ needed: false, leftOut: false, reason });
/** It would change something in nature: the reason names the simplification. */
export const leftOut = (reason: string): Need => ({ needed: false, leftOut: true, reason });

/** 'one light', '3 lights', … */
export const counted = (n: number, one: string, many = `${one}s`): string =>
  n === 1 ? `one ${one}` : `${n} ${many}`;
