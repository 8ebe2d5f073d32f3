import { colouredGlass } from './coloured-glass.ts';
import { colouredGlass2 } from './coloured-glass-2.ts';
import { colouredLight } from './coloured-light.ts';
import { coloursApart } from './colours-apart.ts';
import { coneOnMirror } from './cone-on-mirror.ts';
import type { ScenePreset } from './define.ts';
import { everything } from './everything.ts';
import { everything2 } from './everything-2.ts';
import { facingMirrors } from './facing-mirrors.ts';
import { facingMirrors2 } from './facing-mirrors-2.ts';
import { far } from './far.ts';
import { glass } from './glass.ts';
import { glass2 } from './glass-2.ts';
import { grazing } from './grazing.ts';
import { grazing2 } from './grazing-2.ts';
import { hundred } from './hundred.ts';
import { hundred2 } from './hundred-2.ts';
import { mirror } from './mirror.ts';
import { mirror2 } from './mirror-2.ts';
import { plain } from './plain.ts';
import { selfIntersection } from './self-intersection.ts';
import { shadows } from './shadows.ts';
import { shadows2 } from './shadows-2.ts';
import { sixShapes } from './six-shapes.ts';
import { sixShapes2 } from './six-shapes-2.ts';
import { softLight } from './soft-light.ts';
import { softLight2 } from './soft-light-2.ts';
import { twoScales } from './two-scales.ts';

/** All presets, from few effects to all. A new one is one new file and one word here. */
export const PRESETS: readonly ScenePreset[] = [
  plain,
  shadows2,
  mirror2,
  coneOnMirror,
  facingMirrors2,
  glass2,
  colouredGlass2,
  colouredLight,
  coloursApart,
  softLight2,
  sixShapes2,
  far,
  grazing2,
  selfIntersection,
  twoScales,
  everything2,
  hundred2,
];

/** What presets were before a change, for links that name them: a scene never changes. */
export const EARLIER: readonly ScenePreset[] = [
  shadows,
  mirror,
  facingMirrors,
  glass,
  colouredGlass,
  softLight,
  sixShapes,
  grazing,
  everything,
  hundred,
];

export const allPresets = (): readonly ScenePreset[] => [...PRESETS, ...EARLIER];

export const findPreset = (id: string): ScenePreset | undefined =>
  allPresets().find((preset) => preset.id === id);
