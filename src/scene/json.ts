import { InvalidInput } from '../math/index.ts';
import { quote } from '../math/shapes.ts';
import { jsonFault } from './json-fault.ts';
import type { Scene } from './types.ts';
import { validateScene } from './validate.ts';

/** Most characters of a scene's JSON; 250 things take about 80,000. */
export const LONGEST_JSON = 400_000;

/** The text of a saved scene. */
export function sceneToJson(scene: Scene): string {
  // JSON.stringify writes −0 as 0.
  const text = JSON.stringify(
    { graze: 'scene', scene },
    (_, x) => (Object.is(x, -0) ? '-0' : x),
    2,
  );
  return `${text}\n`;
}

/** The scene in a text, with or without its wrapping. Throws InvalidInput with what is wrong. */
export function sceneFromJson(text: string): Scene {
  if (text.length > LONGEST_JSON) {
    throw new InvalidInput(`a scene has at most ${LONGEST_JSON} characters, got ${text.length}`);
  }
  const data = parsed(text);
  const wrapped = typeof data === 'object' && data !== null && 'graze' in data;
  return validateScene(wrapped && 'scene' in data ? data.scene : data);
}

function parsed(text: string): unknown {
  try {
    return JSON.parse(text, (_, x) => (x === '-0' ? -0 : x));
  } catch {
    throw new InvalidInput(jsonFault(text) ?? `${quote(text.slice(0, 30))} is not a saved scene`);
  }
}
