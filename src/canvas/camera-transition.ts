import { mix, type Pose } from './camera.ts';

const MILLISECONDS = 240;

/**
 * Interpolates poses. A named view is reached by a transition; a dragged one at once, except for
 * the camera's target, which leaving the view along the ray moves and which must not jump.
 */
export class CameraTransition {
  #from: Pose | null = null;
  #goal: Pose | null = null;
  #whole = true;
  #began = 0;
  #shown: Pose | null = null;

  get isMoving(): boolean {
    return this.#from !== null;
  }

  /** The pose that was drawn last. */
  get shown(): Pose | null {
    return this.#shown;
  }

  /** Sets the pose; the next transition starts from it. */
  start(pose: Pose): void {
    this.#shown = pose;
    this.#from = null;
  }

  /** @param how 'travel' to a named view, 'follow' a drag, 'jump' if only the scene changed. */
  aim(goal: Pose, how: 'travel' | 'follow' | 'jump', now: number): void {
    const targetMoved = this.#shown && goal.target.some((x, i) => x !== this.#shown?.target[i]);
    const moves = how === 'travel' || (how === 'follow' && targetMoved);
    if (this.#shown && moves && !prefersStill()) {
      // A drag during the move of the target goes on with it.
      if (!(how === 'follow' && this.#from && !this.#whole)) {
        this.#from = this.#shown;
        this.#began = now;
        this.#whole = how === 'travel';
      }
    } else if (how !== 'jump') {
      this.#from = null;
    }
    this.#goal = goal;
  }

  pose(now: number): Pose {
    const goal = this.#goal as Pose;
    const s = this.#from ? (now - this.#began) / MILLISECONDS : 1;
    if (!this.#from || s >= 1) {
      this.#from = null;
      this.#shown = goal;
    } else {
      const eased = 1 - (1 - Math.max(s, 0)) ** 3;
      const between = mix(this.#from, goal, eased);
      this.#shown = this.#whole ? between : { ...goal, target: between.target };
    }
    return this.#shown;
  }
}

function prefersStill(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}
