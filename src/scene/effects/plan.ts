import type { Scene } from '../types.ts';
import { EFFECTS, type EffectId } from './index.ts';

/** What the user insists on, whatever the scene calls for. */
export type Forced = Readonly<Partial<Record<EffectId, 'on' | 'off'>>>;

/** One effect in one scene: does it run, and why. */
export interface PlannedEffect {
  readonly id: EffectId;
  readonly title: string;
  readonly needed: boolean;
  readonly leftOut: boolean;
  readonly reason: string;
  /** Set only where it makes a difference: 'on' where it is not needed, 'off' where it is. */
  readonly forced: 'on' | 'off' | 'no';
  readonly runs: boolean;
}

/** Derived from the scene, never from a list that someone keeps. */
export function planEffects(scene: Scene, forced: Forced = {}): readonly PlannedEffect[] {
  const shown = shownScene(scene, forced);
  return EFFECTS.map(({ id, title, neededBy }) => {
    const { needed, leftOut, reason } = neededBy(forced[id] === 'off' ? scene : shown);
    const wanted = forced[id];
    const differs = wanted !== undefined && (wanted === 'on') !== needed;
    const runs = wanted === undefined ? needed : wanted === 'on';
    return { id, title, needed, leftOut, reason, forced: differs ? wanted : 'no', runs };
  });
}

/**
 * Without soft shadows a light with a size is taken for a point at its centre: its shadows get
 * hard, not lost.
 */
export function shownScene(scene: Scene, forced: Forced): Scene {
  if (forced['soft-shadow'] !== 'off') return scene;
  const lights = scene.lights.map((light) => {
    if (light.light !== 'sphere') return light;
    const { radius: _, ...point } = light;
    return { ...point, light: 'point' } as const;
  });
  return { ...scene, lights };
}
