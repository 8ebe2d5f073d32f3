import type { Surd } from '../math/exact.ts';
import {
  type Arithmetic,
  comp,
  type Expr,
  evaluate,
  exact,
  negative,
  num,
  over,
  root,
  scalar,
  squared,
  type Triple,
  type Values,
} from '../math/formula.ts';
import { AXES } from '../math/shapes.ts';
import { MOST_DIGITS, trustedDigits } from './digits.ts';
import { keyOf, productOf, sumOf } from './flat-trees.ts';

/** A number in a traced formula: the method's value, the exact one, and the formula so far. */
export interface Traced<T> {
  readonly own: T;
  /** Null if there is no exact value: the root of a negative number, a quotient by zero. */
  readonly exact: Surd | null;
  /** The formula in the course's symbols; results that have a letter appear as that letter. */
  readonly expr: Expr;
}

/** One operation of a method. */
export interface Operation {
  readonly expr: Expr;
  /** The course's letter for the result: A, B, C, D, q, …; null without one. */
  readonly letter: Expr | null;
  /** The method's result as the nearest double. */
  readonly own: number;
  readonly exact: Surd | null;
  /** −1, 0, 1, or NaN if the method does not know the sign. */
  readonly sign: number;
  /** Right digits of the result, 0 … 15.95; null without an exact number. */
  readonly digits: number | null;
  /** The operations whose results it uses. */
  readonly inputs: readonly Operation[];
}

export interface Trace<T> {
  readonly arithmetic: Arithmetic<Traced<T>>;
  /** The numbers of ray and shape as traced values; they are appended to `inputs`. */
  symbols(values: Values<number>): Values<Traced<T>>;
  /** A letter without a number of its own, to name trees with. */
  placeholder(letter: Expr): Traced<T>;
  /** Gives a letter to results of operations that this tree describes. */
  name(letter: Expr, tree: Expr, values: Values<Traced<T>>, branch?: 1 | -1): void;
  readonly inputs: readonly Operation[];
  readonly operations: readonly Operation[];
}

/**
 * An arithmetic that does every operation in the method's own numbers and exactly, and records it.
 * A method's form and solver run in it unchanged, so that the record is what the method does. Signs
 * are the method's own: the trace takes its branches, right or wrong.
 */
export function traceIn<T>(own: Arithmetic<T>): Trace<T> {
  const inputs: Operation[] = [];
  const operations: Operation[] = [];
  const notes = new Map<Traced<T>, Operation>();
  const letters = new Map<string, Expr>();

  const digitsOf = (mine: number, truth: Surd | null): number | null =>
    truth === null ? null : own.id === exact.id ? MOST_DIGITS : trustedDigits(mine, truth);

  function note(x: Traced<T>, letter: Expr | null, from: readonly Traced<T>[]): Traced<T> {
    const mine = own.toNumber(x.own);
    const operation: Operation = {
      expr: x.expr,
      letter,
      own: mine,
      exact: x.exact,
      sign: own.sign(x.own),
      digits: digitsOf(mine, x.exact),
      inputs: from.flatMap((input) => notes.get(input) ?? []),
    };
    operations.push(operation);
    const result = letter ? { ...x, expr: letter } : x;
    notes.set(result, operation);
    return result;
  }

  const leaf = (x: number, expr: Expr): Traced<T> => {
    const traced = { own: own.of(x), exact: exact.of(x), expr };
    const mine = own.toNumber(traced.own);
    const digits = digitsOf(mine, traced.exact);
    const sign = own.sign(traced.own);
    notes.set(traced, {
      expr,
      letter: expr,
      own: mine,
      exact: traced.exact,
      sign,
      digits,
      inputs: [],
    });
    return traced;
  };

  const given = (x: number, expr: Expr): Traced<T> => {
    const traced = leaf(x, expr);
    inputs.push(notes.get(traced) as Operation);
    return traced;
  };

  const made = (mine: T, truth: () => Surd, expr: Expr, inputs: readonly Traced<T>[]): Traced<T> =>
    note(
      { own: mine, exact: inputs.some((x) => x.exact === null) ? null : attempt(truth), expr },
      letters.get(keyOf(expr)) ?? null,
      inputs,
    );

  const binary =
    (f: 'add' | 'sub' | 'mul' | 'div', write: (a: Expr, b: Expr) => Expr) =>
    (a: Traced<T>, b: Traced<T>): Traced<T> =>
      made(
        own[f](a.own, b.own),
        () => exact[f](a.exact as Surd, b.exact as Surd),
        write(a.expr, b.expr),
        [a, b],
      );

  const unary =
    (f: 'neg' | 'sqr' | 'sqrt', write: (a: Expr) => Expr) =>
    (a: Traced<T>): Traced<T> =>
      made(own[f](a.own), () => exact[f](a.exact as Surd), write(a.expr), [a]);

  const arithmetic: Arithmetic<Traced<T>> = {
    id: own.id,
    of: (x) => leaf(x, num(x)),
    add: binary('add', (a, b) => sumOf(a, { sign: 1, expr: b })),
    sub: binary('sub', (a, b) => sumOf(a, { sign: -1, expr: b })),
    mul: binary('mul', productOf),
    div: binary('div', over),
    neg: unary('neg', negative),
    sqr: unary('sqr', squared),
    sqrt: unary('sqrt', root),
    sign: (a) => own.sign(a.own),
    toNumber: (a) => own.toNumber(a.own),
    ...(own.sorted && { sorted: (a, b) => sortedBy(own, a, b) }),
  };

  return {
    arithmetic,
    inputs,
    operations,
    symbols: (values) => symbolsOf(values, given),
    placeholder: (letter) => leaf(1, letter),
    name(letter, tree, values, branch = 1) {
      const before = operations.length;
      const { expr } = evaluate(tree, arithmetic, values, branch);
      operations.length = before;
      letters.set(keyOf(expr), letter);
    },
  };
}

function sortedBy<T>(
  own: Arithmetic<T>,
  a: Traced<T>,
  b: Traced<T>,
): readonly [Traced<T>, Traced<T>] {
  const [first, second] = own.sorted?.(a.own, b.own) ?? [a.own, b.own];
  // Sorting may clip intervals and so give new numbers: they are matched to a and b by their order.
  const swapped = own.toNumber(a.own) > own.toNumber(b.own);
  const [low, high] = swapped ? [b, a] : [a, b];
  return [
    { ...low, own: first },
    { ...high, own: second },
  ];
}

/** The exact operation, or null where there is none. */
function attempt(f: () => Surd): Surd | null {
  try {
    return f();
  } catch (error) {
    if (error instanceof RangeError) return null;
    throw error;
  }
}

function symbolsOf<T>(
  { scalars, vectors }: Values<number>,
  leaf: (x: number, expr: Expr) => Traced<T>,
): Values<Traced<T>> {
  const scalarEntries = Object.entries(scalars).map(
    ([id, x]) => [id, leaf(x, scalar(id))] as const,
  );
  const vectorEntries = Object.entries(vectors).map(
    ([id, v]) => [id, AXES.map((axis, i) => leaf(v[i] as number, comp(id, axis)))] as const,
  );
  return {
    scalars: Object.fromEntries(scalarEntries),
    vectors: Object.fromEntries(vectorEntries) as unknown as Record<string, Triple<Traced<T>>>,
  };
}
