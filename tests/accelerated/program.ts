import { accelerate, whyNotAccelerated } from '../../src/math/accelerate.ts';
import { batchOf, createAnswers, kernelArray, packRays } from '../../src/math/batch.ts';
import { METHODS } from '../../src/math/index.ts';

/* What a program finds that has the math module in its bundle. */

const SPHERE = { kind: 'sphere', center: [0, 0, 0], radius: 2 } as const;
const RAYS = Array.from({ length: 40 }, (_, k) => ({
  origin: [5, k / 16, 0] as const,
  direction: [-1, 0, 0.125] as const,
}));

/** What `accelerate` said. */
export interface Told {
  readonly isFast: boolean;
  readonly why: string | null;
  /** Whether every method finds roots, and the same ones before and after. */
  readonly isFound: boolean;
  readonly isSame: boolean;
  /** Whether answers lie in the memory of WebAssembly. */
  readonly isInMemory: boolean;
}

function roots(): number[][] {
  const rays = packRays(RAYS, kernelArray);
  return METHODS.map((method) => {
    const out = createAnswers(RAYS.length, kernelArray);
    batchOf(method, SPHERE).both(rays, out);
    return [...out.t0, ...out.t1];
  });
}

/** Asks for the same roots before and after. */
export function told(): Told {
  const before = roots();
  const isFast = accelerate();
  const after = roots();
  return {
    isFast,
    why: whyNotAccelerated(),
    isSame: JSON.stringify(before) === JSON.stringify(after),
    isFound: after.every((found) => found.some((t) => t > 0)),
    isInMemory: kernelArray(1).buffer.byteLength > 2 ** 20,
  };
}
