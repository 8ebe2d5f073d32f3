import type { Ray, Shape } from '../math/index.ts';
import type { Between } from './heights.ts';
import { INITIAL } from './state.ts';
import { encode } from './url.ts';

/** Values of a link to Explore besides shape and ray. */
interface ExploreLinkOptions {
  readonly between?: Between | null;
  readonly caps?: boolean;
  /** The start rule of a ray of a picture, as its link writes it. */
  readonly start?: string;
  /** The step of the derivation that is open there. */
  readonly derive?: number;
}

/** The link to Explore with a shape and a ray of another page: the same numbers, to the bit. */
export function exploreLink(
  shape: Shape,
  ray: Ray,
  method: string,
  { between = null, caps = false, start, derive }: ExploreLinkOptions = {},
): string {
  const { origin: E, direction: d } = ray;
  return encode({
    ...INITIAL,
    kind: shape.kind,
    shapes: { ...INITIAL.shapes, [shape.kind]: shape },
    ...{ E, d, method, between, caps },
    settings: { ...INITIAL.settings, explore: start === undefined ? {} : { start } },
    derive: derive ?? null,
  });
}
