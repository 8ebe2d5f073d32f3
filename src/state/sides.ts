import type { Intersection } from '../math/index.ts';
import type { Sign } from '../math/shapes.ts';

/** Where each hit is as seen from E: −1 behind it, 0 at E itself, 1 ahead. */
export function sidesOf(found: Intersection): readonly Sign[] {
  return found.hits.map(({ t }, i) => (t === 0 ? (exactSides(found)[i] ?? 0) : signOf(t)));
}

/** The same for the point where the plane is met, in the figure or not. */
export function sideOfPlane({ details }: Intersection): Sign {
  if (details.family !== 'flat' || !details.plane) return 0;
  const { offset, rate } = details.signs;
  const { t } = details.plane;
  return t === 0 ? product(offset, rate, -1) : signOf(t);
}

/** Signs of the roots from those of the coefficients: a root that rounds to 0 need not be 0. */
function exactSides(found: Intersection): readonly Sign[] {
  const { details } = found;
  if (details.family === 'flat') return [sideOfPlane(found)];
  const { A, B, C } = details.signs;
  if (found.class === 'one') return [product(B, C, -1)];
  const middle = product(A, B, -1);
  if (found.class !== 'two') return [middle];
  const both = product(A, C, 1);
  if (both !== 0) return both < 0 ? [-1, 1] : [middle, middle];
  return middle < 0 ? [-1, 0] : [0, middle];
}

const signOf = (x: number): Sign => (x > 0 ? 1 : x < 0 ? -1 : 0);

/** An unknown sign (null) counts as 0. */
const product = (a: Sign | null, b: Sign | null, factor: 1 | -1): Sign =>
  signOf((a ?? 0) * (b ?? 0) * factor);
