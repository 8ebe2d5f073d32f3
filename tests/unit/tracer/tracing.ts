import type { Scene } from '../../../src/scene/types.ts';
import { prepareTracer, type Tracer } from '../../../src/tracer/prepare.ts';
import {
  DEFAULT_SETTINGS,
  type RayNode,
  type TileResult,
  type TraceSettings,
} from '../../../src/tracer/types.ts';

/** Small enough for hundreds of pictures in a second or two. */
export const TINY: TraceSettings = { ...DEFAULT_SETTINGS, width: 48, height: 27, lightSamples: 4 };

export const tracerFor = (scene: Scene, settings: Partial<TraceSettings> = {}): Promise<Tracer> =>
  prepareTracer(scene, { ...TINY, ...settings }, () => 0);

interface Traced extends TileResult {
  readonly width: number;
  readonly height: number;
}

const traced = new WeakMap<Scene, Map<string, Promise<Traced>>>();

/** As `picture`, but traced once for all tests of this file's thread; nobody writes into it. */
export function samePicture(scene: Scene, settings: Partial<TraceSettings> = {}): Promise<Traced> {
  const key = JSON.stringify({ ...TINY, ...settings });
  const pictures = traced.get(scene) ?? new Map<string, Promise<Traced>>();
  const found = pictures.get(key) ?? picture(scene, settings);
  traced.set(scene, pictures.set(key, found));
  return found;
}

/** A whole picture in one tile. */
export async function picture(
  scene: Scene,
  settings: Partial<TraceSettings> = {},
): Promise<Traced> {
  const { width, height } = { ...TINY, ...settings };
  const tracer = await tracerFor(scene, settings);
  return { ...tracer.trace({ y0: 0, y1: height, step: 1, refines: false }), width, height };
}

/** All rays of a tree, parents before their children. */
export const flatten = (nodes: readonly RayNode[]): RayNode[] =>
  nodes.flatMap((node) => [node, ...flatten(node.children)]);

/** The rays of every k-th pixel. */
export async function someRays(scene: Scene, every: number): Promise<RayNode[]> {
  const tracer = await tracerFor(scene);
  const found: RayNode[] = [];
  for (let pixel = 0; pixel < TINY.width * TINY.height; pixel += every) {
    const x = pixel % TINY.width;
    found.push(...flatten(tracer.record(x, (pixel - x) / TINY.width).rays));
  }
  return found;
}
