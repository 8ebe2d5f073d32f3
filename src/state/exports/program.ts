import {
  type CurvedFormula,
  components,
  DISCRIMINANT,
  DOUBLE_ROOT,
  type Expr,
  type ExprTriple,
  type FlatFormula,
  LINEAR_ROOT,
  minus,
  POINT,
  ROOTS,
} from '../../math/formula.ts';
import type { Verdict } from '../../math/index.ts';
import type { Formula } from '../../math/shapes.ts';

/** A statement of the course's algorithm, independent of the language it is written in. */
export type Statement =
  | { readonly do: 'put'; readonly name: string; readonly expr: Expr; readonly branch?: 1 | -1 }
  | { readonly do: 'point'; readonly name: string; readonly exprs: ExprTriple }
  | { readonly do: 'remark'; readonly text: string }
  | { readonly do: 'when'; readonly test: Test; readonly then: readonly Statement[] }
  | { readonly do: 'answer'; readonly class: Verdict; readonly ts: readonly string[] };

export type Test =
  | { readonly is: 'zero' | 'negative'; readonly name: string }
  /** One of them is NaN or infinite. */
  | { readonly is: 'lost'; readonly names: readonly string[] }
  /** One of them is greater than 0, so that a condition fails. */
  | { readonly is: 'positive'; readonly names: readonly string[] }
  | { readonly is: 'greater'; readonly name: string; readonly than: string };

export interface Program {
  readonly statements: readonly Statement[];
  /** Subtrees for which a statement has defined a name. */
  readonly known: ReadonlyMap<Expr, string>;
  /** The normal at the point X. */
  readonly normal: ExprTriple;
}

/**
 * The textbook method, step by step. It compares nothing with an epsilon and reports overflow. Its
 * answers are the t's of the whole line, ascending.
 */
export function programOf(formula: Formula): Program {
  return formula.family === 'curved' ? curved(formula) : flat(formula);
}

const put = (name: string, expr: Expr, branch?: 1 | -1): Statement =>
  branch ? { do: 'put', name, expr, branch } : { do: 'put', name, expr };
const remark = (text: string): Statement => ({ do: 'remark', text });
const when = (test: Test, ...then: Statement[]): Statement => ({ do: 'when', test, then });
const answer = (verdict: Verdict, ...ts: string[]): Statement => ({
  do: 'answer',
  class: verdict,
  ts,
});
const undecidedIfLost = (...names: string[]): Statement =>
  when({ is: 'lost', names }, answer('undecided'));

function curved({ A, B, C, normal }: CurvedFormula): Program {
  return {
    statements: [
      put('A', A),
      put('B', B),
      put('C', C),
      put('D', DISCRIMINANT),
      when({ is: 'zero', name: 'A' }, ...LINEAR),
      // If A overflowed, D is NaN as well.
      undecidedIfLost('D'),
      when({ is: 'negative', name: 'D' }, answer('none')),
      when({ is: 'zero', name: 'D' }, ...single('tangent', DOUBLE_ROOT)),
      put('t1', ROOTS, -1),
      put('t2', ROOTS, 1),
      undecidedIfLost('t1', 't2'),
      remark('A < 0 turns the two around.'),
      when({ is: 'greater', name: 't1', than: 't2' }, answer('two', 't2', 't1')),
      answer('two', 't1', 't2'),
    ],
    known: new Map(),
    normal,
  };
}

const LINEAR: readonly Statement[] = [
  remark('f(t) = Bt + C: a line, or a constant.'),
  undecidedIfLost('B'),
  when(
    { is: 'zero', name: 'B' },
    undecidedIfLost('C'),
    when({ is: 'zero', name: 'C' }, answer('contained')),
    answer('none'),
  ),
  ...single('one', LINEAR_ROOT),
];

function single(verdict: Verdict, root: Expr): Statement[] {
  return [put('t', root), undecidedIfLost('t'), answer(verdict, 't')];
}

function flat({ offset, rate, t, bound }: FlatFormula): Program {
  const gaps = (bound?.conditions ?? []).map(({ left, right }) => minus(left, right));
  const names = gaps.map((_, i) => (gaps.length === 1 ? 'gap' : `gap${i + 1}`));
  return {
    statements: [
      put('offset', offset),
      put('rate', rate),
      undecidedIfLost('rate'),
      when(
        { is: 'zero', name: 'rate' },
        remark('Parallel to the plane: in it, or beside it.'),
        undecidedIfLost('offset'),
        when({ is: 'zero', name: 'offset' }, answer('contained')),
        answer('none'),
      ),
      put('t', t),
      ...(gaps.length > 0 ? inside(gaps, names) : []),
      undecidedIfLost('t'),
      answer('one', 't'),
    ],
    known: new Map([
      [offset, 'offset'],
      [rate, 'rate'],
    ]),
    normal: components('N'),
  };
}

function inside(gaps: readonly Expr[], names: readonly string[]): Statement[] {
  return [
    { do: 'point', name: 'X', exprs: POINT },
    remark('How far X is beyond the figure: the rim and the edges, at 0, are inside.'),
    ...gaps.map((gap, i) => put(names[i] ?? 'gap', gap)),
    when({ is: 'positive', names }, answer('none')),
    undecidedIfLost(...names),
  ];
}
