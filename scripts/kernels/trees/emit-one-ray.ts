import { POINT } from '../../../src/math/formula/common.ts';
import {
  evaluate,
  evaluateTriple,
  type Triple,
  withScalars,
} from '../../../src/math/formula/evaluate.ts';
import type { Verdict } from '../../../src/math/intersection.ts';
import { type Solver, solveBy } from '../../../src/math/methods/solvers.ts';
import { withPoint } from '../../../src/math/shapes/planar.ts';
import { local, roundedTo, usesOf, writer } from './emit-typescript.ts';
import { Graph, type Node } from './graph.ts';
import { INPUTS, lift, numbersOf, type Question } from './program.ts';
import type { System } from './recorders.ts';

/*
 * One ray at a time, with all case distinctions of its method: for objects, and for rays that a
 * loop leaves open. The places in the slot: src/math/batch/one-ray.ts.
 */

const ROOTS = 4;
const POINT_AT = 6;
const NORMAL_AT = 9;

/** Values that are not the ray's, and where they come from. */
type Given = readonly (readonly [Node, string])[];
type Puts = readonly (readonly [place: number, value: Node])[];

/** A, B, C and D; or of a flat shape what is known of it once N·d is not 0. */
export function formOf(kind: string, question: Question): string {
  const { formula, system, form } = question;
  const g = new Graph(system.format);
  const r = system.make(g);
  const ar = r.arithmetic;
  const { values } = lift(g, r, question.symbols);
  const at = (from: number, list: readonly unknown[]): Puts =>
    list.map((x, k) => [from + k, r.shown(x)]);
  if (formula.family === 'curved') {
    const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], ar, values);
    const D = form.discriminant(formula, withScalars(values, { A, B, C }), ar);
    return puts(`const ${kind}: PutForm`, 'values, E, d, s', question, at(0, [A, B, C, D]));
  }
  const [offset, rate] = [formula.offset, formula.rate].map((e) => evaluate(e, ar, values));
  const t = evaluate(formula.t, ar, withScalars(values, { rate }));
  const { x, excesses } = form.meeting(formula, withScalars(values, { rate, t }), ar);
  const all = [...at(0, [offset, rate, t]), ...at(POINT_AT, x), ...at(NORMAL_AT, excesses)];
  return puts(`const ${kind}: PutForm`, 'values, E, d, s', question, all);
}

/** The point at a root, which is the same for all shapes. */
export function pointOf(system: System): string {
  const question = { system, symbols: { scalars: {}, vectors: {} } };
  const g = new Graph(system.format);
  const r = system.make(g);
  const { values } = lift(g, r, question.symbols);
  const t = g.input('t');
  const point = evaluateTriple(POINT, r.arithmetic, withScalars(values, { t: r.lift(t) }));
  const all = point.map((x, k): [number, Node] => [POINT_AT + k, r.shown(x)]);
  const given: Given = [[t, `s[${ROOTS} + root] as number`]];
  return puts('const point: PutPoint', 'E, d, s, root', question, all, given);
}

/** The normal of a curved shape at the point. */
export function normalOf(kind: string, question: Question): string {
  const { formula, system, symbols } = question;
  if (formula.family !== 'curved') throw new RangeError('a flat shape has one normal');
  const g = new Graph(system.format);
  const r = system.make(g);
  const { values } = lift(g, r, symbols);
  const at = [0, 1, 2].map((k) => g.input(`p${k}`));
  const point = at.map(r.lift) as unknown as Triple<unknown>;
  const normal = evaluateTriple(formula.normal, r.arithmetic, withPoint(values, point));
  const all = normal.map((x, k): [number, Node] => [NORMAL_AT + k, r.shown(x)]);
  const given: Given = at.map((n, k) => [n, `s[${POINT_AT + k}] as number`]);
  return puts(`const ${kind}Normal: PutNormal`, 'values, s', question, all, given);
}

/** A function that writes values into the slot. */
function puts(
  declared: string,
  params: string,
  { symbols, system: { format } }: Pick<Question, 'symbols' | 'system'>,
  places: Puts,
  given: Given = [],
): string {
  const roots = places.map(([, n]) => n);
  const { names, value } = writer(format, usesOf(roots), null);
  const rounded = roundedTo(format);
  const lines: string[] = [];
  const take = (n: Node, name: string, from: string): void => {
    if (names.has(n)) return;
    names.set(n, name);
    lines.push(`const ${name} = ${rounded(from)};`);
  };
  const read = new Set<Node>();
  const walk = (n: Node): void => {
    if (read.has(n)) return;
    read.add(n);
    for (const a of n.args) walk(a);
  };
  roots.forEach(walk);
  const found = [...read];
  for (const [n, from] of given) {
    if (!read.has(n)) continue;
    names.set(n, n.name);
    lines.push(`const ${n.name} = ${from};`);
  }
  for (const [k, input] of INPUTS.entries()) {
    const n = found.find(({ op, name }) => op === 'input' && name === input);
    if (n) take(n, local(input), `${input[0]}[${k % 3}]`);
  }
  for (const [k, name] of numbersOf(symbols).entries()) {
    const n = found.find((one) => one.op === 'number' && one.name === name);
    const [id, part] = name.split('.');
    const from = part ? `(vectors.${id} as Vec3)[${part}]` : `scalars.${id} as number`;
    if (n) take(n, `k${k}`, from);
  }
  const texts = places.map(([place, n]): [number, string] => [place, value(n, lines)]);
  const text = lines.join('\n');
  const taken = ['scalars', 'vectors'].filter((name) => text.includes(`${name}.`));
  const used = taken.length > 0 ? `{ ${taken.join(', ')} }` : '_';
  return [
    `${declared} = (${params.replace('values', used)}) => {`,
    ...lines,
    ...texts.map(([place, x]) => `s[${place}] = ${x};`),
    '};',
  ].join('\n');
}

