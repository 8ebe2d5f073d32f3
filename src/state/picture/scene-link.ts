import { deflateSync, Inflate, strFromU8, strToU8 } from 'fflate';
import { InvalidInput } from '../../math/index.ts';
import { quote } from '../../math/shapes.ts';
import { LONGEST_JSON, sceneFromJson, sceneToJson } from '../../scene/json.ts';
import { PRESETS } from '../../scene/presets/index.ts';
import type { Scene } from '../../scene/types.ts';

/*
 * A scene in a link: a preset by its id, any other one as its JSON, deflated, in the letters that a
 * link may hold (base64url, RFC 4648), after a tilde, which no id has.
 */

const MARK = '~';
const LONGEST = 30_000;
/**
 * Bytes that are inflated at once: a link that makes too many of them is given up after one more
 * portion.
 */
const PORTION = 1024;

export const DEFAULT_SCENE = 'cone-on-mirror';

/** Throws InvalidInput with what is wrong with it. */
export function sceneFromText(text: string): Scene {
  if (text.startsWith(MARK)) return sceneFromJson(unpacked(text.slice(MARK.length)));
  const preset = PRESETS.find(({ id }) => id === text);
  if (!preset) throw new InvalidInput(`there is no scene ${quote(text.slice(0, 40))}`);
  return preset.scene;
}

/** The id of a preset's scene, also of one that was edited back to it; else the packed scene. */
export function textOfScene(scene: Scene): string {
  const json = sceneToJson(scene);
  const preset = PRESETS.find(
    (entry) => entry.scene === scene || sceneToJson(entry.scene) === json,
  );
  return preset?.id ?? MARK + packed(JSON.stringify(JSON.parse(json).scene));
}

/** Whether a text stands for an edited scene and not for a preset. */
export const isPacked = (text: string): boolean => text.startsWith(MARK);

function packed(json: string): string {
  const bytes = deflateSync(strToU8(json), { level: 9 });
  return btoa(strFromU8(bytes, true)).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

function unpacked(text: string): string {
  if (text.length > LONGEST) {
    throw new InvalidInput(`a scene in a link has at most ${LONGEST} letters, got ${text.length}`);
  }
  try {
    const bytes = strToU8(atob(text.replace(/-/g, '+').replace(/_/g, '/')), true);
    return inflated(bytes);
  } catch (error) {
    if (error instanceof InvalidInput) throw error;
    throw new InvalidInput(`${quote(`${MARK}${text.slice(0, 20)}`)} is not a packed scene`);
  }
}

/** Deflate makes up to 1032 bytes of one: no more than a scene may have are kept. */
function inflated(bytes: Uint8Array): string {
  const parts: Uint8Array[] = [];
  let length = 0;
  let ended = false;
  const stream = new Inflate((part, isLast) => {
    parts.push(part);
    length += part.length;
    ended = isLast;
  });
  for (let at = 0; at < bytes.length; at += PORTION) {
    stream.push(bytes.subarray(at, at + PORTION), at + PORTION >= bytes.length);
    if (length > LONGEST_JSON) {
      throw new InvalidInput(`a packed scene has at most ${LONGEST_JSON} characters`);
    }
  }
  if (!ended) throw new RangeError('it ends too early');
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return strFromU8(whole);
}
