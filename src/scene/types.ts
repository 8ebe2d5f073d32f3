import type { Shape, Vec3 } from '../math/index.ts';
import type { Axis } from '../math/shapes.ts';

/*
 * A scene is plain data: what is said here is what a file holds. Everything is readonly; an edited
 * scene is a new one (edit.ts). A file from anywhere becomes a Scene only by validate.ts.
 */

/** '#rrggbb' as in a colour box: sRGB. The tracer works with linear light. */
export type Colour = string;

/** What the fields that effects declare (effects/fields.ts) are set to: by effect, then by key. */
export type EffectValues = Readonly<Record<string, Readonly<Record<string, number | string>>>>;

export interface Scene {
  readonly title: string;
  readonly camera: Camera;
  readonly background: Background;
  /**
   * The constant that stands in for light from other surfaces: this share of its colour every
   * surface shows unlit. 0 … 1.
   */
  readonly ambient: number;
  readonly things: readonly Placed[];
  readonly lights: readonly Light[];
  readonly effects?: EffectValues;
}

/** A pinhole. */
export interface Camera {
  readonly eye: Vec3;
  readonly target: Vec3;
  /** The full vertical angle of view in degrees. */
  readonly angle: number;
}

/** What a ray that meets nothing sees: from `low` straight down to `high` straight up. */
export interface Background {
  readonly low: Colour;
  readonly high: Colour;
}

export interface Placed {
  /** Unlike any other thing's and light's. */
  readonly id: string;
  readonly shape: Shape;
  readonly material: Material;
  /** Only the part with low ≤ y ≤ high is there. */
  readonly between?: readonly [low: number, high: number];
  /** With `between`, for a round shape: circles close both ends. */
  readonly capped?: boolean;
}

export interface Material {
  readonly paint: Paint;
  /** Highlights: strength 0 … 1 (0: none), exponent of the cosine (Phong). */
  readonly shine: Shine;
  /** The share of light that is mirrored, 0 … 1; the rest meets the paint. */
  readonly mirror: number;
  /** Light goes through instead of meeting the paint. The outside is air: index 1. */
  readonly glass?: Glass;
  readonly effects?: EffectValues;
}

export type Paint = PlainPaint | PatternPaint;

export interface PlainPaint {
  readonly pattern: 'plain';
  readonly colour: Colour;
}

/**
 * Cubes of this size in space (checker), or slices across an axis (stripes), in two colours by
 * turns.
 */
type PatternPaint = CheckerPaint | StripesPaint;

export interface CheckerPaint {
  readonly pattern: 'checker';
  readonly colour: Colour;
  readonly other: Colour;
  readonly size: number;
}

export interface StripesPaint {
  readonly pattern: 'stripes';
  readonly colour: Colour;
  readonly other: Colour;
  readonly size: number;
  readonly axis: Axis;
}

export interface Shine {
  readonly strength: number;
  readonly exponent: number;
}

export interface Glass {
  /** Of refraction, ≥ 1. */
  readonly index: number;
  /** σ in e^(−σ · chord), per length, for red, green and blue; ≥ 0. */
  readonly absorption: Vec3;
}

export type Light = PointLight | SunLight | SphereLight;

interface LightBase {
  readonly id: string;
  readonly colour: Colour;
  /**
   * What a white surface facing it sends back, 1 being full white. It does not fall off with
   * distance.
   */
  readonly strength: number;
  readonly effects?: EffectValues;
}

export interface PointLight extends LightBase {
  readonly light: 'point';
  readonly at: Vec3;
}

/** Parallel light from infinitely far. */
export interface SunLight extends LightBase {
  readonly light: 'sun';
  /** From the scene to the sun; any non-zero length. */
  readonly towards: Vec3;
}

export interface SphereLight extends LightBase {
  readonly light: 'sphere';
  readonly at: Vec3;
  readonly radius: number;
}

const PLAIN_SHINE: Shine = { strength: 0, exponent: 20 };
export const GREY: Material = {
  paint: { pattern: 'plain', colour: '#b9b4aa' },
  shine: PLAIN_SHINE,
  mirror: 0,
};
