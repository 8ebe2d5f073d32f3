import type { Ray, Vec3 } from '../math/index.ts';
import type { EffectId } from '../scene/effects/index.ts';
import type { Forced } from '../scene/effects/plan.ts';

/*
 * How to use the tracer.
 *
 *   const tracer = await prepareTracer(scene, settings, clock);
 *   const result = tracer.trace(tile);
 *   const tree = tracer.record(x, y);
 *
 * `prepareTracer` (prepare.ts) loads the bodies of the effects that run, no others. `trace` gives a
 * TileResult: pixels, what the camera rays hit, a ledger. `record` gives the ray tree of one pixel,
 * by the same code.
 *
 * On the page nobody calls these: workers/trace-job.ts splits a picture over workers, coarse to
 * fine, and puts a Frame together. What is simulated and why is scene/effects/plan.ts, before any
 * ray is fired. Two finished frames are compared by compare.ts. A picture depends on scene and
 * settings alone: not on tiles, workers, or time.
 */

/** Where the rays that leave a surface begin. */
export type StartRule =
  /** The surface's root nearest to 0 is dropped: the rule of identity of math/leaving-ray.ts. */
  | { readonly rule: 'from' }
  /** Any t > 0 counts, although the stored point is rounded. */
  | { readonly rule: 'none' }
  /** Any t ≥ epsilon counts, in world lengths. */
  | { readonly rule: 'epsilon'; readonly epsilon: number };

export interface TraceSettings {
  readonly width: number;
  readonly height: number;
  /** Camera rays a pixel, on a square grid: 1, 4, 9 or 16. */
  readonly samples: number;
  /** If given, all that is traced; the result then has its film. */
  readonly part?: PicturePart;
  /** Whether the result has the pixels' linear light too. */
  readonly film?: boolean;
  /** Shadow rays to a light with a size, on a square grid with seeded jitter: 4, 9, 16, 25, … */
  readonly lightSamples: number;
  /** The method that answers every question, of METHODS. */
  readonly method: string;
  readonly start: StartRule;
  readonly forced: Forced;
  /** Most bounces of a ray; MOST_BOUNCES if it is left out. */
  readonly bounces?: number;
  /** Whether every surface is asked about every ray, without boxes around them. */
  readonly boxless?: boolean;
}

/** Some rays of some pixels of a picture. */
export interface PicturePart {
  /** Those of a pixel's camera rays, in the order in which their light is added. */
  readonly samples: readonly number[];
  /** 1 for each pixel that is traced, else 0. */
  readonly pixels: Uint8Array;
}

export const DEFAULT_SETTINGS: TraceSettings = {
  width: 640,
  height: 360,
  samples: 1,
  lightSamples: 16,
  method: 'certified',
  start: { rule: 'from' },
  forced: {},
};

/**
 * Pixels of the rows y0 ≤ y < y1 whose x and y are multiples of `step`, without those that a pass
 * with twice the step had traced before (`refines`). Row by row.
 */
export interface Tile {
  readonly y0: number;
  readonly y1: number;
  readonly step: number;
  readonly refines: boolean;
}

/** The surface of a ray that hits nothing; others are indices of `surfacesOf(scene)`. */
export const NOTHING = -1;

export interface TileResult {
  readonly tile: Tile;
  /** The pixels of the tile that were traced, as y · width + x. */
  readonly pixels: Int32Array;
  /** sRGB, opaque, four bytes a pixel of the tile. */
  readonly rgba: Uint8ClampedArray;
  /** Surface that the middle one of a pixel's camera rays hits. */
  readonly surface: Int32Array;
  /** t of that hit; NaN without one. */
  readonly t: Float64Array;
  /** Linear light of the pixels, three doubles each: the mean of the rays; of a part, their sum. */
  readonly film?: Float64Array;
  /** What each pixel needed, with all that its camera rays caused. */
  readonly work: PixelWork;
  readonly ledger: Ledger;
}

/** The work of each pixel (or sample). */
export type PixelWork = { readonly [K in keyof Work]: Uint32Array };

export type RayKind = 'camera' | 'shadow' | 'reflected' | 'refracted';
export const RAY_KINDS: readonly RayKind[] = ['camera', 'shadow', 'reflected', 'refracted'];

/**
 * What was done, the same on every machine. `questions`: number of tests of a ray against a
 * surface. `roots`: number of those that found one that counts: ahead of the start, and between the
 * heights of a surface that has some.
 */
export interface Work {
  readonly rays: number;
  readonly questions: number;
  readonly roots: number;
}

/**
 * Costs. `solves`: number of roots that were computed, or found not to be there; tests of the whole
 * line or by `departs` need none, finite heights need the second one. `ms`: sum over all workers,
 * including waiting.
 */
export interface Cost extends Work {
  readonly solves: number;
  readonly ms: number;
}

export interface Ledger {
  /** Camera rays with the shading that every picture has. */
  readonly camera: Cost;
  /**
   * Each effect that runs, with the rays that it fired and what following them cost; an effect that
   * does not run is not in here. Shadow rays fired from what a mirror shows count for shadows, not
   * for the mirror.
   */
  readonly effects: Readonly<Partial<Record<EffectId, Cost>>>;
  readonly kinds: Readonly<Record<RayKind, Work>>;
  /** The rays of each effect that runs, by kind; a kind of which it fired none is not in here. */
  readonly fired: Readonly<Partial<Record<EffectId, Readonly<Partial<Record<RayKind, number>>>>>>;
  /**
   * Rays that were not fired because all that they could bring is less than half a level of 255
   * (see weight.ts).
   */
  readonly saved: number;
  /** Rays that were not fired because the most bounces were reached. */
  readonly cut: number;
}

/** How much of a picture is traced. */
export interface Progress {
  readonly state: 'loading' | 'tracing' | 'finished' | 'cancelled' | 'failed';
  /** Pixels that are done, of how many. */
  readonly done: number;
  readonly total: number;
  /** Size in pixels of the blocks of the present pass; 1 for the last pass. */
  readonly step: number;
  /** ms since the start. */
  readonly msSpent: number;
  /** Estimated ms to the end; NaN before the first tile. */
  readonly msLeft: number;
  readonly workers: number;
  /** Why it failed; '' otherwise. */
  readonly message: string;
}

/** A ray of a ray tree, with its end and the rays it caused. */
export interface RayNode {
  readonly kind: RayKind;
  readonly ray: Ray;
  /** The surface that it leaves, an index of `surfacesOf(scene)`; NOTHING for a camera ray. */
  readonly from: number;
  /** The largest share of a colour of its light in the pixel's sample. */
  readonly weight: number;
  readonly end: RayEnd;
  readonly children: readonly RayNode[];
}

export type RayEnd =
  | { readonly end: 'background' }
  | {
      readonly end: 'hit';
      readonly t: number;
      readonly point: Vec3;
      /** Of length 1, on the side that the ray comes from. */
      readonly normal: Vec3;
      readonly surface: number;
    }
  /** A shadow ray that reaches its light at t. */
  | { readonly end: 'light'; readonly light: string; readonly t: number }
  /** A blocked shadow ray, with the first blocking surface found, not necessarily the nearest. */
  | {
      readonly end: 'blocked';
      readonly light: string;
      readonly t: number;
      readonly surface: number;
    };

export interface RayTree {
  readonly x: number;
  readonly y: number;
  /** The pixel's camera rays, one per sample. */
  readonly rays: readonly RayNode[];
}
