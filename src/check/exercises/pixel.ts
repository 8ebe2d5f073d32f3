import {
  comp,
  type Expr,
  type ExprTriple,
  evaluateTriple,
  float64,
  minus,
  num,
  over,
  plus,
  scalar,
  times,
  type Values,
} from '../../math/formula.ts';
import { SHAPES, type Vec3 } from '../../math/index.ts';
import { integer, pick } from '../../math/rng.ts';
import type { Axis } from '../../math/shapes.ts';
import { display, displayTriple } from '../../text/format.ts';
import { directionField } from '../types.ts';
import type { Draft, Exercise, Pixel } from './define.ts';
import { drawShape } from './draw.ts';

const half = over(num(1), num(2));
const [i, j, n, m, w] = ['i', 'j', 'n', 'm', 'w'].map(scalar) as [Expr, Expr, Expr, Expr, Expr];

/** How far the pixel's middle is from the picture's: to the right, and upwards. */
const ACROSS = times(w, minus(plus(i, half), over(n, num(2))));
const UPWARDS = times(w, minus(over(m, num(2)), plus(j, half)));

/** d = M + w (i + 1/2 − n/2) R + w (m/2 − (j + 1/2)) U − E, as the tracer's camera has it. */
const along = (axis: Axis): Expr => ({
  op: 'sum',
  terms: [
    { sign: 1, expr: comp('M', axis) },
    { sign: 1, expr: times(ACROSS, comp('R', axis)) },
    { sign: 1, expr: times(UPWARDS, comp('U', axis)) },
    { sign: -1, expr: comp('E', axis) },
  ],
});
const PIXEL: ExprTriple = [along('x'), along('y'), along('z')];

function valuesOf({ column, row, columns, rows, side, ...at }: Pixel, E: Vec3): Values<number> {
  return {
    scalars: { i: column, j: row, n: columns, m: rows, w: side },
    vectors: { M: at.middle, R: at.right, U: at.up, E },
  };
}

/** Where cameras on paper look: along an axis that lies level. */
const LOOKS: readonly [{ ahead: Vec3; right: Vec3 }, ...{ ahead: Vec3; right: Vec3 }[]] = [
  { ahead: [0, 0, -1], right: [1, 0, 0] },
  { ahead: [0, 0, 1], right: [-1, 0, 0] },
  { ahead: [1, 0, 0], right: [0, 0, 1] },
  { ahead: [-1, 0, 0], right: [0, 0, -1] },
];

const plusVec = (a: Vec3, b: Vec3, k: number): Vec3 => [
  a[0] + k * b[0],
  a[1] + k * b[1],
  a[2] + k * b[2],
];

const EVEN = [4, 6, 8] as const;
const ODD = [3, 5, 7] as const;

const wordsOf = ({ ray, pixel }: Draft) => {
  if (!pixel) return null;
  const { column, row, columns, rows, side, middle, right, up } = pixel;
  const x = side * (column + 0.5 - columns / 2);
  const y = side * (rows / 2 - row - 0.5);
  const point = plusVec(plusVec(middle, right, x), up, y);
  return { point, x, y, d: plusVec(point, ray.origin, -1) };
};

export const pixel: Exercise = {
  id: 'pixel',
  topic: 'the ray through a pixel',
  subject: 'camera',
  picture: 'pixels',
  hidden: 'all but E',
  paper: true,
  kinds: SHAPES.map(({ kind }) => kind),
  draw(random, kind, level) {
    const look = level === 1 ? LOOKS[0] : pick(random, LOOKS);
    // With halves only odd counts, so that all numbers stay halves.
    const side = pick(random, [1, 1, level === 3 ? 0.5 : 2]);
    const count = (): number => pick(random, side === 0.5 || random() < 0.5 ? ODD : EVEN);
    const [columns, rows] = [count(), count()];
    const size = 1 + level;
    const origin: Vec3 = [
      integer(random, -size, size),
      integer(random, -size, size),
      integer(random, -size, size),
    ];
    const middle = plusVec(origin, look.ahead, integer(random, 2, 5));
    const drawn: Pixel = {
      ...{ columns, rows, side, middle, right: look.right, up: [0, 1, 0] },
      column: integer(random, 0, columns - 1),
      row: integer(random, 0, rows - 1),
    };
    const direction = evaluateTriple(PIXEL, float64, valuesOf(drawn, origin));
    return {
      shape: drawShape(random, kind, 1),
      ray: { origin, direction: [direction[0], direction[1], direction[2]] },
      pixel: drawn,
      watch: ['pixel-corner', 'pixel-rows', 'pixel-exchanged', 'pixel-point', 'pixel-turned'],
    };
  },
  ask: ({ pixel: at }) =>
    `A camera stands at E. Through the middle of the pixel in column i = ${at?.column} and row ` +
    `j = ${at?.row} goes the ray R(t) = E + t d. Find d; its length does not matter.`,
  given: [],
  told: ({ pixel: at }) =>
    at
      ? [
          {
            name: 'picture',
            says:
              `n = ${at.columns} columns, counted from 0 at the left, and m = ${at.rows} rows, ` +
              `from 0 at the top; pixels of side w = ${display(at.side)}`,
          },
          { name: 'its middle', says: `M = ${displayTriple(at.middle)}` },
          {
            name: 'its directions',
            says: `to the right ${displayTriple(at.right)}, up ${displayTriple(at.up)}`,
          },
        ]
      : [],
  described: ({ pixel: at }) =>
    `A picture of ${at?.columns} columns and ${at?.rows} rows; the pixel in column ` +
    `${at?.column} and row ${at?.row}, counted from the top left, is marked.`,
  extend: (course) => ({ ...course, pixel: PIXEL }),
  fields: () => [directionField('d')],
  answers(course, draft) {
    if (!draft.pixel || !course.pixel) return {};
    const { ray } = draft;
    const [x, y, z] = evaluateTriple(course.pixel, float64, valuesOf(draft.pixel, ray.origin));
    return { d: [x, y, z] };
  },
  argue(draft) {
    const found = wordsOf(draft);
    const { pixel: at, ray } = draft;
    if (!found || !at) return { rule: '', put: '', decision: [] };
    const { side, column, row, columns, rows } = at;
    const [a, b] = [
      `${display(side)} · (${column} + 1/2 − ${columns}/2)`,
      `${display(side)} · (${rows}/2 − (${row} + 1/2))`,
    ];
    return {
      rule:
        'From M the pixel’s middle is w (i + 1/2 − n/2) to the right and w (m/2 − (j + 1/2)) up. ' +
        'd is that point minus E.',
      put: `How far are ${a} to the right of M and ${b} up, and which point is that?`,
      decision: [
        `To the right ${a} = ${display(found.x)}, up ${b} = ${display(found.y)}.`,
        `The pixel’s middle is ${displayTriple(found.point)}.`,
        `d = ${displayTriple(found.point)} − ${displayTriple(ray.origin)} = ` +
          `${displayTriple(found.d)}.`,
      ],
    };
  },
  clue: 'The ray starts at E and goes through the middle of the pixel: which point is that?',
  lines: [],
};
