import type { Expr } from '../../scripts/kernels/certified/expression.ts';
import { stageSources } from '../../scripts/kernels/certified/module.ts';
import { loopOf } from '../../scripts/kernels/certified/source.ts';
import type { Node } from '../../scripts/kernels/trees/graph.ts';
import { asksOf, programOf } from '../../scripts/kernels/trees/program.ts';
import { SYSTEMS } from '../../scripts/kernels/trees/recorders.ts';
import { SHAPES } from '../../src/math/index.ts';
import type { Method } from '../../src/math/shapes.ts';
import { table } from './ladder-report.ts';

/*
 * What a ray that hits a cone takes by each method: the operations of the program that both of its
 * kernels are made of, each value once, what is the same for all rays not counted.
 */

const KINDS: readonly (readonly [string, readonly Node['op'][]])[] = [
  ['+ −', ['add', 'sub']],
  ['×', ['mul']],
  ['÷ √', ['div', 'sqrt']],
  ['choices', ['select', 'keep', 'signed', 'unless', 'min', 'max']],
  ['comparisons', ['less', 'atMost', 'equal']],
];

function cone() {
  const definition = SHAPES.find(({ kind }) => kind === 'cone');
  if (!definition) throw new RangeError('no cone');
  const shape = Object.fromEntries([
    ['kind', 'cone'],
    ...definition.params.map(({ key, initial }) => [key, initial]),
  ]) as never;
  return { formula: definition.formula(shape), symbols: definition.values(shape) };
}

/** How many of each kind; null for a method without such a program. */
function countsOf(method: Method): readonly number[] | null {
  let counts: readonly number[] | null = null;
  method.parts?.(({ arithmetic: { id }, form, solver }) => {
    const system = SYSTEMS[id];
    if (!system) return;
    const [ask] = asksOf(system);
    const program = programOf({ ...cone(), system, form, solver }, ask ?? 'both');
    const { outputs, rare, missed, rareRoots } = program;
    const seen = new Set<Node>();
    const walk = (n: Node): void => {
      if (seen.has(n) || n.uniform) return;
      seen.add(n);
      n.args.forEach(walk);
    };
    for (const n of [...Object.values(outputs), rare, missed, rareRoots]) if (n) walk(n);
    counts = KINDS.map(([, ops]) => [...seen].filter(({ op }) => ops.includes(op)).length);
  });
  return counts;
}

/** Of the three passes that a ray goes through which certified's first stage settles. */
function certifiedCounts(): readonly number[] {
  const { units } = stageSources();
  const passes = ['coarseInSpace', 'residualsInSpace', 'solvePass'];
  const formulas = passes.flatMap((pass) =>
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
  return counts;
}

/** In the order of KINDS. */
const SIGNS: readonly (readonly Expr['op'][])[] = [
  ['+', '-'],
  ['*'],
  ['/', 'sqrt'],
  ['min', 'max'],
  ['<', '>', '<=', '>='],
];

/** A line for each method; the last cell is the sum's ratio to textbook's. */
export function operationLines(methods: readonly Method[]): string[] {
  const sum = (counts: readonly number[]): number => counts.reduce((a, b) => a + b, 0);
  const found = methods.flatMap((method) => {
    const counts = method.id === 'certified' ? certifiedCounts() : countsOf(method);
    return counts ? [{ id: method.id, counts }] : [];
  });
  const base = sum(found.find(({ id }) => id === 'textbook')?.counts ?? []);
  return table(
    ['method', ...KINDS.map(([name]) => name), 'all, to textbook'],
    found.map(({ id, counts }) => [id, ...counts.map(String), (sum(counts) / base).toPrecision(3)]),
  );
}
