import { afterEach, describe, expect, test, vi } from 'vitest';
import type { LabReply } from '../../../src/lab/messages.ts';
import { twoScales } from '../../../src/scene/presets/two-scales.ts';
import { DEFAULT_SETTINGS } from '../../../src/tracer/types.ts';
import type { FromTraceWorker, ToTraceWorker } from '../../../src/workers/protocol.ts';

/*
 * The workers as they are, with what they say caught: the buffer of the kernels' memory must not be
 * in it. Transferring it throws, and copying one array of it copies the whole memory.
 */

afterEach(() => {
  vi.unstubAllGlobals();
});

interface Post {
  readonly message: unknown;
  readonly transfer: readonly unknown[];
}

/** Starts a worker's module; `send` calls its listener, `posts` is what it says. */
async function worker<To>(load: () => Promise<unknown>) {
  const posts: Post[] = [];
  let listen: (event: { readonly data: To }) => void = () => {};
  const scope = {
    addEventListener: (_: string, heard: typeof listen) => {
      listen = heard;
    },
    postMessage: (message: unknown, options?: { readonly transfer?: readonly unknown[] }) => {
      posts.push({ message, transfer: options?.transfer ?? [] });
    },
  };
  vi.stubGlobal('self', scope);
  // Without locks, as in a file that is opened from disk.
  vi.stubGlobal('navigator', {});
  vi.stubGlobal('addEventListener', scope.addEventListener);
  vi.stubGlobal('postMessage', scope.postMessage);
  vi.resetModules();
  await load();
  return { posts, send: (data: To): void => listen({ data }) };
}

/** All buffers that structured cloning would meet. */
function buffersIn(value: unknown, seen = new Set<unknown>()): ArrayBuffer[] {
  if (typeof value !== 'object' || value === null || seen.has(value)) return [];
  seen.add(value);
  if (value instanceof ArrayBuffer) return [value];
  if (ArrayBuffer.isView(value)) return [value.buffer as ArrayBuffer];
  return Object.values(value).flatMap((part) => buffersIn(part, seen));
}

/** The kernels' memory of the modules that are loaded now. */
async function memory(): Promise<ArrayBufferLike> {
  const { kernelArray } = await import('../../../src/math/batch/memory.ts');
  const { buffer } = kernelArray(1);
  expect(buffer.byteLength).toBeGreaterThan(2 ** 20);
  return buffer;
}

async function expectOwn(posts: readonly Post[]): Promise<number> {
  const shared = await memory();
  let buffers = 0;
  for (const { message, transfer } of posts) {
    const all = [...buffersIn(message), ...buffersIn(transfer)];
    expect(all.filter((buffer) => buffer === shared).length).toBe(0);
    buffers += all.length;
    expect(() => structuredClone(message, { transfer: transfer as Transferable[] })).not.toThrow();
  }
  return buffers;
}

/** Of the wait for a worker's replies: a machine may be busy. The default is a second. */
const PATIENCE = { timeout: 50_000 };

describe('what a worker says has arrays of its own', () => {
  test('pictures and trees of rays', async () => {
    const { posts, send } = await worker<ToTraceWorker>(
      () => import('../../../src/workers/trace.ts'),
    );
    const settings = { ...DEFAULT_SETTINGS, width: 48, height: 32, method: 'certified' as const };
    send({ type: 'scene', job: 1, scene: twoScales.scene, settings });
    send({ type: 'tile', job: 1, tile: { y0: 0, y1: 32, step: 1, refines: false } });
    send({ type: 'record', job: 1, x: 20, y: 16 });
    await vi.waitFor(() => expect(posts).toHaveLength(3), PATIENCE);
    const said = posts.map(({ message }) => message as FromTraceWorker);
    expect(said.map(({ type }) => type).sort()).toEqual(['ready', 'tile', 'tree']);
    expect(await expectOwn(posts)).toBeGreaterThanOrEqual(6);
  });

  test('what the laboratory finds', async () => {
    const { posts, send } = await worker(() => import('../../../src/workers/lab.ts'));
    const sample = { family: 'near-tangent', seed: 191, shapes: 2, count: 40 };
    send({
      type: 'measure',
      request: {
        ...sample,
        timed: 40,
        order: 'random',
        budget: { least: 64, most: 1e9 },
        plan: { rounds: 1, least: 1, steps: 1, warmUp: 1 },
      },
    });
    send({ type: 'sweep', request: { ...sample, points: 2 } });
    await vi.waitFor(() => {
      const said = posts.map(({ message }) => (message as LabReply).type);
      expect(said.filter((type) => type === 'done')).toHaveLength(2);
      expect(new Set(said)).toEqual(new Set(['measured', 'swept', 'done']));
    }, PATIENCE);
    await expectOwn(posts);
  });
});
