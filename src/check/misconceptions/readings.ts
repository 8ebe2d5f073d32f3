import type { Expr, ExprTriple } from '../../math/formula.ts';
import { negative, num, over, scalar, times } from '../../math/formula.ts';
import type { Course } from '../course.ts';
import { rewrite } from '../rewrite.ts';
import type { Misconception } from './define.ts';

/*
 * Mistakes in what only some exercises ask for: a pixel's ray, the graph of f, the ends of a shape,
 * the hits of two shapes. They cannot be made in a course without these lines.
 */

type About = Omit<Misconception, 'edit'>;

/** A mistake in a line or decision that the course may have; null if it is none or the same. */
const ofExtra = <K extends 'pixel' | 'read' | 'ends' | 'meetings'>(
  about: About,
  key: K,
  edit: (right: NonNullable<Course[K]>) => Course[K] | null,
): Misconception => ({
  ...about,
  edit(course) {
    const right = course[key];
    const edited = right === undefined ? null : edit(right as NonNullable<Course[K]>);
    return edited === null || edited === right ? null : { ...course, [key]: edited };
  },
});

const inEach = ([x, y, z]: ExprTriple, edit: (e: Expr) => Expr): ExprTriple => [
  edit(x),
  edit(y),
  edit(z),
];

const isHalf = (e: Expr): boolean =>
  e.op === 'quotient' && e.over.op === 'number' && e.over.value === 1;

const pixelCorner = ofExtra(
  {
    id: 'pixel-corner',
    says: 'the pixel’s corner in place of its middle',
    line: 'd',
    remedy: 'A pixel is as wide as from i to i + 1: its middle is at i + 1/2, and at j + 1/2.',
  },
  'pixel',
  (d) => inEach(d, (e) => rewrite(e, (part) => (isHalf(part) ? num(0) : null))),
);

const pixelRows = ofExtra(
  {
    id: 'pixel-rows',
    says: 'rows counted upwards',
    line: 'd',
    remedy: 'Row 0 is at the top: with larger j the pixel lies lower.',
  },
  'pixel',
  (d) =>
    inEach(d, (e) =>
      rewrite(e, (part) =>
        part.op === 'product' && part.factors.some((f) => f.op === 'component' && f.vector === 'U')
          ? negative(part)
          : null,
      ),
    ),
);

const pixelExchanged = ofExtra(
  {
    id: 'pixel-exchanged',
    says: 'column and row exchanged',
    line: 'd',
    remedy: 'The column i counts to the right, the row j downwards.',
  },
  'pixel',
  (d) =>
    inEach(d, (e) =>
      rewrite(e, (part) =>
        part.op === 'scalar' && /^[ij]$/.test(part.id) ? scalar(part.id === 'i' ? 'j' : 'i') : null,
      ),
    ),
);

const pixelPoint = ofExtra(
  {
    id: 'pixel-point',
    says: 'the pixel’s point in place of the way from E to it',
    line: 'd',
    remedy: 'd leads from E to the pixel: subtract E from its point.',
  },
  'pixel',
  (d) =>
    inEach(d, (e) =>
      e.op === 'sum' ? { ...e, terms: e.terms.filter(({ expr }) => !isOfE(expr)) } : e,
    ),
);

const isOfE = (e: Expr): boolean => e.op === 'component' && e.vector === 'E';

const pixelTurned = ofExtra(
  {
    id: 'pixel-turned',
    says: 'd from the pixel to E in place of from E to the pixel',
    line: 'd',
    remedy: 'The ray leaves E through the pixel: d is the pixel’s point minus E.',
  },
  'pixel',
  (d) => inEach(d, (e) => negative(e)),
);

const [A, F] = [scalar('A'), scalar('F')];

const readSign = ofExtra(
  {
    id: 'read-sign',
    says: '4 A F in place of −4 A F',
    line: 'D',
    remedy: 'F = −D/4A, with a minus sign: where A > 0, a graph that dips below 0 has D > 0.',
  },
  'read',
  (read) => rewrite(read, (e) => (e.op === 'negative' ? e.of : null)),
);

const readValue = ofExtra(
  {
    id: 'read-value',
    says: 'the lowest or highest value of f taken for D',
    line: 'D',
    remedy: 'Where f turns its value is −D/4A, not D.',
  },
  'read',
  () => F,
);

const readWithoutA = ofExtra(
  {
    id: 'read-no-a',
    says: '−4 F in place of −4 A F',
    line: 'D',
    remedy: 'F = −D/4A: solved for D, A is a factor.',
  },
  'read',
  () => negative(times(num(4), F)),
);

const readDistance = ofExtra(
  {
    id: 'read-distance',
    says: 'the square of the distance of the roots, −4 F/A, taken for D',
    line: 'D',
    remedy: 'The roots are √D/A apart: D is A² times the square of that.',
  },
  'read',
  () => negative(over(times(num(4), F), A)),
);

const endsByT = ofExtra(
  {
    id: 'ends-by-t',
    says: 't compared with the heights in place of y',
    line: 'P',
    remedy: 'The ends are heights: compare y of E + t d with them, not t.',
  },
  'ends',
  () => 't',
);

const endsForgotten = ofExtra(
  {
    id: 'ends-forgotten',
    says: 'the ends forgotten',
    line: 'P',
    remedy: 'The formula knows the whole surface only: each root’s height has to be looked at.',
  },
  'ends',
  () => 'forgotten',
);

const meetingsBySurface = ofExtra(
  {
    id: 'by-surface',
    says: 'all hits of one surface before those of the other',
    line: 'first',
    remedy: 'The ray may leave one surface after it has met the other: all t are put in one order.',
  },
  'meetings',
  () => 'by surface',
);

export const READINGS: readonly Misconception[] = [
  pixelCorner,
  pixelRows,
  pixelExchanged,
  pixelPoint,
  pixelTurned,
  readSign,
  readValue,
  readWithoutA,
  readDistance,
  endsByT,
  endsForgotten,
  meetingsBySurface,
];
