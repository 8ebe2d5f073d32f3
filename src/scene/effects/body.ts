import type { Answers, Rays } from '../../math/batch.ts';
import type { Vec3 } from '../../math/index.ts';
import type { BodyValues } from './fields.ts';

/*
 * The interface of effects' code (bodies). Rays are processed in waves: the rays of one generation
 * that one cause has fired, as a structure of arrays. The tracer finds their hits, then calls the
 * bodies that the scene needs, one after the other, for the whole wave.
 */

export const CAMERA = 0;
export const REFLECTED = 1;
export const REFRACTED = 2;

/** Rays of one generation with their results so far. */
export interface Wave {
  count: number;
  /** Number of bounces before: 0 for camera rays. */
  depth: number;
  readonly rays: Rays;
  /** Index in the tile of the camera ray from which each descends. */
  readonly sample: Int32Array;
  /**
   * A number for each path from the camera, independent of tiles; the seed of its random numbers.
   */
  readonly path: Int32Array;
  /** The surface that it leaves, or −1. */
  readonly from: Int32Array;
  /** A surface of the glass that it runs through, or −1. */
  readonly medium: Int32Array;
  /** CAMERA, REFLECTED or REFRACTED. */
  readonly kind: Uint8Array;
  /** Weight: the share of its light that arrives at the sample, by colour. */
  readonly red: Float64Array;
  readonly green: Float64Array;
  readonly blue: Float64Array;
  /** For the recorder: its node's number; before that is set, that of its parent. */
  readonly node: Int32Array;

  /** Number of surfaces that were asked about the ray, and of those with a root that counts. */
  readonly asked: Int32Array;
  readonly found: Int32Array;
  /** t and surface of the nearest hit; NaN and −1 without one. */
  readonly t: Float64Array;
  readonly surface: Int32Array;
  /** Number and list of the rays that hit something. */
  hitCount: number;
  readonly hits: Int32Array;
  /** The stored hit point: E + t d, rounded. */
  readonly Px: Float64Array;
  readonly Py: Float64Array;
  readonly Pz: Float64Array;
  /** Unit normal on the ray's side; `back` is 1 if the course's normal is on the other side. */
  readonly Nx: Float64Array;
  readonly Ny: Float64Array;
  readonly Nz: Float64Array;
  readonly back: Uint8Array;
  /** Colour of the paint at the hit. */
  readonly paintR: Float64Array;
  readonly paintG: Float64Array;
  readonly paintB: Float64Array;
  /** Light that is multiplied by the paint, and light that is added as it is. */
  readonly lightR: Float64Array;
  readonly lightG: Float64Array;
  readonly lightB: Float64Array;
  readonly glossR: Float64Array;
  readonly glossG: Float64Array;
  readonly glossB: Float64Array;
}

/** A material as numbers; colours are linear light. */
export interface SurfaceMaterial {
  readonly colour: Vec3;
  readonly other: Vec3;
  /**
   * Components of a point that the pattern depends on (none: plain paint), and its square's size.
   */
  readonly pattern: readonly (0 | 1 | 2)[];
  readonly size: number;
  readonly mirror: number;
  readonly shine: number;
  readonly exponent: number;
  /** Index of refraction; 0 if it is no glass. */
  readonly index: number;
  readonly absorption: Vec3;
  /** Share of light for the paint: 1 − mirror, 0 for glass. */
  readonly matte: number;
  /** Share of light for highlights: 1 − mirror. */
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
  /** Materials by surface. */
  readonly materials: readonly SurfaceMaterial[];
  readonly lights: readonly WorldLight[];
  /** Values of the fields that effects declare for the scene. */
  readonly values: BodyValues;
}

/** One light and the hits of a wave that face it. */
export interface Lit {
  count: number;
  readonly light: WorldLight;
  /** Index k < count → ray of the wave; the arrays below have the same index. */
  readonly ray: Int32Array;
  readonly Lx: Float64Array;
  readonly Ly: Float64Array;
  readonly Lz: Float64Array;
  /** Distance to the light; ∞ for a sun. */
  readonly distance: Float64Array;
  readonly cosine: Float64Array;
  /** Share of the light that arrives; 1 unless an effect changes it. */
  readonly reach: Float64Array;
  /** And of each of its colours. */
  readonly red: Float64Array;
  readonly green: Float64Array;
  readonly blue: Float64Array;
}

