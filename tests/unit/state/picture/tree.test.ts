import { describe, expect, test } from 'vitest';
import { intersect } from '../../../../src/math/index.ts';
import { PRESETS } from '../../../../src/scene/presets/index.ts';
import { sixShapes } from '../../../../src/scene/presets/six-shapes.ts';
import { exploreLink } from '../../../../src/state/explore-link.ts';
import { surfaceSteps } from '../../../../src/state/picture/surface-steps.ts';
import { type TreeRow, treeRows } from '../../../../src/state/picture/tree-rows.ts';
import { treeScene } from '../../../../src/state/picture/tree-scene.ts';
import { decode } from '../../../../src/state/url.ts';
import type { RayNode, TraceSettings } from '../../../../src/tracer/types.ts';
import { many } from '../../many.ts';
import { flatten, TINY, tracerFor } from '../../tracer/tracing.ts';

/** Pixels from one that is asked to the next. */
const STRIDE = many(4) === 4 ? 37 : 61;

const NONE: ReadonlySet<string> = new Set();

/** Every `STRIDE`th pixel's tree of every preset, with the rows that the list shows. */
async function trees(
  how: Partial<TraceSettings> = {},
): Promise<{ id: string; root: RayNode; rows: TreeRow[]; all: TreeRow[] }[]> {
  const found = [];
  const settings = { ...TINY, ...how };
  for (const { id, scene } of PRESETS) {
    const tracer = await tracerFor(scene, settings);
    for (let pixel = 0; pixel < TINY.width * TINY.height; pixel += STRIDE) {
      const x = pixel % TINY.width;
      const [root] = tracer.record(x, (pixel - x) / TINY.width).rays;
      if (!root) throw new Error('no ray');
      const rows = treeRows(scene, root, NONE, settings);
      const groups = new Set(rows.filter(({ group }) => group).map(({ path }) => path));
      found.push({ id, root, rows, all: treeRows(scene, root, groups, settings) });
    }
  }
  return found;
}

const FOUND = await trees();

describe('the rays of a pixel as a list', () => {
  test('with all groups opened every ray stands in it once, before those that it fires', () => {
    for (const { root, all } of FOUND) {
      const single = all.filter(({ group }) => group === null);
      expect(single.map(({ node }) => node)).toEqual(flatten([root]));
      expect(new Set(single.map(({ path }) => path)).size).toBe(single.length);
    }
  });

  test('a group counts its rays, and those that are blocked', () => {
    let groups = 0;
    for (const { rows, all } of FOUND) {
      for (const { path, rays, group, depth } of rows) {
        if (!group) continue;
        groups++;
        expect(rays).toHaveLength(group.count);
        const members = all.filter((row) => !row.group && rays.includes(row.path));
        expect(members.map((row) => [row.kind, row.depth])).toEqual(
          rays.map(() => ['shadow', depth + 1]),
        );
        const blocked = members.filter(({ node }) => node.end.end === 'blocked');
        expect(blocked).toHaveLength(group.blocked);
        expect(rays).not.toContain(path);
      }
    }
    expect(groups).toBeGreaterThan(20);
  });

  test('every verdict is said in words, and all kinds of rays occur', () => {
    const kinds = new Set<string>();
    const ends = new Set<string>();
    for (const { all } of FOUND) {
      for (const { kind, node, words, verdict, rest } of all) {
        kinds.add(kind);
        ends.add(node.end.end);
        expect(words.includes(' from ')).toBe(kind !== 'camera');
        expect(words.includes(' to ')).toBe(kind === 'shadow');
        expect(`${words}; ${verdict}${rest}`).not.toMatch(/undefined|NaN|null|Infinity/);
        expect(verdict).not.toBe('');
      }
    }
    expect([...kinds].toSorted()).toEqual(['camera', 'reflected', 'refracted', 'shadow']);
    expect([...ends].toSorted()).toEqual(['background', 'blocked', 'hit', 'light']);
  });

  test('a ray opens in Explore bit by bit, and where it hits is a root there', () => {
    let hits = 0;
    for (const { all } of FOUND) {
      for (const { shape, ray, node } of all) {
        if (!shape) continue;
        const state = decode(exploreLink(shape, ray, 'certified'));
        expect(state.problems).toEqual([]);
        expect(state.E).toEqual(ray.origin);
        expect(state.d).toEqual(ray.direction);
        expect(state.shapes[state.kind]).toEqual(shape);
        if (node.end.end !== 'hit') continue;
        const roots = intersect(shape, ray, 'certified').hits.map(({ t }) => t);
        expect(roots).toContain(node.end.t);
        hits++;
      }
    }
    expect(hits).toBeGreaterThan(200);
  });

  test('its algebra has the numbers of the method', () => {
    for (const { all } of FOUND.filter((_, i) => i % 9 === 0)) {
      for (const { shape, rootFilter: meeting } of all) {
        const steps = shape && surfaceSteps(shape, meeting, 'certified');
        expect(steps?.lines.length).toBeGreaterThan(0);
        expect(steps?.verdict).not.toBe('');
      }
    }
  });

  test.each([
    ['certified, by identity', {}],
    ['textbook, without a start rule', { method: 'textbook', start: { rule: 'none' } }],
    [
      'float32, with an epsilon',
      { method: 'textbook32', start: { rule: 'epsilon', epsilon: 0.01 } },
    ],
    ['heights forced off', { forced: { heights: 'off' } }],
  ] as const)(
    '%s: the first hit that it names is the tracer’s, and a cut root none',
    async (_, how) => {
      const fates: Record<string, number> = {};
      let hits = 0;
      for (const { all } of Object.keys(how).length > 0 ? await trees(how) : FOUND) {
        for (const { shape, rootFilter: meeting, node, rest } of all) {
          const method = 'method' in how ? how.method : 'certified';
          const steps = shape && surfaceSteps(shape, meeting, method);
          if (!steps) continue;
          for (const { fate } of steps.roots) fates[fate] = (fates[fate] ?? 0) + 1;
          const named = steps.roots.filter(({ fate }) => fate === 'hit').map(({ t }) => t);
          if (node.end.end === 'hit' || node.end.end === 'blocked') {
            expect(named).toEqual([node.end.t]);
            hits++;
          } else expect(named).toEqual([]);
          const cut = steps.roots.filter(({ fate, t }) => fate === 'cut' && t < (named[0] ?? t));
          for (const { words } of cut) {
            expect(words).toMatch(/cut off: y = (\S.*) [<>] (?!\1$)/);
            expect(rest).toContain(words);
          }
        }
      }
      expect(hits).toBeGreaterThan(200);
      expect((fates.cut ?? 0) > 10).toBe(!('forced' in how));
    },
  );
});

