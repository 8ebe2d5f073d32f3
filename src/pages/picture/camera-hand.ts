import { type CameraEdit, onGrid } from '../../state/picture/camera-edits.ts';
import type { PictureSettings } from '../../state/picture/settings.ts';
import type { TraceProgress } from '../../workers/trace-job.ts';

interface CameraHand {
  /** Moves the camera; without `hold` it is at rest a moment after the last move. */
  move(edit: CameraEdit): void;
  hold(): void;
  /** Lets go of it; what a cancelled hold did is taken back. */
  release(isCancelled: boolean): void;
  /** Whether the camera is moving. */
  moves(): boolean;
  /**
   * The picture to trace now; the one before until that is finished. Its scene has the moved camera
   * and a text of its own.
   */
  moving(
    still: PictureSettings,
    seen: (moved: PictureSettings) => TraceProgress | null,
  ): PictureSettings;
}

interface HandTools {
  readonly changed: () => void;
  /** The camera is at rest: takes over what was done to it. */
  readonly rest: (edit: CameraEdit) => void;
}

/** A camera that keys and the wheel move is at rest after so many ms. */
const REST_MS = 220;

/** The picture's size is divided by one of these while it moves. */
const COARSEST = 8;
const FINEST = 2;
const FIRST = 4;
/** Wanted time of a frame in ms, with some room: 15 a second. */
const MS_A_FRAME = 55;

/** Rays to a light with a size while the camera moves. */
const LIGHT_SAMPLES = 4;

export function createCameraHand({ changed, rest }: HandTools): CameraHand {
  let edits: CameraEdit[] = [];
  let held = false;
  let timer = 0;
  let divisor = FIRST;
  let shown: PictureSettings | null = null;
  let done = 0;
  let measured: PictureSettings | null = null;

  const all: CameraEdit = (camera) => edits.reduce((now, edit) => edit(now), camera);

  const end = (): void => {
    clearTimeout(timer);
    if (edits.length === 0 || held) return;
    const made = edits;
    edits = [];
    shown = null;
    rest((camera) => made.reduce((now, edit) => edit(now), camera));
  };

  const resize = (progress: TraceProgress): void => {
    if (progress.msSpent > MS_A_FRAME) divisor = Math.min(divisor + 1, COARSEST);
    else if (progress.msSpent < MS_A_FRAME / 2.5) divisor = Math.max(divisor - 1, FINEST);
  };

  const moved = (still: PictureSettings): PictureSettings => {
    const camera = all(still.scene.camera);
    const scene = { ...still.scene, camera };
    const part = (n: number): number => Math.max(1, Math.round(n / divisor));
    return {
      ...still,
      scene,
      sceneText: `${still.sceneText} ${JSON.stringify(camera)}`,
      width: part(still.width),
      height: part(still.height),
      samples: 1,
      lightSamples: Math.min(LIGHT_SAMPLES, still.lightSamples),
      against: null,
      pixel: null,
    };
  };

  return {
    move(edit) {
      edits.push(edit);
      clearTimeout(timer);
      if (!held) timer = window.setTimeout(end, REST_MS);
      changed();
    },
    hold() {
      held = true;
      clearTimeout(timer);
    },
    release(isCancelled) {
      held = false;
      if (isCancelled) {
        edits = [];
        shown = null;
        changed();
      }
      end();
    },
    moves: () => edits.length > 0,
    moving(still, seen) {
      const before = shown && seen(shown);
      const state = before?.state;
      if (shown && (state === 'loading' || state === 'tracing')) return shown;
      if (before?.state === 'finished' && measured !== shown) {
        measured = shown;
        resize(before);
      }
      if (shown && done === edits.length) return shown;
      done = edits.length;
      shown = moved(still);
      return shown;
    },
  };
}

/** The scene's edit that puts a moved camera on the grid of a picture of this height. */
export const atRest =
  (edit: CameraEdit, height: number): CameraEdit =>
  (camera) =>
    onGrid(edit(camera), height);
