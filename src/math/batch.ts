/** Door: many rays at once, as structures of arrays. */
export {
  type Answers,
  createAnswers,
  createRays,
  type Kernel,
  NONE,
  packRays,
  type Rays,
  verdictsOfClasses,
  verdictsOfRoots,
} from './batch/batch.ts';
export { batchOf, targetOf } from './batch/kernels.ts';
export { kernelArray } from './batch/memory.ts';
export { type Quadric, quadricOf } from './batch/quadric.ts';
export type { Target } from './batch/target.ts';
export { isFast } from './methods/certified/kernel.ts';
