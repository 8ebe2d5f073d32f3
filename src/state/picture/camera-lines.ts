import {
  type Expr,
  type ExprTriple,
  evaluate,
  float64,
  inNumbers,
  inSymbols,
  type Marks,
  mapped,
  numberPiece,
  type Values,
} from '../../math/formula.ts';
import {
  across,
  cameraNumbers,
  DIRECTION,
  DISTANCE,
  isSteep,
  PIXEL_DISTANCE,
  pixelNumbers,
  RIGHT,
  SIDE,
  STEEP_SIDE,
  TO_PIXEL,
  TO_TARGET,
  UP,
  UPRIGHT,
  upwards,
  VIEW_DIRECTION,
} from '../../scene/camera-ray.ts';
import type { Camera } from '../../scene/types.ts';
import { display } from '../../text/format.ts';
import { type ExportLine, equation, number } from '../exports/line.ts';
import { type PutIn, putInSideBySide, valuesAsResults } from '../put-in.ts';

/** A pixel, and which of its rays. */
export interface PixelRay {
  readonly camera: Camera;
  readonly width: number;
  readonly height: number;
  readonly pixel: readonly [x: number, y: number];
  readonly sample: number;
  readonly samples: number;
}

/** One line of the derivation of a pixel's ray. */
export interface CameraLine {
  /** The symbol that it gives a value. */
  readonly id: string;
  /** Of the pixel's ray alone, or the same for all pixels. */
  readonly of: 'camera' | 'pixel';
  readonly why: string;
  /** A component each, or one number; null for h, whose tangent no tree has. */
  readonly exprs: readonly Expr[] | null;
  /** Whether each component is the same formula, which is written once, with vectors. */
  readonly alike: boolean;
  readonly values: readonly number[];
}

export interface CameraSteps {
  readonly numbers: Values<number>;
  readonly lines: readonly CameraLine[];
}

/** From eye, target, angle and pixel to E and d, with the numbers of the ray that is traced. */
export function cameraSteps(ray: PixelRay): CameraSteps {
  const { camera, width, height, pixel, sample, samples } = ray;
  const numbers = pixelNumbers(cameraNumbers(camera, width, height), pixel, sample, samples);
  const { n = 1 } = numbers.scalars;
  const alone = n === 1;
  const steep = isSteep(numbers);
  const line = (of: CameraLine['of'], id: string, exprs: ExprTriple | Expr | null, why: string) => {
    const vector = Array.isArray(exprs);
    const values = vector ? numbers.vectors[id] : [numbers.scalars[id] ?? Number.NaN];
    const trees = exprs === null ? null : vector ? exprs : [exprs as Expr];
    const alike = vector && exprs !== SIDE && exprs !== STEEP_SIDE && exprs !== UPRIGHT;
    return { id, of, why, exprs: trees, alike, values: values ?? [] };
  };
  const share = alone
    ? 'half a pixel more is its middle'
    : `the ray is in the middle of its share of the pixel, one of ${n} across and ${n} down`;
  return {
    numbers,
    lines: [
      line('camera', 'F', TO_TARGET, 'From the eye E to the target T.'),
      line('camera', 'λ', DISTANCE, 'The distance to the target.'),
      line('camera', 'g', VIEW_DIRECTION, 'The direction of view, with length 1.'),
      line(
        'camera',
        's',
        steep ? STEEP_SIDE : SIDE,
        steep
          ? 'The view is straight up or down: to the right is along x.'
          : 'To the right: level, at right angles to g, with length 1.',
      ),
      line('camera', 'w', UPRIGHT, 's × g, at right angles to both: towards the picture’s top.'),
      line(
        'camera',
        'h',
        null,
        'Half the picture’s height at distance 1: opposite over adjacent, for half the angle.',
      ),
      line('camera', 'R', RIGHT, 'Half its width, to the right: pixels are square.'),
      line('camera', 'U', UP, 'Half its height, towards the top.'),
      line(
        'pixel',
        'u',
        across(alone),
        `x counts pixels from the left, and ${share}; u goes from −1 to 1.`,
      ),
      line('pixel', 'v', upwards(alone), 'y counts from the top: there v is 1, at the bottom −1.'),
      line('pixel', 'D', TO_PIXEL, 'From the eye to the ray’s point of the picture at distance 1.'),
      line('pixel', 'μ', PIXEL_DISTANCE, 'How far that is.'),
      line('pixel', 'd', DIRECTION, 'The same direction with length 1, so that t is a length.'),
    ],
  };
}

/** What is given: E and T, the angle, the picture's size, the pixel and its ray's place in it. */
export const givenOf = (
  of: CameraLine['of'],
  { numbers: { scalars } }: CameraSteps,
): readonly string[] =>
  of === 'camera'
    ? ['E', 'T', 'α', 'W', 'H']
    : scalars.n === 1
      ? ['x', 'y']
      : ['x', 'y', 'i', 'j', 'n'];

/** A line as written: the symbol that it defines, its formula, and its numbers. */
interface WrittenLine<M> {
  readonly letter: M;
  readonly symbols: M;
  /**
   * Pieces between which a line may be broken; of `isTriple` one a component. Null where a number
   * is not finite, or there is nothing to put in.
   */
  readonly numbers: readonly M[] | null;
  readonly isTriple: boolean;
  /** Whether the numbers as written give the value as written. */
  readonly isFaithful: boolean;
}

/** Writes a formula with its numbers, in pieces between which a line may be broken. */
type InPieces<M> = (expr: Expr, values: Values<number>, digits: number, marks: Marks<M>) => M[];

