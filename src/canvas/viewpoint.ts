import type { Stage } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';
import type { SceneModel } from '../state/scene-model.ts';
import type { FreeView, View } from '../state/view.ts';
import { freeOf, type Pose } from './camera.ts';
import { CameraTransition } from './camera-transition.ts';
import { type Frame, framedPose } from './framing.ts';
import type { StageUnits } from './stage-units.ts';

const FIRST: FreeView = { azimuth: 16, elevation: 14, zoom: 1 };

/**
 * Where the camera stands, and which part of the world it frames: as the model has it, but held
 * still while something is dragged. A picture that made room for what is dragged out of it would
 * run away from the pointer.
 */
export class Viewpoint {
  readonly #transition = new CameraTransition();
  #view: View | null = null;
  #held: { readonly stage: Stage; readonly pose: Pose } | null = null;

  get isMoving(): boolean {
    return this.#transition.isMoving;
  }

  /** The model in the part of the world that is shown. */
  framed(model: SceneModel): SceneModel {
    const stage = this.#held?.stage ?? model.stage;
    return stage === model.stage ? model : { ...model, stage };
  }

  /**
   * Points the camera at the model's view: on the way there when the view itself has changed, at
   * once when only the scene has.
   */
  aim(model: SceneModel, units: StageUnits, frame: Frame, now: number): void {
    const { view } = model;
    const isAsked = this.#view !== null && !sameView(this.#view, view);
    this.#view = view;
    const goal = this.#held?.pose ?? framedPose(model, units, frame);
    const how = typeof view === 'string' || view.zoom === null ? 'travel' : 'follow';
    this.#transition.aim(goal, isAsked && !this.#held ? how : 'jump', now);
  }

  pose(now: number): Pose {
    return this.#transition.pose(now);
  }

  /**
   * Where a gesture starts: the view that was asked for last, even if it is not painted yet; where
   * its zoom was left open, where the camera is.
   */
  current(model: SceneModel | null): FreeView {
    const view = model?.view;
    if (view && typeof view !== 'string' && view.zoom !== null) return view;
    return this.#transition.shown ? freeOf(this.#transition.shown) : FIRST;
  }

  hold(stage: Stage): void {
    const pose = this.#transition.shown;
    if (pose) this.#held ??= { stage, pose };
  }

  /** Goes on to where the model wants the camera, from where it was held. */
  release(model: SceneModel, units: StageUnits, frame: Frame, now: number): void {
    if (!this.#held) return;
    const from = restaged(this.#held.pose, this.#held.stage, model.stage);
    this.#held = null;
    const goal = framedPose(model, units, frame);
    if (from && samePose(from, goal)) return;
    if (from) this.#transition.start(from);
    this.#transition.aim(goal, from ? 'travel' : 'jump', now);
  }
}

/** Stages that differ by more have nothing in common that a move of the camera could show. */
const APART = 1e4;

/**
 * The same camera in the units of another stage; null where there it would stand in one point with
 * what it looks at, or nowhere.
 */
export function restaged(
  { target, azimuth, elevation, zoom }: Pose,
  from: Stage,
  to: Stage,
): Pose | null {
  const ratio = to.radius / from.radius;
  const moved = (i: 0 | 1 | 2): number =>
    (from.center[i] - to.center[i] + target[i] * from.radius) / to.radius;
  const there: Vec3 = [moved(0), moved(1), moved(2)];
  const isNear = ratio < APART && ratio > 1 / APART && there.every((x) => Math.abs(x) < APART);
  return isNear ? { azimuth, elevation, target: there, zoom: zoom * ratio } : null;
}

function samePose(a: Pose, b: Pose): boolean {
  return (
    a.azimuth === b.azimuth &&
    a.elevation === b.elevation &&
    a.zoom === b.zoom &&
    a.target.every((x, i) => x === b.target[i])
  );
}

function sameView(a: View, b: View): boolean {
  if (typeof a === 'string' || typeof b === 'string') return a === b;
  return a.azimuth === b.azimuth && a.elevation === b.elevation && a.zoom === b.zoom;
}