/** Shadow rays: is anything hit before t = limit? */
export interface ShadowRays {
  count: number;
  readonly rays: Rays;
  readonly limit: Float64Array;
  readonly from: Int32Array;
  /** The blocking surface, or −1. */
  readonly blocker: Int32Array;
  /** t at which it is hit. */
  readonly t: Float64Array;
  /** For the recorder: node of the ray whose hit it starts from. */
  readonly node: Int32Array;
  /** Index in the tile of the camera ray from which it descends. */
  readonly sample: Int32Array;
  /** As in `Wave`. */
  readonly asked: Int32Array;
  readonly found: Int32Array;
}

/** By shadow ray, the length that ends where it leaves the surface's glass. */
export interface Chords {
  readonly surface: number;
  readonly lengths: Float64Array;
}

export interface Tools {
  /** Empty arrays for so many shadow rays. */
  shadowRays(count: number): ShadowRays;
  /** Sets their blockers, and counts them for the effect; shadow-rays.ts fills them. */
  findBlockers(shadowRays: ShadowRays, light: WorldLight): void;
  /**
   * How far each shadow ray runs, before its limit, through the glass of each coloured surface.
   * Counts them for the effect.
   */
  through(shadowRays: ShadowRays, light: WorldLight): readonly Chords[];
  /** The wave for the effect's rays of the next generation, with room for `count` more. */
  next(count: number): Wave;
  /**
   * Whether a ray with this largest weight may be fired: false beyond the last generation, and if
   * it can bring no more than half a level of 255. Counts the rays that are not fired.
   */
  worth(weight: number): boolean;
  /** Counts rays put into `next`. */
  fired(kind: 'reflected' | 'refracted', count: number): void;
  readonly lightSamples: number;
}

/**
 * `all` in the functions below: the effect was forced on, so it is simulated everywhere, with a
 * share of 0 if the material does not have it. This takes time and changes no bit of the picture.
 */
export type EffectBody = RootsBody | MediumBody | PaintBody | LightBody | GlossBody | BounceBody;

/** Chooses between both roots: puts the first that counts into t0, NaN if none does. */
export interface RootsBody {
  readonly at: 'roots';
  choose(rays: Rays, out: Answers, ends: CutOff, tMin: number, leaving: boolean): void;
}

/** The heights that a surface is kept between. */
export interface CutOff {
  readonly low: number;
  readonly high: number;
  /**
   * Whether a root of ray i, at t, is a hit between them by the rule of the math module, rims
   * included; null for a flat shape, of which that has none.
   */
  readonly isKept: ((rays: Rays, i: number, root: 0 | 1, t: number) => boolean) | null;
  /** By which part of its terms E.y and t d.y a height computed here may be off that of isKept. */
  readonly rounding: number;
}

/**
 * Adds linear light to the sample of ray i. The caller multiplies it by the share that arrives at
 * the sample.
 */
export type AddLight = (i: number, red: number, green: number, blue: number) => void;

/** Changes the light between the ray's start and its hit. */
export interface MediumBody {
  readonly at: 'medium';
  /** Multiplies each ray's weight by the share that passes, and adds light from along the ray. */
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

/** Decides which share of a light arrives. */
export interface LightBody {
  readonly at: 'light';
  run(wave: Wave, lit: Lit, tools: Tools, all: boolean, world: World): void;
}

/** Adds light that is not multiplied by the paint. */
export interface GlossBody {
  readonly at: 'gloss';
  run(wave: Wave, lit: Lit, world: World, all: boolean): void;
}

/** Fires rays of the next generation. */
export interface BounceBody {
  readonly at: 'bounce';
  run(wave: Wave, world: World, tools: Tools, all: boolean): void;
}
