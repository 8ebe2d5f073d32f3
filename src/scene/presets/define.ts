import type {
  Background,
  Camera,
  Colour,
  Glass,
  Material,
  Paint,
  Scene,
  Shine,
  SunLight,
  Thing,
} from '../types.ts';

/** A scene that comes with Graze. */
export interface ScenePreset {
  readonly id: string;
  /** One sentence on what there is to see. */
  readonly reason: string;
  /** The comparison that the button Compare starts, as the text of the link's key `against`. */
  readonly compare?: string;
  readonly scene: Scene;
}

export const PAPER: Background = { low: '#e9e4da', high: '#f4f3ef' };
export const VIOLET: Colour = '#7b5ea7';
export const SAND: Colour = '#d8ae6c';
export const BLUE: Colour = '#6d97c4';
export const TEAL: Colour = '#3f9c8f';
export const STONE: Colour = '#d6d0c4';
export const WOOD: Colour = '#6f5a48';
export const CAMERA: Camera = { eye: [1.5, 3, 9], target: [0, 1, 0], angle: 34 };

const DULL: Shine = { strength: 0, exponent: 20 };
export const GLOSSY: Shine = { strength: 0.5, exponent: 60 };
/** Highlights of glass; their share of light does not pass through it. */
export const GLINT: Shine = { strength: 0.1, exponent: 200 };

interface Finish {
  readonly shine?: Shine;
  readonly mirror?: number;
  readonly glass?: Glass;
}

export const material = (paint: Colour | Paint, finish: Finish = {}): Material => ({
  paint: typeof paint === 'string' ? { pattern: 'plain', colour: paint } : paint,
  shine: finish.shine ?? DULL,
  mirror: finish.mirror ?? 0,
  ...(finish.glass ? { glass: finish.glass } : {}),
});

export const clear = (index: number): Glass => ({ index, absorption: [0, 0, 0] });

/** Daylight on an even ground, which meets a sky of the colour that it has in that light. */
export const SKY: Background = { low: '#e8e3da', high: '#f0ece6' };
export const GROUND: Colour = '#f9f8f6';
export const DAYLIGHT: SunLight = {
  light: 'sun',
  id: 'sun',
  colour: '#fffaf0',
  strength: 0.78,
  towards: [-1.2, 2.2, 1.5],
};

/** A round table, whose top is at height 0. */
export const table = (radius: number, paint: Colour | Paint = '#e2dbce'): Thing => ({
  id: 'table',
  shape: { kind: 'circle', normal: [0, 1, 0], center: [0, 0, 0], radius },
  material: material(paint),
});

/** A floor at height y. */
export const floor = (paint: Colour | Paint, y = 0): Thing => ({
  id: 'floor',
  shape: { kind: 'plane', normal: [0, 1, 0], point: [0, y, 0] },
  material: material(paint),
});

export const ball = (
  id: string,
  center: readonly [number, number, number],
  radius: number,
  of: Material,
): Thing => ({ id, shape: { kind: 'sphere', center, radius }, material: of });
