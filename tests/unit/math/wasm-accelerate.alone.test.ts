import { afterEach, describe, expect, test, vi } from 'vitest';
import { FAMILIES } from '../../../src/math/families.ts';
import { seeded } from '../../../src/math/rng.ts';

/*
 * accelerate() where there is WebAssembly, where there is none, and undone. Each test has the
 * modules for itself: what accelerate finds it keeps.
 */

afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

async function fresh() {
  vi.resetModules();
  const { accelerate, decelerate, whyNotAccelerated } = await import(
    '../../../src/math/accelerate.ts'
  );
  const batch = await import('../../../src/math/batch/batch.ts');
  const { batchOf } = await import('../../../src/math/batch/kernels.ts');
  const { kernelArray } = await import('../../../src/math/batch/memory.ts');
  const { certified } = await import('../../../src/math/methods/certified.ts');
  const { shape, rays } = (FAMILIES()[0] as ReturnType<typeof FAMILIES>[number]).batch(
    seeded(181),
    300,
  );
  const roots = () => {
    const out = batch.createAnswers(rays.length, kernelArray);
    batchOf(certified, shape).both(batch.packRays(rays, kernelArray), out);
    return { out, roots: [...out.t0, ...out.t1] };
  };
  return { accelerate, decelerate, whyNotAccelerated, roots };
}

const pagesOfMemory = (array: Float64Array): number => array.buffer.byteLength / 65536;

describe('where WebAssembly is to be had', () => {
  test('answers lie in its memory, and it is made once', async () => {
    const compiled = vi.spyOn(WebAssembly, 'Module');
    const { accelerate, decelerate, roots } = await fresh();
    expect(compiled).not.toHaveBeenCalled();
    const before = roots();
    expect(accelerate()).toBe(true);
    expect(accelerate()).toBe(true);
    const fast = roots();
    expect(fast.roots).toEqual(before.roots);
    expect(pagesOfMemory(fast.out.t0)).toBeGreaterThan(100);
    decelerate();
    const after = roots();
    expect(after.roots).toEqual(before.roots);
    expect(pagesOfMemory(after.out.t0)).toBeLessThan(1);
    expect(accelerate()).toBe(true);
    expect(roots().out.t0.buffer).toBe(fast.out.t0.buffer);
    expect(compiled).toHaveBeenCalledTimes(1);
    compiled.mockRestore();
  });

  test('decelerated, no kernel runs: TypeScript answers what lies in their memory', async () => {
    const { accelerate, decelerate, roots } = await fresh();
    const views = vi.spyOn(Float64Array.prototype, 'set');
    accelerate();
    roots();
    expect(views).toHaveBeenCalled();
    views.mockClear();
    decelerate();
    roots();
    expect(views).not.toHaveBeenCalled();
    views.mockRestore();
  });
});

describe('where it is not', () => {
  const reasons: [string, () => void, RegExp][] = [
    [
      'there is none',
      () => vi.stubGlobal('WebAssembly', undefined),
      /^This engine has no WebAssembly\.$/,
    ],
    ['it has no vectors', withoutVectors, /^The WebAssembly of this engine has no SIMD\.$/],
    [
      'it is forbidden',
      () => refuse(new WebAssembly.CompileError('a policy')),
      /^WebAssembly is not allowed here: a policy$/,
    ],
    [
      'it is forbidden in the words of another engine',
      () => refuse(new EvalError('unsafe')),
      /^WebAssembly is not allowed here: unsafe$/,
    ],
    [
      'there is no room for its memory',
      () => refuse(new RangeError('out of memory')),
      /^There is no room for the memory of WebAssembly: out of memory$/,
    ],
  ];
  test.each(reasons)(
    '%s: accelerate says so, and all stays as it was',
    async (_, forbid, reason) => {
      const { accelerate, decelerate, whyNotAccelerated, roots } = await fresh();
      const before = roots();
      forbid();
      expect(accelerate()).toBe(false);
      expect(accelerate()).toBe(false);
      expect(whyNotAccelerated()).toMatch(reason);
      const after = roots();
      expect(after.roots).toEqual(before.roots);
      expect(after.out.t0.buffer.byteLength).toBe(8 * 300);
      decelerate();
      expect(roots().roots).toEqual(before.roots);
    },
  );
});

const withoutVectors = (): void => {
  vi.spyOn(WebAssembly, 'validate').mockReturnValue(false);
};

function refuse(error: Error): void {
  vi.stubGlobal(
    'WebAssembly',
    new Proxy(WebAssembly, {
      get: (all, key) =>
        key === 'Module'
          ? class {
              constructor() {
                throw error;
              }
            }
          : Reflect.get(all, key),
    }),
  );
}
