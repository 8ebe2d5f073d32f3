import { colouredGlass } from './coloured-glass.ts';
import { colouredLight } from './coloured-light.ts';
import { coneOnMirror } from './cone-on-mirror.ts';
import type { ScenePreset } from './define.ts';
import { everything } from './everything.ts';
import { facingMirrors } from './facing-mirrors.ts';
import { far } from './far.ts';
import { glass } from './glass.ts';
import { grazing } from './grazing.ts';
import { hundred } from './hundred.ts';
import { mirror } from './mirror.ts';
import { plain } from './plain.ts';
import { selfIntersection } from './self-intersection.ts';
import { shadows } from './shadows.ts';
import { sixShapes } from './six-shapes.ts';
import { softLight } from './soft-light.ts';
import { twoScales } from './two-scales.ts';

/** All presets, from few effects to all. A new one is one new file and one word here. */
export const PRESETS: readonly ScenePreset[] = [
  plain,
  shadows,
  mirror,
  coneOnMirror,
  facingMirrors,
  glass,
  colouredGlass,
  colouredLight,
  softLight,
  sixShapes,
  far,
  grazing,
  selfIntersection,
  twoScales,
  everything,
  hundred,
];

export const findPreset = (id: string): ScenePreset | undefined =>
  PRESETS.find((preset) => preset.id === id);
