import { expect, test } from 'vitest';
import { createRayPlay } from '../../../../src/pages/picture/ray-play.ts';
import { findPreset } from '../../../../src/scene/presets/index.ts';
import { type TreeRow, treeRows } from '../../../../src/state/picture/tree-rows.ts';
import { TINY, tracerFor } from '../../tracer/tracing.ts';

async function rowsOf(id: string, x: number, y: number): Promise<TreeRow[]> {
  const scene = findPreset(id)?.scene;
  if (!scene) throw new Error(id);
  const [root] = (await tracerFor(scene)).record(x, y).rays;
  return root ? treeRows(scene, root, new Set(), TINY) : [];
}

/** A clock that goes on when it is told to. */
function clock() {
  const waiting = new Set<() => void>();
  return {
    waiting,
    wait: (call: () => void) => {
      waiting.add(call);
      return () => waiting.delete(call);
    },
    tick() {
      for (const call of [...waiting]) {
        waiting.delete(call);
        call();
      }
    },
  };
}

test('rays play one after another, in the list’s order, and then all are there', async () => {
  const rows = await rowsOf('cone-on-mirror', 24, 13);
  expect(rows.length).toBeGreaterThan(3);
  const { wait, tick, waiting } = clock();
  const seen: (string | null)[] = [];
  const play = createRayPlay(() => seen.push(play.at()), wait);
  play.setRows(rows);
  expect(waiting.size).toBe(0);
  play.toggle();
  while (waiting.size > 0) tick();
  expect(seen).toEqual([...rows.map(({ path }) => path), null]);
  expect([play.at(), play.runs()]).toEqual([null, false]);
});

test('it stands still, goes by steps both ways, and plays on from there', async () => {
  const rows = await rowsOf('mirror', 24, 20);
  const { wait, tick, waiting } = clock();
  const play = createRayPlay(() => {}, wait);
  play.setRows(rows);
  play.toggle();
  tick();
  play.toggle();
  expect([play.at(), play.runs(), waiting.size]).toEqual([rows[1]?.path, false, 0]);
  play.step(-1);
  play.step(-1);
  // Before the first one is the whole tree again.
  expect(play.at()).toBeNull();
  play.step(-1);
  expect(play.at()).toBe(rows.at(-1)?.path);
  play.seek(rows[0]?.path ?? '');
  play.toggle();
  tick();
  expect(play.at()).toBe(rows[1]?.path);
  play.setRows([...(await rowsOf('mirror', 3, 20))]);
  expect([play.at(), play.runs(), waiting.size]).toEqual([null, false, 0]);
});
