import type { Axis } from '../../vec3.ts';
import type { Expr, VectorExpr } from '../expr.ts';
import type { Notation, WrittenTerm } from './printer.ts';

type Sort = 'scalar' | 'vector';

/** The operators and relations that lines of the course hold. */
export type Sign = '+' | '−' | '±' | '·' | ',' | '=' | '≈' | '≠' | '<' | '>' | '≤';

/**
 * The marks that mathematics is written with, in some medium M: LaTeX, MathML, templates of a page.
 */
export interface Marks<M> {
  join(parts: readonly M[]): M;
  symbol(id: string, sort: Sort): M;
  component(vector: string, axis: Axis): M;
  /** Subscript and square one above the other. */
  componentSquared(vector: string, axis: Axis): M;
  /** t₁ */
  indexed(id: string, index: number): M;
  /** Digits without a sign, '∞', or a word for what is no number. */
  numeral(figures: string): M;
  operator(sign: Sign): M;
  /** A minus sign with nothing on its left. */
  readonly minus: M;
  parens(m: M): M;
  bars(m: M): M;
  fraction(over: M, under: M): M;
  root(m: M): M;
  power(base: M, exponent: M): M;
  /** A number in place of the symbol `id`. */
  put(m: M, id: string, sort: Sort): M;
}

/** A written piece, and what has to be known to put it next to others. */
export interface Piece<M> {
  readonly m: M;
  /**
   * How tightly it holds together: a sum, a dot product, a product or a minus sign, a power, a
   * single thing.
   */
  readonly rank: Rank;
  /**
   * What it begins with: a numeral cannot follow another factor without a dot, a minus sign no
   * plus.
   */
  readonly starts: 'numeral' | 'minus' | 'other';
  /** Its square, where that is not just a raised 2. */
  readonly squared?: M;
}

type Rank = (typeof RANK)[keyof typeof RANK];
export const RANK = { sum: 1, dot: 2, product: 3, power: 4, single: 5 } as const;

/** Writes the leaves of a tree: as symbols, or as the numbers that they stand for. */
export interface Leaves<M> {
  number(value: number): Piece<M>;
  scalar(id: string): Piece<M>;
  component(vector: string, axis: Axis): Piece<M>;
  vector(expr: VectorExpr): Piece<M>;
  whole(expr: Expr): Piece<M> | null;
}

/**
 * Mathematics as people write it: factors side by side, quotients as fractions, parentheses only
 * where needed.
 */
export function mathNotation<M>(marks: Marks<M>, leaves: Leaves<M>): Notation<Piece<M>> {
  const atLeast = ({ m, rank }: Piece<M>, least: Rank): M => (rank >= least ? m : marks.parens(m));
  /** Behind a sign: two signs in a row are told apart. */
  const afterSign = (p: Piece<M>): M =>
    p.starts === 'minus' ? marks.parens(p.m) : atLeast(p, RANK.dot);
  return {
    // Named one by one: a spread into so large an object is several times slower.
    number: leaves.number,
    scalar: leaves.scalar,
    component: leaves.component,
    whole: leaves.whole,
    sum: (terms) => ({
      m: marks.join(terms.flatMap((term, i) => signed(term, i, marks, afterSign))),
      rank: RANK.sum,
      starts: terms[0]?.sign === -1 ? 'minus' : (terms[0]?.of.starts ?? 'other'),
    }),
    product: (factors) => ({
      m: marks.join(factors.flatMap((factor, i) => sideBySide(factor, i, marks))),
      rank: RANK.product,
      // A first factor in parentheses hides what it starts with.
      starts: factors[0] && factors[0].rank >= RANK.product ? factors[0].starts : 'other',
    }),
    // 2 before ½ would read as a mixed number: a fraction counts as a numeral. Its square needs
    // parentheses.
    quotient: (over, under) => ({
      m: marks.fraction(over.m, under.m),
      rank: RANK.power,
      starts: 'numeral',
    }),
    negative: (of) => ({
      m: marks.join([marks.minus, afterSign(of)]),
      rank: of.rank === RANK.dot ? RANK.dot : RANK.product,
      starts: 'minus',
    }),
    square: (of) => ({
      m: of.squared ?? marks.power(atLeast(of, RANK.single), marks.numeral('2')),
      rank: RANK.power,
      starts: of.rank === RANK.single ? of.starts : 'other',
    }),
    root: (of) => ({ m: marks.root(of.m), rank: RANK.single, starts: 'other' }),
    plusMinus: (left, right) => ({
      m: marks.join([left.m, marks.operator('±'), afterSign(right)]),
      rank: RANK.sum,
      starts: left.starts,
    }),
    dot: (left, right) => ({
      m: marks.join([
        atLeast(leaves.vector(left), RANK.product),
        marks.operator('·'),
        atLeast(leaves.vector(right), RANK.product),
      ]),
      rank: RANK.dot,
      starts: 'other',
    }),
    norm: (of) => ({ m: marks.bars(leaves.vector(of).m), rank: RANK.single, starts: 'other' }),
  };
}

function signed<M>(
  { sign, of }: WrittenTerm<Piece<M>>,
  i: number,
  marks: Marks<M>,
  afterSign: (p: Piece<M>) => M,
): M[] {
  if (i > 0) return [marks.operator(sign === 1 ? '+' : '−'), afterSign(of)];
  // A sum that a sum begins with needs no parentheses: sums are read from the left.
  return sign === 1 ? [of.m] : [marks.minus, afterSign(of)];
}

function sideBySide<M>({ m, rank, starts }: Piece<M>, i: number, marks: Marks<M>): M[] {
  // N·d t would read as N·(d t).
  const bare = rank >= (i === 0 ? RANK.product : RANK.power);
  if (!bare) return [marks.parens(m)];
  return i > 0 && starts === 'numeral' ? [marks.operator('·'), m] : [m];
}
