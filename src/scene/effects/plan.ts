import type { Scene } from '../types.ts';
import { EFFECTS, type EffectId } from './index.ts';

/** Effects that the user switched on or off, whatever the scene needs. */
export type Forced = Readonly<Partial<Record<EffectId, 'on' | 'off'>>>;

/** Whether an effect runs in a scene, and why. */
export interface PlannedEffect {
  readonly id: EffectId;
  readonly title: string;
  readonly needed: boolean;
  readonly leftOut: boolean;
  readonly reason: string;
  /** 'on' if forced though not needed, 'off' if switched off though needed, else 'no'. */
  readonly forced: 'on' | 'off' | 'no';
  readonly runs: boolean;
}

/** The effects of a scene, each decided by its own entry. */
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

/** The scene to trace: without soft shadows, lights with a size become points at their centres. */
export function shownScene(scene: Scene, forced: Forced): Scene {
  if (forced['soft-shadow'] !== 'off') return scene;
  const lights = scene.lights.map((light) => {
    if (light.light !== 'sphere') return light;
    const { radius: _, ...point } = light;
    return { ...point, light: 'point' } as const;
  });
  return { ...scene, lights };
}