export function writeLine<M>(
  { id, exprs, alike, values }: CameraLine,
  { numbers }: CameraSteps,
  marks: Marks<M>,
  inPieces: InPieces<M> = inOne,
): WrittenLine<M> {
  const letter = symbolOf(id, numbers, marks);
  if (exprs === null) return { letter, ...tangent(numbers, marks) };
  const put = digitsOf(exprs, values, numbers);
  const digits = put?.digits ?? 6;
  const vectors = inVectors(marks, numbers, digits);
  const [first] = exprs as readonly [Expr];
  const symbols = alike
    ? inSymbols(first, vectors.symbols)
    : listed(
        exprs.map((expr) => inSymbols(expr, marks)),
        marks,
      );
  const isTriple = !alike && exprs.length > 1;
  const written = alike
    ? inPieces(first, { ...numbers, vectors: {} }, digits, vectors.numbers)
    : isTriple
      ? exprs.flatMap((expr) => inOne(expr, numbers, digits, marks))
      : inPieces(first, numbers, digits, marks);
  const isGiven = exprs.every(({ op }) => op === 'number');
  return {
    letter,
    symbols,
    numbers: put === null || isGiven ? null : written,
    isTriple,
    isFaithful: put?.isFaithful ?? true,
  };
}

function inOne<M>(expr: Expr, values: Values<number>, digits: number, marks: Marks<M>): M[] {
  return [inNumbers(expr, marks, values, { worked: false, digits })];
}

/** Digits of the numbers put in; a square root is no ratio, so its line is judged in doubles. */
function digitsOf(
  exprs: readonly Expr[],
  values: readonly number[],
  numbers: Values<number>,
): PutIn | null {
  const sides = exprs.map((expr, k) => ({
    expr,
    results: valuesAsResults([values[k] ?? Number.NaN], undefined),
  }));
  const put = putInSideBySide(sides, numbers, false);
  if (put === null || put.isFaithful) return put;
  const gives = (digits: number): boolean => {
    const shown = mapped(numbers, (x) => Number(x.toPrecision(digits)));
    return exprs.every(
      (expr, k) => display(evaluate(expr, float64, shown)) === display(values[k] ?? Number.NaN),
    );
  };
  const digits = [6, 7, 8, 10, 12, 15, 17].find(gives);
  return digits === undefined ? put : { digits, isFaithful: true };
}

/** A component's formula with its vectors in place of their components. */
function inVectors<M>(marks: Marks<M>, { vectors }: Values<number>, digits: number) {
  const put = (id: string): M =>
    listed(
      (vectors[id] ?? []).map((x) => numberPiece(x, marks, digits).m),
      marks,
    );
  return {
    symbols: { ...marks, component: (id: string): M => marks.symbol(id, 'vector') },
    numbers: { ...marks, component: (id: string): M => marks.put(put(id), id, 'vector') },
  };
}

/** One as it is, three as (a, b, c). */
const listed = <M>(parts: readonly M[], marks: Marks<M>): M =>
  parts.length === 1
    ? (parts[0] as M)
    : marks.parens(marks.join(parts.flatMap((m, i) => (i > 0 ? [marks.operator(','), m] : [m]))));

export const symbolOf = <M>(id: string, { vectors }: Values<number>, marks: Marks<M>): M =>
  marks.symbol(id, vectors[id] ? 'vector' : 'scalar');

/** h = tan(α/2) = tan(34°/2) */
function tangent<M>(
  { scalars: { α = Number.NaN } }: Values<number>,
  marks: Marks<M>,
): Omit<WrittenLine<M>, 'letter'> {
  const of = (m: M): M =>
    marks.join([
      marks.symbol('tan', 'scalar'),
      marks.parens(marks.fraction(m, marks.numeral('2'))),
    ]);
  return {
    symbols: of(marks.symbol('α', 'scalar')),
    numbers: [of(marks.put(degrees(α, marks), 'α', 'scalar'))],
    isTriple: false,
    isFaithful: true,
  };
}

const degrees = <M>(angle: number, marks: Marks<M>): M =>
  marks.join([number(angle, marks), marks.symbol('°', 'scalar')]);

/** What is given, as 'E = (1, 3, 9)'; the angle in degrees. */
export function givenPiece<M>(id: string, { numbers }: CameraSteps, marks: Marks<M>): M {
  const vector = numbers.vectors[id];
  const x = numbers.scalars[id] ?? Number.NaN;
  if (id === 'α') return degrees(x, marks);
  return vector
    ? listed(
        vector.map((part) => number(part, marks)),
        marks,
      )
    : number(x, marks);
}

/** All of it as lines to copy, in the same digits as on the page. */
export function cameraLines<M>(ray: PixelRay, marks: Marks<M>): readonly ExportLine<M>[] {
  const steps = cameraSteps(ray);
  return (['camera', 'pixel'] as const).flatMap((of) => [
    ...givenOf(of, steps).map((id) =>
      equation(symbolOf(id, steps.numbers, marks), givenPiece(id, steps, marks)),
    ),
    ...steps.lines.flatMap((line): ExportLine<M>[] => {
      if (line.of !== of) return [];
      const { letter, symbols, numbers, isTriple, isFaithful } = writeLine(line, steps, marks);
      const value = listed(
        line.values.map((x) => number(x, marks)),
        marks,
      );
      const sign = isFaithful ? '=' : '≈';
      const written = numbers && (isTriple ? listed(numbers, marks) : marks.join(numbers));
      const right = written === null ? value : marks.join([written, marks.operator(sign), value]);
      return [equation(letter, symbols), { left: null, relation: '=', right, words: '' }];
    }),
  ]);
}
