import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { sceneToJson } from '../../../src/scene/json.ts';
import { allPresets, EARLIER, findPreset, PRESETS } from '../../../src/scene/presets/index.ts';
import { sceneFromText, textOfScene } from '../../../src/state/picture/scene-link.ts';

/* A link names a scene by its id: what the id stands for never changes. */

const file = new URL('../../links/scenes.json', import.meta.url);
const DIGESTS: Readonly<Record<string, string>> = JSON.parse(readFileSync(file, 'utf8'));

test.each(allPresets())('$id is the scene that it was', ({ id, scene }) => {
  const digest = createHash('sha256').update(sceneToJson(scene)).digest('hex').slice(0, 16);
  expect({ [id]: DIGESTS[id] }, 'in tests/links/scenes.json, a line for each scene').toEqual({
    [id]: digest,
  });
  expect(sceneFromText(id)).toBe(scene);
  expect(textOfScene({ ...scene })).toBe(id);
});

test('no id is gone, and what has a later version is listed as earlier only', () => {
  for (const id of Object.keys(DIGESTS)) expect(findPreset(id)?.id).toBe(id);
  const now = new Set(PRESETS.map(({ id }) => id));
  for (const { id, scene } of EARLIER) {
    const [, base = id, version = '1'] = /^(.*)\.(\d+)$/.exec(id) ?? [];
    const next = `${base}.${Number(version) + 1}`;
    expect([id, now.has(id), findPreset(next)?.id]).toEqual([id, false, next]);
    expect(findPreset(next)?.scene).not.toEqual(scene);
  }
});
