import { inTypeScript, type Source, straightKernel } from '../../src/math/batch/straight.ts';
import { ASK, CLASS_BIT, type Loop } from '../../src/math/batch/straight-loop.ts';
import { createAnswers, type Rays } from '../../src/math/batch.ts';
import type { Shape } from '../../src/math/index.ts';
import type { Method } from '../../src/math/shapes.ts';

/*
 * Which rays a method's loops leave to the method itself, which asks about one at a time: where
 * they are many, a price is that of the leaving.
 */

/** What is told of a call: the rays that are left, and those whose class is listed. */
export type Tell = (left: number, listed: number) => void;

/** The loops of TypeScript; those of WebAssembly are made of the same programs. */
export function counting(tell: Tell): Source {
  const counted =
    (loop: Loop): Loop =>
    (numbers, rays, out, marked, roots) => {
      const count = loop(numbers, rays, out, marked, roots);
      const classes = Array.from(marked.subarray(0, count), (mark) => mark >>> CLASS_BIT);
      const left = classes.filter((place) => place === ASK).length;
      tell(left, count - left);
      return count;
    };
  return (method, kind) => {
    const loops = inTypeScript(method, kind);
    return loops && { both: counted(loops.both), classes: counted(loops.classes) };
  };
}

/** How many of the rays a method's loops leave; all where it has none. Null: it never has. */
export function leftBy(
  method: Method,
  batches: readonly { readonly shape: Shape; readonly rays: Rays }[],
): number | null {
  if (batches.every(({ shape }) => inTypeScript(method.id, shape.kind) === null)) return null;
  let sum = 0;
  for (const { shape, rays } of batches) {
    const source = counting((left) => {
      sum += left;
    });
    const kernel = straightKernel(method, shape, source);
    if (kernel) kernel.both(rays, createAnswers(rays.count));
    else sum += rays.count;
  }
  return sum;
}
