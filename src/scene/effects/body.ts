import type { Answers, Rays } from '../../math/batch.ts';
import type { Vec3 } from '../../math/index.ts';
import type { BodyValues } from './fields.ts';

/*
 * What an effect's code is given and gives. Rays come in waves: the rays of one generation that one
 * cause has fired, as a structure of arrays. The tracer finds what they hit, then calls the bodies
 * that the scene needs, each at its place, over the whole wave.
 */

export const CAMERA = 0;
export const REFLECTED = 1;
export const REFRACTED = 2;

/** Rays of one generation, and what is known of them so far. */
export interface Wave {
  count: number;
  /** How many bounces lie behind them: 0 for camera rays. */
  depth: number;
  readonly rays: Rays;
  /** The camera ray that each descends from, in the tile's count. */
  readonly sample: Int32Array;
  /**
   * A number of its own for each way from the camera, the same however the picture is cut into
   * tiles: the seed of its chance.
   */
  readonly path: Int32Array;
  /** The surface that it leaves, or −1. */
  readonly from: Int32Array;
  /** A surface of the glass that it runs through, or −1. */
  readonly medium: Int32Array;
  /** CAMERA, REFLECTED or REFRACTED. */
  readonly kind: Uint8Array;
  /** The share of its light that arrives at the sample. */
  readonly red: Float64Array;
  readonly green: Float64Array;
  readonly blue: Float64Array;
  /** For the recorder: its number and that of the ray before. */
  readonly node: Int32Array;

  /** The nearest hit: NaN and −1 where there is none. */
  readonly t: Float64Array;
  readonly surface: Int32Array;
  /** The rays that hit something. */
  hitCount: number;
  readonly hits: Int32Array;
  /** The stored hit point: E + t d, rounded. */
  readonly Px: Float64Array;
  readonly Py: Float64Array;
  readonly Pz: Float64Array;
  /**
   * Of length 1, on the side that the ray comes from; `back` is 1 where that is not the shape's own
   * side.
   */
  readonly Nx: Float64Array;
  readonly Ny: Float64Array;
  readonly Nz: Float64Array;
  readonly back: Uint8Array;
  /** The paint's colour there. */
  readonly paintR: Float64Array;
  readonly paintG: Float64Array;
  readonly paintB: Float64Array;
  /** Light that meets the paint, and light that is added as it is. */
  readonly lightR: Float64Array;
  readonly lightG: Float64Array;
  readonly lightB: Float64Array;
  readonly glossR: Float64Array;
  readonly glossG: Float64Array;
  readonly glossB: Float64Array;
}

/** A material in numbers; colours are linear. */
export interface Look {
  readonly colour: Vec3;
  readonly other: Vec3;
  /**
   * Which components of a point count for the pattern, and what a square of it measures; none for a
   * plain paint.
   */
  readonly pattern: readonly (0 | 1 | 2)[];
  readonly size: number;
  readonly mirror: number;
  readonly shine: number;
  readonly exponent: number;
  /** 0 for what is not glass. */
  readonly index: number;
  readonly absorption: Vec3;
  /** The share that meets the paint: 1 − mirror, 0 for glass. */
  readonly matte: number;
  /** The share that highlights are taken of, 1 − mirror. */
  readonly glossy: number;
  readonly values: BodyValues;
}

export interface WorldLight {
  readonly index: number;
  /** A point, or the direction to a sun, of length 1. */
  readonly at: Vec3;
  readonly sun: boolean;
  readonly radius: number;
  readonly colour: Vec3;
  readonly values: BodyValues;
}

export interface World {
  /** By surface. */
  readonly looks: readonly Look[];
  readonly lights: readonly WorldLight[];
  /** Of the scene's own fields. */
  readonly values: BodyValues;
}

/** One light over a wave: the hits that face it, with the way to it. */
export interface Lit {
  count: number;
  readonly light: WorldLight;
  /** Which rays of the wave; the arrays below go by k < count. */
  readonly ray: Int32Array;
  readonly Lx: Float64Array;
  readonly Ly: Float64Array;
  readonly Lz: Float64Array;
  /** ∞ for a sun. */
  readonly distance: Float64Array;
  readonly cosine: Float64Array;
  /** The share of the light that arrives, 1 if no effect says otherwise. */
  readonly reach: Float64Array;
}

/** Rays that only ask: is anything hit before t = limit? */
export interface Feelers {
  count: number;
  readonly rays: Rays;
  readonly limit: Float64Array;
  readonly from: Int32Array;
  /** The surface in the way, or −1. */
  readonly blocker: Int32Array;
  /** Where it is met. */
  readonly t: Float64Array;
  /** For the recorder: the hit's ray. */
  readonly node: Int32Array;
}

export interface Tools {
  /** Room for so many feelers, empty. */
  feelers(count: number): Feelers;
  /** Answers them, and counts them as shadow rays of the effect. */
  feel(feelers: Feelers, light: WorldLight): void;
  /** The wave that the effect's rays of the next generation go to, with room for so many more. */
  next(count: number): Wave;
  /**
   * Whether a ray with this largest weight may be fired: false beyond the last generation, and
   * where it can bring no more than half a level of 255. Keeps count of both.
   */
  worth(weight: number): boolean;
  /** Counts rays put into `next`. */
  fired(kind: 'reflected' | 'refracted', count: number): void;
  readonly lightSamples: number;
}

/**
 * `all`: the effect was forced on, so it is simulated wherever it could be, with a share of 0 where
 * no material asks for it. That costs what it costs and changes no bit.
 */
export type EffectBody = RootsBody | WayBody | PaintBody | LightBody | GlossBody | BounceBody;

/**
 * Chooses among both roots: puts into t0 the first root after `from`'s that counts, NaN if none
 * does.
 */
export interface RootsBody {
  readonly at: 'roots';
  choose(rays: Rays, out: Answers, low: number, high: number, tMin: number, leaving: boolean): void;
}

/**
 * Adds linear light to the sample of ray i. It is added as it is given: light that joins the ray on
 * its way comes times the share of it that arrives at the sample.
 */
export type AddLight = (i: number, red: number, green: number, blue: number) => void;

/** What happens to the light between start and hit. */
export interface WayBody {
  readonly at: 'way';
  /** Multiplies each ray's share by what gets through, and adds the light that joins on the way. */
  run(wave: Wave, world: World, all: boolean, add: AddLight): void;
  /**
   * The most of a colour that a ray can show at its start, if no more than `behind` arrives at its
   * hit: never less than `behind`, and never less for a larger one. A body that adds no light
   * returns `behind`. Rays that could show nothing are not fired, by this bound.
   */
  brightest(world: World, behind: number): number;
}

export interface PaintBody {
  readonly at: 'paint';
  run(wave: Wave, world: World, all: boolean): void;
}

/** Which share of a light arrives. */
export interface LightBody {
  readonly at: 'light';
  run(wave: Wave, lit: Lit, tools: Tools, all: boolean): void;
}

/** What a light adds without meeting the paint. */
export interface GlossBody {
  readonly at: 'gloss';
  run(wave: Wave, lit: Lit, world: World, all: boolean): void;
}

/** Fires rays of the next generation. */
export interface BounceBody {
  readonly at: 'bounce';
  run(wave: Wave, world: World, tools: Tools, all: boolean): void;
}