test('before the circle that closes an end, the cut root of the side is named', async () => {
  const things = sixShapes.scene.things.map((thing) =>
    thing.id === 'cylinder' ? { ...thing, capped: true } : thing,
  );
  const scene = { ...sixShapes.scene, things };
  const tracer = await tracerFor(scene);
  let named = 0;
  for (let x = 28; x < 42; x++) {
    for (let y = 5; y < 20; y++) {
      const [root] = tracer.record(x, y).rays;
      const [row] = root ? treeRows(scene, root, NONE, TINY) : [];
      const end = root?.end;
      if (end?.end !== 'hit' || row?.verdict !== 'cylinder, its upper end') continue;
      expect(row.rest).toMatch(/ at t = \S+; of its side t₁ = \S+, cut off: y = \S+ > 1\.9$/);
      expect(Number(/side t₁ = ([\d.]+)/.exec(row.rest)?.[1])).toBeLessThan(end.t);
      named++;
    }
  }
  expect(named).toBeGreaterThan(3);
});

describe('the rays in space', () => {
  test('one line each, finite, not longer than the picture is large', () => {
    for (const { id, root } of FOUND) {
      const preset = PRESETS.find((entry) => entry.id === id);
      if (!preset) throw new Error(id);
      const { lines, stage, touched, others } = treeScene(preset.scene, root);
      expect(lines).toHaveLength(flatten([root]).length);
      expect(stage.radius).toBeGreaterThan(0);
      for (const { from, to } of lines) {
        const length = Math.hypot(...to.map((x, i) => x - (from[i] ?? 0)));
        expect(length, id).toBeLessThan(4 * stage.radius);
      }
      expect(touched.patches.length + others.patches.length).toBeGreaterThan(0);
    }
  });

  test('a ray that hits ends at the hit', () => {
    let hits = 0;
    for (const { id, root } of FOUND) {
      const preset = PRESETS.find((entry) => entry.id === id);
      if (!preset) throw new Error(id);
      const { lines, stage } = treeScene(preset.scene, root);
      const nodes = flatten([root]);
      lines.forEach(({ to, end: drawn }, i) => {
        const end = nodes[i]?.end;
        if (end?.end !== 'hit' || drawn !== 'hit') return;
        hits++;
        const off = Math.hypot(...to.map((x, k) => x - (end.point[k] ?? 0)));
        expect(off, id).toBeLessThan(1e-9 * stage.radius);
      });
    }
    expect(hits).toBeGreaterThan(200);
  });
});
