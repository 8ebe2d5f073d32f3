import { describe, expect, test } from 'vitest';
import { Projection } from '../../../src/canvas/projection.ts';
import { nearestLine } from '../../../src/canvas/ray-pick.ts';
import { StageUnits } from '../../../src/canvas/stage-units.ts';
import { findPreset } from '../../../src/scene/presets/index.ts';
import { type TreeLine, treeScene } from '../../../src/state/picture/tree-scene.ts';
import { tracerFor } from '../tracer/tracing.ts';

describe('a ray is picked where it is drawn', async () => {
  for (const id of ['cone-on-mirror', 'everything', 'far']) {
    const scene = findPreset(id)?.scene;
    const [root] = scene ? (await tracerFor(scene)).record(24, 13).rays : [];
    if (!scene || !root) throw new Error(id);
    const { lines, stage, azimuth } = treeScene(scene, root);
    const units = new StageUnits(stage);
    const view = { target: [0, 0, 0], azimuth, elevation: 16, zoom: 1.4 } as const;
    const projection = new Projection(view, 400, 300);
    const spot = ({ from, to }: TreeLine, share: number) => {
      const p = units.toStage(from.map((x, i) => x + share * ((to[i] as number) - x)) as never);
      return p && projection.project(p);
    };

    test(`in ${id}: at its middle it, or one that is drawn over it`, () => {
      for (const line of lines) {
        const at = spot(line, 0.5);
        if (!at) continue;
        const path = nearestLine(lines, units, projection, at, 3);
        const found = lines.find((one) => one.path === path);
        expect(found, line.path).toBeDefined();
        const alone = nearestLine([line], units, projection, at, 1e-3);
        expect(alone).toBe(line.path);
      }
    });

    test(`in ${id}: none where none is`, () => {
      expect(nearestLine(lines, units, projection, { x: -900, y: -900 }, 20)).toBeNull();
      expect(nearestLine([], units, projection, { x: 200, y: 150 }, 20)).toBeNull();
    });
  }
});
