import { type CameraEdit, onGrid } from '../../state/picture/camera-edits.ts';
import type { PictureSettings } from '../../state/picture/settings.ts';
import { totalOf } from '../../tracer/ledger.ts';
import type { TraceProgress } from '../../workers/trace-job.ts';

interface CameraMotion {
  /** Moves the camera; without `hold` it is at rest a moment after the last move. */
  move(edit: CameraEdit): void;
  hold(): void;
  /** Ends a hold; a cancelled one takes its moves back. */
  release(isCancelled: boolean): void;
  /** Whether the camera is moving. */
  isMoving(): boolean;
  /** The coarse pictures of this moment; `seen` is how far one is. */
  coarsePictures(
    still: PictureSettings,
    seen: (moved: PictureSettings) => TraceProgress | null,
    now: number,
  ): CoarsePictures;
}

/** Coarse pictures: their scene has the moved camera and a text of its own. */
interface CoarsePictures {
  /** The one to trace, which is the same until it is finished. */
  readonly next: PictureSettings;
  /** The last finished one; null before the first. */
  readonly shown: PictureSettings | null;
}

interface CameraMotionTools {
  readonly changed: () => void;
  /** The camera is at rest: takes over what was done to it. */
  readonly rest: (edit: CameraEdit) => void;
}

/** A camera that keys and the wheel move is at rest after so many ms. */
const REST_MS = 220;

/** The picture's sides are divided by a number between these while it moves, at first by FIRST. */
const COARSEST = 16;
const FINEST = 1.5;
const FIRST = 4;
/** Wanted ms from one picture to the next: 15 a second, with room for those that take longer. */
const MS_A_FRAME = 55;
/** Part of it that tracing has at least, where drawing takes long. */
const LEAST_TRACING = 0.3;
/** Relative deviation of a frame's time up to which the size stays, so that it does not flicker. */
const LOOSE = 0.2;
/** Weight of the last frame among those before, since single ones are disturbed. */
const LAST = 0.3;

/** Rays to a light with a size while the camera moves. */
const LIGHT_SAMPLES = 4;

export function createCameraMotion({ changed, rest }: CameraMotionTools): CameraMotion {
  let edits: CameraEdit[] = [];
  let held = false;
  let timer = 0;
  let divisor = FIRST;
  let next: PictureSettings | null = null;
  let shown: PictureSettings | null = null;
  /** Number of edits that the next picture has, and when it was asked for. */
  let done = 0;
  let begun = Number.NaN;
  /** As frames before have shown: ms to trace a pixel, and ms of a frame beside; NaN before any. */
  let price = Number.NaN;
  let beside = Number.NaN;

  const all: CameraEdit = (camera) => edits.reduce((now, edit) => edit(now), camera);

  const end = (): void => {
    clearTimeout(timer);
    if (edits.length === 0 || held) return;
    const made = edits;
    forget();
    rest((camera) => made.reduce((now, edit) => edit(now), camera));
  };

  const forget = (): void => {
    edits = [];
    next = null;
    shown = null;
    begun = Number.NaN;
  };

  /** Fits the size to what frames took: tracing grows with the pixels, all else does not. */
  const resize = (ms: number, traced: number, { width, height }: PictureSettings): void => {
    if (!(ms >= traced && traced > 0)) return;
    price = mixed(price, traced / (width * height));
    beside = mixed(beside, ms - traced);
    const expected = price * width * height;
    const wanted = Math.max(MS_A_FRAME - beside, LEAST_TRACING * MS_A_FRAME);
    if (Math.abs(Math.log(expected / wanted)) < LOOSE) return;
    const fitting = divisor * Math.sqrt(expected / wanted);
    divisor = Math.min(Math.max(fitting, FINEST), COARSEST);
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
        forget();
        changed();
      }
      end();
    },
    isMoving: () => edits.length > 0,
    coarsePictures(still, seen, now) {
      const progress = next && seen(next);
      const state = progress?.state;
      if (next && (state === 'loading' || state === 'tracing')) return { next, shown };
      if (state === 'finished') shown = next;
      if (next && done === edits.length) {
        // The time until the next move is the person's, and says nothing of tracing.
        begun = Number.NaN;
        return { next, shown };
      }
      if (next && progress) resize(now - begun, tracedMs(progress), next);
      begun = now;
      done = edits.length;
      next = moved(still);
      return { next, shown };
    },
  };
}

/** What tracing alone took, without handing over: only that grows with the pixels. */
const tracedMs = ({ ledger, workers }: TraceProgress): number => totalOf(ledger).ms / workers;

const mixed = (before: number, last: number): number =>
  Number.isNaN(before) ? last : before + LAST * (last - before);

/** The scene's edit that puts a moved camera on the grid of a picture of this height. */
export const atRest =
  (edit: CameraEdit, height: number): CameraEdit =>
  (camera) =>
    onGrid(edit(camera), height);
