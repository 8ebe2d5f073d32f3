import type { EffectId } from '../../scene/effects/index.ts';
import { type Forced, planEffects } from '../../scene/effects/plan.ts';
import type { Scene } from '../../scene/types.ts';

/** How much of a scene's effects is simulated, one after another in the order of the ledger. */
export interface BuildUp {
  /** Number of effects that the scene calls for, and of those that run. */
  readonly all: number;
  readonly shown: number;
}

const calledFor = (scene: Scene): readonly EffectId[] =>
  planEffects(scene).flatMap(({ id, needed }) => (needed ? [id] : []));

export function buildUpOf(scene: Scene, forced: Forced): BuildUp {
  const ids = calledFor(scene);
  return { all: ids.length, shown: ids.filter((id) => forced[id] !== 'off').length };
}

/**
 * One effect more, or one less: the first that is forced off runs, or the last that runs is forced
 * off. From a whole picture one more begins with camera rays alone; from these one less is whole.
 */
export function builtUp(scene: Scene, forced: Forced, by: 1 | -1): Forced {
  const ids = calledFor(scene);
  const off = ids.filter((id) => forced[id] === 'off');
  const on = ids.filter((id) => forced[id] !== 'off');
  const forcedOn = Object.entries(forced).filter(([, how]) => how === 'on');
  const without = (some: readonly EffectId[]): Forced => {
    const off = (these: readonly EffectId[]) => these.map((id) => [id, 'off'] as const);
    const wanted: Forced = Object.fromEntries([...forcedOn, ...off(some)]);
    // Without soft shadows a lamp is a point light, which calls for the effect 'shadow'.
    const instead = planEffects(scene, wanted).flatMap(({ id, runs }) =>
      runs && !ids.includes(id) && wanted[id] !== 'on' ? [id] : [],
    );
    return { ...wanted, ...Object.fromEntries(off(instead)) };
  };
  if (by === 1) return without(off.length === 0 ? ids : off.slice(1));
  return without(on.length === 0 ? [] : ids.filter((id) => off.includes(id) || id === on.at(-1)));
}
