import {
  type Arithmetic,
  evaluateTriple,
  solveBy,
  valuesOf,
  withScalars,
} from '../../math/formula.ts';
import type { Shape } from '../../math/index.ts';
import { pick } from '../../math/rng.ts';
import { type CurvedDetails, definitionOf, findMethod } from '../../math/shapes.ts';
import { type Answers, choiceField, type Input } from '../types.ts';
import { type Draft, type Exercise, spreadOver, type Told } from './define.ts';
import { allDraws, digitsRight, keptDigits, measured, sameKind } from './digits.ts';
import { drawUntil, kindsOf } from './draw.ts';

const METHODS = [
  { id: 'textbook', title: 'textbook: (−B ± √D)/2A' },
  { id: 'stable', title: 'stable: another formula for the smaller root' },
  { id: 'moment', title: 'moment: D in its other form' },
  { id: 'compensated', title: 'compensated: pairs of doubles on every line' },
] as const;

const WHY = [
  { id: 'kept', title: 'no line loses digits that are needed' },
  { id: 't', title: '−B and √D cancel, and nothing before' },
  { id: 'D', title: 'B² and 4AC cancel, but D has another form' },
  { id: 'both', title: 'both forms of D lose digits' },
  { id: 'terms', title: 'the terms of A or of C cancel already' },
] as const;

/** The reason by the line that the textbook loses digits on first, and the cheapest cure. */
const REASONS: Readonly<Record<string, string>> = {
  'nowhere textbook': 'kept',
  't stable': 't',
  'D moment': 'D',
  'D compensated': 'both',
  'A compensated': 'terms',
  'C compensated': 'terms',
};

/** Right digits that are asked for. */
const WANTED = 13;

/** The answer for one ray; null if it is not clear enough to ask. */
function answerFor(input: Input): Answers | null {
  const found = measured(input);
  const reason = found && REASONS[`${found.line} ${found.cure}`];
  const { cures } = (reason && keptDigits(input)) || { cures: [] };
  const [first, ...others] = cures
    .filter(({ kept }) => kept >= WANTED)
    .map(({ id }) => ({ id, price: priceOf(id, input) }));
  if (!first || !reason) return null;
  const cheapest = others.reduce((best, one) => (one.price < best.price ? one : best), first);
  return { method: cheapest.id, reason };
}

/**
 * How many operations on doubles one operation on pairs of doubles takes
 * (src/math/arithmetic/double-double.ts, with products split without FMA).
 */
export const OF_PAIRS = { add: 20, sub: 20, mul: 24, div: 33, sqr: 18, sqrt: 21 } as const;
type Counted = keyof typeof OF_PAIRS;

/** The method's price: operations on doubles for both roots, the same on every machine. */
function priceOf(id: string, { shape, ray }: Input): number {
  let count = 0;
  findMethod(id)?.parts?.(({ arithmetic: own, form, solver }) => {
    const arithmetic = counting(own, (operation) => {
      count += own.id === 'double-double' ? OF_PAIRS[operation] : 1;
    });
    const formula = definitionOf(shape).formula(shape);
    if (formula.family === 'flat') return;
    const values = valuesOf(shape, ray, arithmetic);
    const trees = [formula.A, formula.B, formula.C] as const;
    const [A, B, C] = evaluateTriple(trees, arithmetic, values);
    const D = form.discriminant(formula, withScalars(values, { A, B, C }), arithmetic);
    solveBy(solver, A, B, C, D, arithmetic);
  });
  return count;
}

function counting<T>(own: Arithmetic<T>, add: (operation: Counted) => void): Arithmetic<T> {
  const two =
    (name: 'add' | 'sub' | 'mul' | 'div') =>
    (a: T, b: T): T => {
      add(name);
      return own[name](a, b);
    };
  const one =
    (name: 'sqr' | 'sqrt') =>
    (a: T): T => {
      add(name);
      return own[name](a);
    };
  const pairs = { add: two('add'), sub: two('sub'), mul: two('mul'), div: two('div') };
  return { ...own, ...pairs, sqr: one('sqr'), sqrt: one('sqrt') };
}

