import type { Reference } from '../../lab/reference.ts';
import { sub, toNumber } from '../../math/exact.ts';
import type { Ray, Shape } from '../../math/index.ts';
import { definitionOf } from '../../math/shapes.ts';
import { display } from '../../text/format.ts';

/** What is asked of every method: the shape, how far E is from it, and what is exactly true. */
export function rayWords(shape: Shape, ray: Ray, reference: Reference): string {
  const definition = definitionOf(shape);
  const { at } = definition.anchor(shape);
  const far = Math.hypot(...ray.origin.map((x, i) => x - (at[i] ?? 0)));
  return `The ${definition.title} of Explore, with E ${display(far, 4)} away. ${truth(reference)}`;
}

function truth({ found, hits }: Reference): string {
  const [first, second] = hits;
  switch (found.class) {
    case 'two':
      return first && second
        ? `It has two points, ${display(toNumber(sub(second.t, first.t)), 3)} lengths of d apart.`
        : 'It has two points.';
    case 'tangent':
      return 'It touches in exactly one point.';
    case 'one':
      return 'It has one point.';
    case 'contained':
      return 'The whole line lies in it: there is no single root to find.';
    default:
      return 'The line has no point of it: a verdict is all that there is to get right.';
  }
}
