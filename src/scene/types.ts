import type { Shape, Vec3 } from '../math/index.ts';
import type { Axis } from '../math/shapes.ts';

/*
 * A scene is plain readonly data, in the form in which files hold it. An edit makes a new scene
 * (edit.ts). An untrusted file becomes a Scene only by validate.ts.
 */

/** sRGB as '#rrggbb'. The tracer computes in linear light. */
export type Colour = string;

/** Values of the fields that effects declare (effects/fields.ts), by effect and key. */
export type EffectValues = Readonly<Record<string, Readonly<Record<string, number | string>>>>;

export interface Scene {
  readonly title: string;
  readonly camera: Camera;
  readonly background: Background;
  /** Constant that replaces light from other surfaces: share of its colour that is always shown. */
  readonly ambient: number;
  readonly things: readonly Thing[];
  readonly lights: readonly Light[];
  readonly effects?: EffectValues;
}

/** A pinhole camera. */
export interface Camera {
  readonly eye: Vec3;
  readonly target: Vec3;
  /** The full vertical angle of view in degrees. */
  readonly angle: number;
}

/** Colour of rays that hit nothing: from `low` straight down to `high` straight up. */
export interface Background {
  readonly low: Colour;
  readonly high: Colour;
}

export interface Thing {
  /** Unique among things and lights. */
  readonly id: string;
  readonly shape: Shape;
  readonly material: Material;
  /** Cuts the shape off to low ≤ y ≤ high. */
  readonly between?: readonly [low: number, high: number];
  /** Whether circles close both ends of a round shape with `between`. */
  readonly capped?: boolean;
}

export interface Material {
  readonly paint: Paint;
  /** Highlights: strength 0 … 1 (0: none), exponent of the cosine (Phong). */
  readonly shine: Shine;
  /** Share of light that is mirrored, 0 … 1; the rest is for the paint. */
  readonly mirror: number;
  /** If set, light passes through instead of reaching the paint. The outside is air, index 1. */
  readonly glass?: Glass;
  readonly effects?: EffectValues;
}

export type Paint = PlainPaint | PatternPaint;

export interface PlainPaint {
  readonly pattern: 'plain';
  readonly colour: Colour;
}

/** Two colours in turn: cubes of a size in space (checker), or slices across an axis (stripes). */
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
  /** Index of refraction, ≥ 1. */
  readonly index: number;
  /** σ in e^(−σ · chord), per length, for red, green and blue; ≥ 0. */
  readonly absorption: Vec3;
}

export type Light = PointLight | SunLight | SphereLight;

interface LightBase {
  readonly id: string;
  readonly colour: Colour;
  /** Brightness of a white surface that faces it, 1 being white; it does not fall off. */
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
  /** Direction from the scene to the sun, of any non-zero length. */
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