/** Digits of 16 that a line has lost. */
const lost = (kept: number): number => Math.round(16 - kept);

/** The digits that the lines lose, and those of the other form of D. */
function lostWords(input: Input): string {
  const { lines } = keptDigits(input) ?? { lines: [] };
  const of = (id: string) => findMethod(id)?.intersect(input.shape, input.ray).details;
  const [own, truth] = [of('moment'), of('exact')] as [CurvedDetails, CurvedDetails];
  const other = ` (its other form ${lost(digitsRight(own.D, truth.D))})`;
  return lines
    .map(([name, kept]) => `${name} ${lost(kept)}${name === 'D' ? other : ''}`)
    .join(', ');
}

/** C, or V, where the shape's point is its vertex. */
const pointOf = (shape: Shape): string =>
  definitionOf(shape).params.find(({ type }) => type === 'vector')?.symbol ?? '';

const raysOf = (draft: Draft): readonly Input[] => [draft, ...(draft.more ?? [])];

function told(draft: Draft): Told[] {
  const prices = METHODS.map(({ id }) => `${id} ${priceOf(id, draft)}`);
  return [
    ...raysOf(draft).map((input, i) => ({
      name: `lost on ray ${i + 1}`,
      says: lostWords(input),
    })),
    { name: 'operations on doubles', says: prices.join(', ') },
  ];
}

export const method: Exercise = {
  id: 'method',
  topic: 'which method for these rays',
  paper: false,
  kinds: kindsOf('curved'),
  // Stable takes no more operations than the textbook, which is therefore never the answer.
  spread: spreadOver('method', ['stable', 'moment', 'compensated']),
  draw(random, kind, _, wanted) {
    const make = pick(random, allDraws(kind));
    const accept = (drawn: Input): Answers | null =>
      sameKind(drawn, kind) ? answerFor(drawn) : null;
    const first = make(random);
    const answer = accept(first);
    if (!answer || (wanted !== undefined && answer.method !== wanted)) return null;
    const second = drawUntil(
      () => make(random),
      (drawn) => accept(drawn)?.reason === answer.reason,
    );
    if (!second) return null;
    return { ...first, more: [second], watch: answer.reason === 't' ? [] : ['loss-always-t'] };
  },
  ask: ({ shape }) =>
    'Two rays of one kind; the first is shown. The lists say how many of 16 digits each line of ' +
    'the textbook method loses there, and D in its other form, from the moment ' +
    `d × (E − ${pointOf(shape)}). ` +
    `Which method keeps ${WANTED} digits of the roots of both with the fewest operations, and why?`,
  given: [],
  told,
  fields: () => [
    choiceField('method', 'with the fewest', METHODS),
    choiceField('reason', 'because', WHY),
  ],
  answers: (course, draft) =>
    course.rules.loss === 'measured' ? (answerFor(draft) ?? {}) : { method: 'stable', reason: 't' },
  argue(draft) {
    const kept = raysOf(draft).map((input, i) => {
      const { cures } = keptDigits(input) ?? { cures: [] };
      const each = cures.map(({ id, kept: digits }) => `${id} ${Math.floor(digits)}`);
      return `Right digits of the roots on ray ${i + 1}: ${each.join(', ')}.`;
    });
    const prices = METHODS.map(({ id }) => `${id} ${priceOf(id, draft)}`).join(', ');
    return {
      rule:
        'What a line has lost, later lines cannot get back: look for the first line that loses ' +
        'more than three digits, and for the method with the fewest operations that works that ' +
        'line out otherwise.',
      put: 'Which line loses first? Does the other form of D lose there, too?',
      decision: [...kept, `Operations: ${prices}.`],
    };
  },
  clue: 'Go through the lines in order: the first one that loses digits has to be replaced.',
  lines: [],
};
