import { InvalidInput } from '../../math/index.ts';
import { quote } from '../../math/shapes.ts';
import { LONGEST_JSON, sceneFromJson, sceneToJson } from '../../scene/json.ts';
import { allPresets, findPreset } from '../../scene/presets/index.ts';
import type { Scene } from '../../scene/types.ts';
import { packed, unpacked } from '../packed-text.ts';

/*
 * A scene in a link: a preset by its id, any other one as its JSON, deflated, after a tilde, which
 * no id has.
 */

const MARK = '~';

export const DEFAULT_SCENE = 'cone-on-mirror';

/** Throws InvalidInput with what is wrong with it. */
export function sceneFromText(text: string): Scene {
  if (text.startsWith(MARK))
    return sceneFromJson(unpacked(text.slice(MARK.length), 'scene', LONGEST_JSON));
  const preset = findPreset(text);
  if (!preset) throw new InvalidInput(`there is no scene ${quote(text.slice(0, 40))}`);
  return preset.scene;
}

/** The preset's id if the scene equals a preset, else the packed scene. */
export function textOfScene(scene: Scene): string {
  const json = sceneToJson(scene);
  const preset = allPresets().find(
    (entry) => entry.scene === scene || sceneToJson(entry.scene) === json,
  );
  return preset?.id ?? MARK + packed(JSON.stringify(JSON.parse(json).scene));
}

/** Whether a text stands for an edited scene and not for a preset. */
export const isPacked = (text: string): boolean => text.startsWith(MARK);
