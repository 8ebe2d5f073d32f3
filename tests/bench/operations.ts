import type { Expr } from '../../scripts/kernels/certified/expression.ts';
import { flowOf } from '../../scripts/kernels/certified/flow.ts';
import { PASSES, stageSources } from '../../scripts/kernels/certified/module.ts';
import { neededFor } from '../../scripts/kernels/certified/one-ray.ts';
import { elementOf, loopOf } from '../../scripts/kernels/certified/source.ts';
import { surfaces } from '../../scripts/kernels/trees/generate.ts';
import type { Node } from '../../scripts/kernels/trees/graph.ts';
import { asksOf, programOf } from '../../scripts/kernels/trees/program.ts';
import { SYSTEMS } from '../../scripts/kernels/trees/recorders.ts';
import type { Method } from '../../src/math/shapes.ts';
import { table } from './ladder-report.ts';
import type { CurvedQuestion } from './trials.ts';

/*
 * What a ray that hits a cone takes by each method: the operations of the program that both of its
 * kernels are made of, each value once, what is the same for all rays not counted.
 */

export const KINDS: readonly (readonly [string, readonly Node['op'][]])[] = [
  ['+ −', ['add', 'sub']],
  ['×', ['mul']],
  ['÷', ['div']],
  ['√', ['sqrt']],
  ['choices', ['select', 'keep', 'signed', 'unless', 'min', 'max']],
  ['comparisons', ['less', 'atMost', 'equal']],
];

/** The question of a method to a kind of curved shape; null for one without a program. */
export function questionOf(method: Method, kind: string): CurvedQuestion | null {
  const [surface] = surfaces([kind]);
  if (surface?.formula.family !== 'curved') throw new RangeError(`${kind} is not curved`);
  const { formula, symbols } = surface;
  let question: CurvedQuestion | null = null;
  method.parts?.(({ arithmetic: { id }, form, solver }) => {
    const system = SYSTEMS[id];
    if (system) question = { formula, symbols, system, form, solver };
  });
  return question;
}

/** Of one ray. */
interface Counts {
  /** In the order of KINDS. */
  readonly operations: readonly number[];
  /** Most branches of a loop of TypeScript: what a condition is joined of is asked one by one. */
  readonly branches: number;
}

const asked = (n: Node | null): number => {
  if (n === null) return 0;
  if (n.op !== 'and' && n.op !== 'or' && n.op !== 'not') return 1;
  return n.args.reduce((sum, one) => sum + asked(one), 0);
};

/** Null for a method without such a program. */
export function countsOf(method: Method, kind: string): Counts | null {
  const question = questionOf(method, kind);
  if (!question) return null;
  const [ask] = asksOf(question.system);
  const { outputs, rare, missed, rareRoots, inBlocks } = programOf(question, ask ?? 'both');
  const seen = new Set<Node>();
  const walk = (n: Node): void => {
    if (seen.has(n) || n.uniform) return;
    seen.add(n);
    n.args.forEach(walk);
  };
  for (const n of [...Object.values(outputs), rare, missed, rareRoots]) if (n) walk(n);
  return {
    operations: KINDS.map(([, ops]) => [...seen].filter(({ op }) => ops.includes(op)).length),
    // The hits of a block are listed without one.
    branches: asked(rare) + asked(rareRoots) + (inBlocks ? 0 : asked(missed)),
  };
}

const PASS_NAMES = ['coarseInSpace', 'residualsInSpace', 'solvePass'] as const;

/** Of the three passes that a ray goes through which certified's first stage settles. */
function certifiedCounts(): Counts {
  const { units } = stageSources();
  const formulas = PASS_NAMES.flatMap((pass) =>
    loopOf(units, pass, true)
      // To which list a ray goes that is left open.
      .statements.filter(({ target }) => target !== 'beside' && target !== 'remote')
      .map(({ formula }) => formula),
  );
  const counts = KINDS.map(() => 0);
  const walk = (formula: Expr): void => {
    const k = SIGNS.findIndex((ops) => ops.includes(formula.op));
    if (k >= 0) counts[k] = (counts[k] as number) + 1;
    if ('of' in formula) walk(formula.of);
    if ('a' in formula) [formula.a, formula.b].forEach(walk);
  };
  formulas.forEach(walk);
  return { operations: counts, branches: counts.at(-1) ?? 0 };
}

/**
 * Operations of the three passes over a shape with a term in y: all, and those that the verdict and
 * the near root need.
 */
export function operationsOfFirst(): { readonly all: number; readonly near: number } {
  const { units } = stageSources();
  const loops = PASS_NAMES.map((pass) => loopOf(units, pass, true));
  const { steps, name } = flowOf(loops, PASSES);
  const sizeOf = (formula: Expr): number =>
    (SIGNS.some((ops) => ops.includes(formula.op)) ? 1 : 0) +
    ('of' in formula ? sizeOf(formula.of) : 0) +
    ('a' in formula ? sizeOf(formula.a) + sizeOf(formula.b) : 0);
  const needed = (wanted: readonly string[]): number =>
    neededFor(steps, wanted).reduce((sum, { formula }) => sum + sizeOf(formula), 0);
  const verdict = [name('clear', 0), name('settled', 2)];
  const [near, far] = ['t0', 't1'].map((array) => name(elementOf(array))) as [string, string];
  return { all: needed([...verdict, near, far]), near: needed([...verdict, near]) };
}

/** In the order of KINDS. */
const SIGNS: readonly (readonly Expr['op'][])[] = [
  ['+', '-'],
  ['*'],
  ['/'],
  ['sqrt'],
  ['min', 'max'],
  ['<', '>', '<=', '>='],
];

/** A line for each method; the last cell is the sum of its operations, a ratio to textbook's. */
export function operationLines(methods: readonly Method[]): string[] {
  const sum = (counts: readonly number[]): number => counts.reduce((a, b) => a + b, 0);
  const found = methods.flatMap((method) => {
    const counts = method.id === 'certified' ? certifiedCounts() : countsOf(method, 'cone');
    return counts ? [{ id: method.id, ...counts }] : [];
  });
  const base = sum(found.find(({ id }) => id === 'textbook')?.operations ?? []);
  return table(
    ['method', ...KINDS.map(([name]) => name), 'branches', 'all but branches, to textbook'],
    found.map(({ id, operations, branches }) => [
      id,
      ...[...operations, branches].map(String),
      (sum(operations) / base).toPrecision(3),
    ]),
  );
}
