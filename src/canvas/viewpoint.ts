import type { Stage } from '../math/drawing.ts';
import type { Vec3 } from '../math/index.ts';
import type { FreeView, View } from '../state/camera-view.ts';
import type { SceneModel } from '../state/scene-model.ts';
import { freeOf, type Pose } from './camera.ts';
import { CameraTransition } from './camera-transition.ts';
import { type Frame, framedPose } from './framing.ts';
import type { StageUnits } from './stage-units.ts';

const FIRST: FreeView = { azimuth: 16, elevation: 14, zoom: 1 };

/**
 * The camera and the stage: those of the model, but fixed during a drag, since a stage that grows
 * with the dragged point would move away from the pointer.
 */
export class Viewpoint {
  readonly #transition = new CameraTransition();
  #view: View | null = null;
  #held: { readonly stage: Stage; readonly pose: Pose } | null = null;

  get isMoving(): boolean {
    return this.#transition.isMoving;
  }

  /** The model with the stage that is shown. */
  framed(model: SceneModel): SceneModel {
    const stage = this.#held?.stage ?? model.stage;
    return stage === model.stage ? model : { ...model, stage };
  }

  /** Moves the camera to the model's view: by a transition if the view changed, else at once. */
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

  /** The view at the start of a gesture: the last one requested, with the zoom that was chosen. */
  current(model: SceneModel | null): FreeView {
    const view = model?.view;
    if (view && typeof view !== 'string' && view.zoom !== null) return view;
    return this.#transition.shown ? freeOf(this.#transition.shown) : FIRST;
  }

  hold(stage: Stage): void {
    const pose = this.#transition.shown;
    if (pose) this.#held ??= { stage, pose };
  }

  /** Ends a drag: moves the camera from where it was fixed to the model's view. */
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

/** Largest ratio of two stages' radii between which the camera is moved. */
const APART = 1e4;

/** The same camera in units of another stage; null if its distance would be 0 or not finite. */
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
