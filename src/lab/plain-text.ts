import {
  type Expr,
  type Notation,
  print,
  type VectorExpr,
  type WrittenTerm,
} from '../math/formula.ts';
import { MINUS, shortest } from '../text/format.ts';

interface Text {
  readonly text: string;
  readonly rank: 1 | 2 | 3;
}

const SUM = 1;
const PRODUCT = 2;
const SINGLE = 3;

const single = (text: string): Text => ({ text, rank: SINGLE });
const within = ({ text, rank }: Text, least: number): string => (rank < least ? `(${text})` : text);

function sum(terms: readonly WrittenTerm<Text>[]): Text {
  const written = terms.map(({ sign, of }, i) => {
    const body = within(of, i === 0 && sign === 1 ? SUM : PRODUCT);
    if (i === 0) return sign === 1 ? body : MINUS + body;
    return ` ${sign === 1 ? '+' : MINUS} ${body}`;
  });
  return { text: written.join(''), rank: SUM };
}

function vector(expr: VectorExpr): string {
  if (expr.op === 'vector') return expr.id;
  if (expr.op === 'moved') return `(${vector(expr.from)} + ${expr.by} ${vector(expr.step)})`;
  return `(${vector(expr.left)} ${MINUS} ${vector(expr.right)})`;
}

const NOTATION: Notation<Text> = {
  number: (x) => single(shortest(x).replace('-', MINUS)),
  scalar: (id) => single(id),
  component: (id, axis) => single(id + axis),
  sum,
  product: (factors) => ({
    text: factors.map((factor) => within(factor, PRODUCT)).join(' '),
    rank: PRODUCT,
  }),
  quotient: (over, under) => ({
    text: `${within(over, PRODUCT)} / ${within(under, SINGLE)}`,
    rank: PRODUCT,
  }),
  negative: (of) => ({ text: MINUS + within(of, SINGLE), rank: PRODUCT }),
  square: (of) => single(`${within(of, SINGLE)}²`),
  root: (of) => single(`√${within(of, SINGLE)}`),
  plusMinus: (left, right) => ({ text: `${left.text} ± ${within(right, PRODUCT)}`, rank: SUM }),
  dot: (left, right) => ({ text: `${vector(left)}·${vector(right)}`, rank: PRODUCT }),
  norm: (of) => single(`|${vector(of).replace(/^\((.*)\)$/, '$1')}|`),
  whole: () => null,
};

/** A formula for a sentence, in one line of plain text: B² − 4 A C. */
export const plainText = (expr: Expr): string => print(expr, NOTATION).text;
