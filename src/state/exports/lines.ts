import {
  type ConditionStep,
  type Expr,
  inNumbers,
  inSymbols,
  type Marks,
  numberTriple,
  partsPiece,
  type Relation,
  type Step,
} from '../../math/formula.ts';
import type { ExploreModel } from '../derive.ts';
import { exactParts, rangeNote, shownResult } from '../exact-digits.ts';
import { putIn, resultsOf } from '../put-in.ts';
import { hitLines } from './hit-lines.ts';
import { DIGITS, type ExportLine, equation, number } from './line.ts';

/** The page's algebra from the ray to the hits: symbols, numbers, value, in the page's digits. */
export function derivationLines<M>(model: ExploreModel, marks: Marks<M>): ExportLine<M>[] {
  const { derivation, contradicted, ended, found, exactly } = model;
  const range = rangeNote(derivation, found, exactly);
  return [
    ...given(model, marks),
    relationLine(derivation.surface, marks),
    {
      left: marks.join([marks.symbol('f', 'scalar'), marks.parens(marks.symbol('t', 'scalar'))]),
      relation: '=',
      right: marks.join([inSymbols(derivation.f, marks), marks.operator('='), number(0, marks)]),
      words: '',
    },
    ...derivation.steps.flatMap((step) => stepLines(step, model, marks)),
    ...derivation.conditions.flatMap((condition) => conditionLines(condition, model, marks)),
    ...(range ? [wordsLine<M>(range)] : []),
    verdictLine(model, marks),
    ...[contradicted, ended?.contradicted].flatMap((other) =>
      other ? [wordsLine<M>(`exact arithmetic says: ${other}`)] : [],
    ),
    ...hitLines(model, marks),
  ];
}

const wordsLine = <M>(words: string): ExportLine<M> => ({
  left: null,
  relation: null,
  right: null,
  words,
});

/**
 * Lines for E, d and the shape's parameters. The derivation's numbers also hold A, B, C and D,
 * which are results and are left out here.
 */
function given<M>({ derivation }: ExploreModel, marks: Marks<M>): ExportLine<M>[] {
  const { scalars, vectors } = derivation.numbers;
  const results = new Set(derivation.steps.map(({ id }) => id));
  const { E, d, X: _, ...shape } = vectors;
  const inOrder = Object.entries({ ...(E && { E }), ...(d && { d }), ...shape });
  return [
    ...inOrder.map(
      ([id, v]): ExportLine<M> =>
        equation(marks.symbol(id, 'vector'), numberTriple(v, marks, DIGITS)),
    ),
    ...Object.entries(scalars)
      .filter(([id]) => !results.has(id) && !/^[xyz]$/.test(id))
      .map(([id, x]): ExportLine<M> => equation(marks.symbol(id, 'scalar'), number(x, marks))),
  ];
}

function relationLine<M>({ left, relation, right }: Relation, marks: Marks<M>): ExportLine<M> {
  return { left: inSymbols(left, marks), relation, right: inSymbols(right, marks), words: '' };
}

/** Lines of a step. A quantity without a letter has its symbols on the left. */
function stepLines<M>(step: Step, model: ExploreModel, marks: Marks<M>): ExportLine<M>[] {
  const { id, letter, expr, value, worked } = step;
  const { derivation, found, exactly } = model;
  const symbols = inSymbols(expr, marks);
  const put = putIn(step, derivation, resultsOf(step, found, exactly), [null], () => true);
  const sign = put?.isFaithful === false ? '≈' : '=';
  const result = value === null ? null : resultPiece(id, value, model, marks);
  const numbers = put && inNumbers(expr, marks, derivation.numbers, { worked, digits: put.digits });
  const parts = [numbers, result].filter((m) => m !== null);
  const right = marks.join(parts.flatMap((m, i) => (i > 0 ? [marks.operator(sign), m] : [m])));
  // A line without a result leads to the roots in the lines below it.
  const relation = result === null ? sign : '=';
  const lines: ExportLine<M>[] = letter ? [equation(inSymbols(letter, marks), symbols)] : [];
  if (parts.length === 0) return lines;
  return [...lines, { left: letter ? null : symbols, relation, right, words: '' }];
}

/** The value; if it is out of the doubles' range, the exact one with a power of ten. */
function resultPiece<M>(
  id: string,
  value: number,
  { found, exactly }: ExploreModel,
  marks: Marks<M>,
): M {
  const isBeyond = shownResult(id, value, found, exactly).text !== null;
  const quantity = exactly.quantities[id];
  return isBeyond && quantity && !Number.isNaN(value)
    ? partsPiece(exactParts(quantity), marks).m
    : number(value, marks);
}

/** A condition in symbols, then in numbers; for a norm only its value, as on the page. */
function conditionLines<M>(
  { relation, left, right, holds }: ConditionStep,
  { derivation }: ExploreModel,
  marks: Marks<M>,
): ExportLine<M>[] {
  const put = (expr: Expr, value: number): M =>
    relation.left.op === 'norm'
      ? number(value, marks)
      : inNumbers(expr, marks, derivation.numbers, { worked: false, digits: DIGITS });
  return [
    relationLine(relation, marks),
    {
      left: put(relation.left, left),
      relation: relation.relation,
      right: put(relation.right, right),
      words: holds === null ? 'cannot tell' : holds ? 'holds' : 'fails',
    },
  ];
}

function verdictLine<M>({ verdict, derivation }: ExploreModel, marks: Marks<M>): ExportLine<M> {
  const comparisons = verdict.relations.flatMap(({ left, relation, right }, i) => [
    ...(i > 0 ? [marks.operator(',')] : []),
    quantity(left, derivation.steps, marks),
    marks.operator(relation),
    marks.numeral(right),
  ]);
  const right = comparisons.length > 0 ? marks.join(comparisons) : null;
  return { left: null, relation: null, right, words: verdict.text };
}

/** A quantity by the name of its step: N·(E − P), or N·(E − C) where the shape's point is C. */
function quantity<M>(id: string, steps: readonly Step[], marks: Marks<M>): M {
  const step = steps.find((s) => s.id === id);
  return step ? inSymbols(step.letter ?? step.expr, marks) : marks.symbol(id, 'scalar');
}
