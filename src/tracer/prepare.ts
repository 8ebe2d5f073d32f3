import { EFFECTS } from '../scene/effects/index.ts';
import { planEffects, shownScene } from '../scene/effects/plan.ts';
import type { Scene } from '../scene/types.ts';
import { cameraAxes, fireCamera, pixelsOf } from './camera.ts';
import { level } from './colour.ts';
import type { Part } from './counts.ts';
import { addLedgers, EMPTY_LEDGER } from './ledger.ts';
import { mediumAt } from './medium.ts';
import { createRecorder } from './record.ts';
import type { Film } from './shade.ts';
import { createEngine, type Engine } from './tracer.ts';
import type { PixelWork, RayTree, Tile, TileResult, TraceSettings } from './types.ts';

export interface Tracer {
  /** The effects that run. */
  readonly parts: readonly Part[];
  readonly engine: Engine;
  /** The scene and all settings but those of the camera's rays: what the engine depends on. */
  readonly key: string;
  trace(tile: Tile): TileResult;
  /** Records the rays of one pixel, traced by the same code as a picture. */
  record(x: number, y: number): RayTree;
}

/** Samples per wave: enough for fast kernels, few enough to stay in the cache. */
const AT_ONCE = 4096;

/**
 * Loads the code of exactly the effects that run, and makes a tracer. `clock` in ms. It takes over
 * the engine of the tracer `before` if only the rays of the camera differ: with another one the
 * browser compiles its loops anew.
 */
export async function prepareTracer(
  scene: Scene,
  settings: TraceSettings,
  clock: () => number,
  before?: Tracer,
): Promise<Tracer> {
  const shown = shownScene(scene, settings.forced);
  if (before?.key === keyOf(shown, settings)) {
    return tracerBy(before.engine, shown, settings, before.parts);
  }
  const plan = planEffects(scene, settings.forced).filter(({ runs }) => runs);
  const parts = await Promise.all(
    plan.map(async ({ id, needed }): Promise<Part> => {
      const effect = EFFECTS.find((one) => one.id === id);
      if (!effect) throw new RangeError(`no effect ${id}`);
      return { id, all: !needed, body: await effect.load() };
    }),
  );
  return tracerOf(shown, settings, parts, clock);
}

/** The tracer of loaded effects; `unseen` is the least linear light that is worth a ray. */
export function tracerOf(
  scene: Scene,
  settings: TraceSettings,
  parts: readonly Part[],
  clock: () => number,
  unseen?: number,
): Tracer {
  return tracerBy(createEngine(scene, settings, parts, clock, unseen), scene, settings, parts);
}

function keyOf(scene: Scene, settings: TraceSettings): string {
  const { width, height, samples, part, film, ...others } = settings;
  return JSON.stringify([scene, others], (_, x) => (Object.is(x, -0) ? '-0' : x));
}

function tracerBy(
  engine: Engine,
  scene: Scene,
  settings: TraceSettings,
  parts: readonly Part[],
): Tracer {
  const { camera } = scene;
  const axes = cameraAxes(camera, settings.width / settings.height, mediumAt(scene, camera.eye));
  return {
    parts,
    engine,
    key: keyOf(scene, settings),
    trace: (tile) => traceTile(engine, axes, settings, tile),
    record(x, y) {
      const recorder = createRecorder(scene);
      const wave = engine.camera(settings.samples);
      fireCamera(axes, settings, [y * settings.width + x], wave);
      engine.follow(wave, new Float64Array(3 * settings.samples), undefined, recorder);
      return recorder.treeOf(x, y);
    },
  };
}

function traceTile(
  engine: Engine,
  axes: ReturnType<typeof cameraAxes>,
  settings: TraceSettings,
  tile: Tile,
): TileResult {
  const { part } = settings;
  const pixels = pixelsOf(tile, settings.width, part);
  const samples = part?.samples.length ?? settings.samples;
  const wantsFilm = settings.film === true || part !== undefined;
  const light = wantsFilm ? new Float64Array(3 * pixels.length) : undefined;
  const rgba = new Uint8ClampedArray(4 * pixels.length);
  const surface = new Int32Array(pixels.length);
  const t = new Float64Array(pixels.length);
  const each = Math.max(1, Math.floor(AT_ONCE / samples));
  const film = new Float64Array(3 * each * samples);
  const spent = newWork(each * samples);
  const work = newWork(pixels.length);
  let ledger = EMPTY_LEDGER;
  for (let first = 0; first < pixels.length; first += each) {
    const some = pixels.subarray(first, first + each);
    const wave = engine.camera(some.length * samples);
    fireCamera(axes, settings, some, wave);
    film.fill(0);
    for (const array of Object.values(spent)) array.fill(0);
    ledger = addLedgers(ledger, engine.follow(wave, film, spent));
    develop(film, samples, some.length, rgba.subarray(4 * first), light?.subarray(3 * first));
    for (let k = 0; k < some.length; k++) {
      const middle = k * samples + (samples >> 1);
      surface[first + k] = wave.surface[middle] as number;
      t[first + k] = wave.t[middle] as number;
      for (let s = k * samples; s < (k + 1) * samples; s++) addWork(work, first + k, spent, s);
    }
  }
  // A part of a pixel's rays is added to others: a mean would round.
  if (light && !part) {
    for (let k = 0; k < light.length; k++) light[k] = (light[k] as number) / samples;
  }
  return { tile, pixels, rgba, surface, t, work, ledger, ...(light ? { film: light } : {}) };
}

const newWork = (n: number): PixelWork => ({
  rays: new Uint32Array(n),
  questions: new Uint32Array(n),
  roots: new Uint32Array(n),
});

function addWork(to: PixelWork, at: number, from: PixelWork, s: number): void {
  to.rays[at] = (to.rays[at] as number) + (from.rays[s] as number);
  to.questions[at] = (to.questions[at] as number) + (from.questions[s] as number);
  to.roots[at] = (to.roots[at] as number) + (from.roots[s] as number);
}

/** Writes pixels as sRGB bytes, the mean of their samples, and as `light`: the samples' sum. */
function develop(
  film: Film,
  samples: number,
  pixels: number,
  rgba: Uint8ClampedArray,
  light?: Film,
): void {
  for (let k = 0; k < pixels; k++) {
    for (let channel = 0; channel < 3; channel++) {
      let sum = 0;
      for (let s = 0; s < samples; s++) sum += film[3 * (k * samples + s) + channel] as number;
      rgba[4 * k + channel] = level(sum / samples);
      if (light) light[3 * k + channel] = sum;
    }
    rgba[4 * k + 3] = 255;
  }
}
