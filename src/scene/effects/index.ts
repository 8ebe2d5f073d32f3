import { absorption } from './absorption.ts';
import { colouredShadow } from './coloured-shadow.ts';
import { dispersion } from './dispersion.ts';
import { fallOff } from './fall-off.ts';
import { heights } from './heights.ts';
import { highlights } from './highlights.ts';
import { pattern } from './pattern.ts';
import { reflection } from './reflection.ts';
import { refraction } from './refraction.ts';
import { shadow } from './shadow.ts';
import { softShadow } from './soft-shadow.ts';

/**
 * All effects, in the order of the ledger. A new effect is a descriptor, its body, and one word
 * here.
 */
export const EFFECTS = [
  shadow,
  softShadow,
  colouredShadow,
  fallOff,
  reflection,
  dispersion,
  refraction,
  absorption,
  pattern,
  highlights,
  heights,
] as const;

export type EffectId = (typeof EFFECTS)[number]['id'];