interface Found {
  readonly class: Verdict;
  readonly roots: readonly Node[];
}

/** What a solver finds, by the signs that it asks for. */
type Tree = Found | { readonly on: Node; readonly by: ReadonlyMap<number, Tree> };

/** As Arithmetic.sign answers: in the order in which they are told apart. */
const SIGNS = [Number.NaN, 0, -1, 1] as const;
const TESTS = new Map<number, (x: string) => string>([
  [Number.NaN, (x) => `${x} - ${x} !== 0`],
  [0, (x) => `${x} === 0`],
  [-1, (x) => `${x} < 0`],
]);

class Asked {
  readonly on: Node;
  constructor(on: Node) {
    this.on = on;
  }
}

/** Asks the solver again and again, with every answer to each question that it has. */
function treeOf(g: Graph, solver: Solver, system: System, known: readonly number[] = []): Tree {
  const r = system.make(g);
  let next = 0;
  const ar = {
    ...r.arithmetic,
    sign(x: unknown): number {
      const sign = known[next++];
      if (sign === undefined) throw new Asked(r.shown(x));
      return sign;
    },
    // As methods/solvers.ts does it where a sign is not known.
    sorted: (a: unknown, b: unknown): readonly [unknown, unknown] => {
      const [x, y] = [r.shown(a), r.shown(b)];
      return [r.lift(g.min(x, y)), r.lift(g.max(x, y))];
    },
  };
  const [A, B, C, D] = ['A', 'B', 'C', 'D'].map((name) => r.lift(g.input(name)));
  try {
    const found = solveBy(solver, A, B, C, D, ar);
    return { class: found.class, roots: found.roots.map(r.shown) };
  } catch (asked) {
    if (!(asked instanceof Asked)) throw asked;
    const by = SIGNS.map((sign): [number, Tree] => [
      sign,
      treeOf(g, solver, system, [...known, sign]),
    ]);
    return { on: asked.on, by: new Map(by) };
  }
}

function alike(a: Tree, b: Tree): boolean {
  if ('class' in a || 'class' in b) {
    return (
      'class' in a &&
      'class' in b &&
      a.class === b.class &&
      a.roots.length === b.roots.length &&
      a.roots.every((n, k) => n === b.roots[k])
    );
  }
  const same = ([sign, tree]: [number, Tree]): boolean => alike(tree, b.by.get(sign) as Tree);
  return a.on === b.on && [...a.by].every(same);
}

/** The class and the roots from A, B, C and D. */
export function rootsOf(solver: Solver, system: System): string {
  const g = new Graph(system.format);
  const lines: string[] = [];
  const names = ['A', 'B', 'C', 'D'];
  names.forEach((name, k) => {
    lines.push(`const ${name} = s[${k}] as number;`);
  });
  write(treeOf(g, solver, system), system, lines, new Map(names.map((x) => [g.input(x), x])));
  const none = [0, 1].map((k) => `s[${ROOTS + k}] = Number.NaN;`);
  return ['const roots: PutRoots = (s) => {', ...none, ...lines, '};'].join('\n');
}

function write(
  tree: Tree,
  system: System,
  lines: string[],
  before: ReadonlyMap<Node, string>,
): void {
  if ('class' in tree) {
    const { names, value } = writer(system.format, usesOf(tree.roots), null);
    for (const [n, name] of before) names.set(n, name);
    const texts = tree.roots.map((n) => value(n, lines));
    for (const [k, text] of texts.entries()) lines.push(`s[${ROOTS + k}] = ${text};`);
    lines.push(`return ${tree.class.toUpperCase()};`);
    return;
  }
  const x = before.get(tree.on);
  if (x === undefined) throw new RangeError('a solver may ask for the signs of A, B, C and D only');
  const left = new Map(tree.by);
  for (const [sign, test] of TESTS) {
    const one = left.get(sign) as Tree;
    left.delete(sign);
    // What the last ones have in common is not told apart.
    if ([...left.values()].every((other) => alike(other, one))) {
      write(one, system, lines, before);
      return;
    }
    const inner: string[] = [];
    write(one, system, inner, before);
    lines.push(`if (${test(x)}) {`, ...inner, '}');
  }
  write(left.get(1) as Tree, system, lines, before);
}
