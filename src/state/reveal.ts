import type { Derivation } from '../math/formula.ts';
import { pointAt } from './graph.ts';
import { clipToStage, ticksOf } from './scene.ts';
import type { RaySegment, SceneModel } from './scene-model.ts';
import { isDrawn } from './stage.ts';
import type { AppState } from './state.ts';

interface Derived {
  readonly derivation: Derivation;
}

/**
 * The lines that can be revealed one after another: each step, the conditions, the verdict, the
 * hits.
 */
export function lineCount({ derivation }: Derived): number {
  return derivation.steps.length + (derivation.conditions.length > 0 ? 1 : 0) + 2;
}

/** What is shown of the result when `revealed` lines of it are; null shows all. */
export function shownLines(
  model: Derived,
  revealed: number | null,
): { steps: number; conditions: boolean; verdict: boolean; hits: boolean } {
  const lines = lineCount(model);
  const shown = revealed ?? lines;
  const { steps, conditions } = model.derivation;
  const afterSteps = steps.length + (conditions.length > 0 ? 1 : 0);
  return {
    steps: Math.min(shown, steps.length),
    conditions: shown > steps.length || conditions.length === 0,
    verdict: shown > afterSteps,
    hits: shown > afterSteps + 1,
  };
}

function beadAt({ ray, stage }: SceneModel, t: number): SceneModel['bead'] {
  const point = pointAt(ray, t);
  return point.every(Number.isFinite) ? { t, point, drawn: isDrawn(point, stage) } : null;
}

/**
 * The scene as it is before anyone has computed anything: the ray and the shape, and nothing that
 * tells where they meet.
 */
export function withoutResults(
  scene: SceneModel,
  { ask, bead }: Pick<AppState, 'ask' | 'bead'>,
): SceneModel {
  const reach = clipToStage(scene.ray, scene.stage, { from: -Infinity, to: Infinity });
  const { from, to } = reach ?? { from: 0, to: 0 };
  const behind: RaySegment = { from, to: Math.min(to, 0), stretch: 'behind' };
  const ahead: RaySegment = { from: Math.max(from, 0), to, stretch: 'before' };
  return {
    ...scene,
    ray: {
      ...scene.ray,
      segments: [behind, ahead].filter((part) => part.from < part.to),
      ticks: reach ? ticksOf(reach) : [],
    },
    hits: [],
    // It may be the same ray, with its hits.
    ghost: null,
    handles: scene.handles.map((handle) => ({ ...handle, tangency: null })),
    // At rest the bead lies between the roots; a bead that was put somewhere is the prediction.
    bead: ask === 'where' && bead !== null ? beadAt(scene, bead) : null,
    notes: scene.ray.originDrawn ? [] : scene.notes.slice(0, 1),
    description: `${scene.description.split(':')[0]}. The result is hidden: predict it first.`,
  };
}
