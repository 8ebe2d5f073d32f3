import { CONTAINED, NONE, ONE, TANGENT, UNDECIDED } from '../../../src/math/batch/batch.ts';
import { ASK } from '../../../src/math/batch/straight-loop.ts';
import { DOUBLE_ROOT, LINEAR_ROOT } from '../../../src/math/formula/common.ts';
import {
  evaluate,
  evaluateTriple,
  type Triple,
  type Values,
  withScalars,
} from '../../../src/math/formula/evaluate.ts';
import type { Form } from '../../../src/math/methods/forms.ts';
import type { Solver } from '../../../src/math/methods/solvers.ts';
import type { CurvedFormula } from '../../../src/math/shapes/axial-quadric.ts';
import type { Formula } from '../../../src/math/shapes/define.ts';
import type { FlatFormula } from '../../../src/math/shapes/planar.ts';
import { dependsOn, type Format, Graph, type Node } from './graph.ts';
import type { Recorder, System } from './recorders.ts';

/** One question to a shape by a method, as values that are worked out from one another. */
export interface Program {
  readonly format: Format;
  /** What is written, by the name of the array. */
  readonly outputs: Readonly<Partial<Record<'t0' | 't1' | 'margin', Node>>>;
  /** Where it holds, the outputs mean nothing, and `special` tells what to do. */
  readonly rare: Node;
  readonly special: Special;
  /**
   * Where it holds, and `rare` does not, there is no root: neither the outputs nor `rareRoots` need
   * be worked out. Null: the outputs are NaN by themselves.
   */
  readonly missed: Node | null;
  readonly rareRoots: Node | null;
  readonly inBlocks: boolean;
  /** What is written, and where the trees are asked, if only the class is; null: see Ask. */
  readonly classes: { readonly margin: Node; readonly rare: Node | null } | null;
}

/**
 * The method's case distinctions where it asks for more than the sign of D: A, B, D or N·d is 0, or
 * a sign is not known.
 */
export interface Special {
  /** The class as a place in VERDICTS; ASK where only the trees know. */
  readonly verdict: Node;
  /** The one root; NaN where there is none. */
  readonly t: Node;
}

export const INPUTS = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'] as const;

export interface Question {
  readonly formula: Formula;
  /** The shape's symbols; what they stand for does not matter. */
  readonly symbols: Values<unknown>;
  readonly system: System;
  readonly form: Form;
  readonly solver: Solver;
}

/** The names of a shape's numbers, in the order in which a kernel is given them. */
export function numbersOf({ scalars, vectors }: Values<unknown>): string[] {
  const parts = Object.keys(vectors).flatMap((id) => [0, 1, 2].map((k) => `${id}.${k}`));
  return [...Object.keys(scalars), ...parts];
}

/** 'either' is told at run time: for numbers whose operations are long. */
export type Ask = 'both' | 'classes' | 'either';

export const asksOf = ({ box }: System): readonly Ask[] => (box ? ['either'] : ['both', 'classes']);

/** In a graph of its own, unless more is to be made of the same values. */
export function programOf(
  question: Question,
  ask: Ask,
  g: Graph = new Graph(question.system.format),
): Program {
  const r = question.system.make(g);
  const { formula } = question;
  return formula.family === 'curved'
    ? curved(g, r, question, formula, ask)
    : flat(g, r, question, formula, ask);
}

export interface Lifted {
  readonly values: Values<unknown>;
  readonly inputs: readonly Node[];
}

export function lift(
  g: Graph,
  r: Recorder<unknown>,
  { scalars, vectors }: Values<unknown>,
): Lifted {
  const inputs = INPUTS.map(g.input);
  const [Ex, Ey, Ez, dx, dy, dz] = inputs.map(r.lift);
  const number = (name: string): unknown => r.lift(g.number(name));
  const own = Object.keys(vectors).map((id): [string, Triple<unknown>] => [
    id,
    [number(`${id}.0`), number(`${id}.1`), number(`${id}.2`)],
  ]);
  return {
    inputs,
    values: {
      scalars: Object.fromEntries(Object.keys(scalars).map((id) => [id, number(id)])),
      vectors: { ...Object.fromEntries(own), E: [Ex, Ey, Ez], d: [dx, dy, dz] },
    },
  };
}

const sumOf = (g: Graph, inputs: readonly Node[]): Node =>
  inputs.map(g.abs).reduce((a, b) => g.add(a, b));

/** Where an input is outside of the system's box. */
function unusual(g: Graph, { box }: System, inputs: readonly Node[]): Node[] {
  if (!box) return [];
  const sizes = inputs.map(g.abs);
  const zero = g.of(0);
  const tiny = sizes.map((size) => g.and(g.less(zero, size), g.less(size, g.of(box.least))));
  return [g.not(g.less(sumOf(g, inputs), g.of(box.most))), ...(box.least > 0 ? tiny : [])];
}

const any = (g: Graph, masks: readonly Node[]): Node => masks.reduce((a, b) => g.or(a, b));
/** Where one of them holds. */
const where = (g: Graph, masks: readonly Node[], then: Node, otherwise: Node): Node =>
  masks.length > 0 ? g.select(any(g, masks), then, otherwise) : otherwise;

function curved(
  g: Graph,
  r: Recorder<unknown>,
  { symbols, system, form, solver }: Question,
  formula: CurvedFormula,
  ask: Ask,
): Program {
  const ar = r.arithmetic;
  const { values, inputs } = lift(g, r, symbols);
  const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], ar, values);
  const D = form.discriminant(formula, withScalars(values, { A, B, C }), ar);
  const format = system.format;
  const before = g.take();

  if (system.box) {
    const limits = (system.reach ? anySize : inTheBox)(g, r, system, { A, B, D }, inputs, before);
    const { rare, elsewhere, inside, clear, areInside } = limits;
    const special = specialOf(g, r, { A, B, C, D }, { elsewhere, lost: null, inside });
    const missed = r.isNegative(D);
    const [t, s] = solver({ scalars: { A, B, C, D }, vectors: {} }, ar);
    const [t0, t1] = r.sorted(t, s).map(g.unsigned) as [Node, Node];
    return {
      format,
      outputs: { t0, t1 },
      rare,
      special,
      missed,
      rareRoots: any(g, [...g.take(), g.not(areInside(t0, t1))]),
      inBlocks: system.inBlocks,
      classes: { margin: g.signed(missed, g.of(1)), rare: g.not(clear) },
    };
  }

  const shownD = r.shown(D);
  const [a, b, c] = [A, B, C].map(r.shown) as [Node, Node, Node];
  // What D does not depend on may have left the range though D is finite.
  const apart = [a, b, c].filter((x) => !dependsOn(shownD, x));
  const notFinite = (x: Node): Node => g.not(g.atMost(g.abs(x), g.of(system.greatest)));
  const unseen =
    format.width === 32 ? inputs.filter((x) => !dependsOn(shownD, x)).map(notFinite) : [];
  const lost = unseen.length > 0 ? any(g, unseen) : null;
  const inside = (t: Node): Node => g.isWithin(t, system.large);
  const special = specialOf(g, r, { A, B, C, D }, { elsewhere: null, lost, inside });
  if (ask === 'classes') {
    const small = (x: Node): Node => g.isWithin(x, system.wide);
    const large = (x: Node): Node => g.less(g.of(system.tiny), g.abs(x));
    const clear = [
      small(shownD),
      small(b),
      large(a),
      // C/q is bounded by A, B and D only where D was made of C.
      ...(apart.includes(c) ? [small(c), large(shownD), small(a)] : []),
    ].reduce((x, y) => g.and(x, y));
    return {
      format,
      outputs: { margin: shownD },
      rare: any(g, [g.isZero(shownD), ...unseen, g.not(clear)]),
      special,
      missed: null,
      rareRoots: null,
      inBlocks: false,
      classes: null,
    };
  }
  const [t, s] = solver({ scalars: { A, B, C, D }, vectors: {} }, ar);
  const [t0, t1] = r.sorted(t, s);
  const ends = t0.op === 'min' ? t0.args : [t0, t1];
  const size = ends.map(g.abs).reduce((x, y) => g.add(x, y));
  return {
    format,
    outputs: { t0, t1 },
    // Each is false where the roots are NaN because D < 0.
    rare: any(g, [
      g.atMost(g.of(system.large), size),
      g.atMost(size, g.of(0)),
      g.isZero(shownD),
      g.isZero(a),
      notFinite(shownD),
      ...apart.map(notFinite),
      ...unseen,
    ]),
    special,
    missed: null,
    rareRoots: null,
    inBlocks: false,
    classes: null,
  };
}

/** Where a loop's numbers are the trees', and so is what it makes of them. */
interface Limits extends Omit<Places, 'lost'> {
  /** Where D's sign alone does not tell what to do. */
  readonly rare: Node;
  /** Where a class is told without the roots. */
  readonly clear: Node;
  readonly areInside: (t0: Node, t1: Node) => Node;
}

type Decisive = Pick<Quadratic, 'A' | 'B' | 'D'>;
type LimitsOf = (
  g: Graph,
  r: Recorder<unknown>,
  system: System,
  of: Decisive,
  inputs: readonly Node[],
  before: readonly Node[],
) => Limits;

/** Inputs of the box, and A and D that are not tiny, keep all numbers in range. */
const inTheBox: LimitsOf = (g, r, system, { A, B, D }, inputs, before) => {
  const known = (x: unknown): Node => g.or(r.isNegative(x), r.isPositive(x));
  const positive = g.and(r.isPositive(D), g.not(r.isWithin(D, system.tiny)));
  const elsewhere = any(g, [...before, ...unusual(g, system, inputs)]);
  const inside = (t: Node): Node => g.isWithin(t, system.large);
  return {
    elsewhere,
    rare: any(g, [elsewhere, g.not(known(A)), g.not(g.or(r.isNegative(D), positive))]),
    inside,
    areInside: (t0, t1) => g.and(inside(t0), inside(t1)),
    clear: [
      g.not(r.isWithin(A, system.tiny)),
      r.isWithin(A, system.wide),
      g.or(r.isNegative(B), g.or(r.isPositive(B), r.isZero(B))),
    ].reduce((x, y) => g.and(x, y)),
  };
};

/**
 * Numbers of any size, of which only what overflows may differ from the trees': a product with 4
 * or 2 near the range's end, which they cut in halves and a loop does not. Where D overflowed here
 * it did so there, and that is their answer. A root is near enough by its product with all inputs.
 */
const anySize: LimitsOf = (g, r, system, of, inputs, before) => {
  const [A, B, D] = [of.A, of.B, of.D].map(r.shown) as [Node, Node, Node];
  const reach = system.reach as number;
  const times = (x: Node, k: number): Node => g.mul(x, g.of(k));
  const sum = sumOf(g, inputs);
  // So that a root is below 2^990, however small d is.
  const sized = g.add(sum, g.of(2 ** -490));
  const inside = (t: Node): Node => g.isWithin(g.mul(t, sized), system.large);
  const inputsAndB = g.add(times(g.abs(B), system.wide / reach), times(sum, SUM_TO_WIDE));
  const inRange = g.less(g.add(g.add(g.abs(A), g.abs(D)), inputsAndB), g.of(system.wide));
  const nearEnd = (x: Node, most: number): Node => g.and(g.not(g.isWithin(x, most)), g.isFinite(x));
  const apart = [
    ...unusual(g, system, inputs),
    nearEnd(A, system.wide / 4),
    nearEnd(B, reach / 4),
    nearEnd(D, system.wide / 4),
  ];
  const told = g.or(g.isFinite(D), g.isZero(A));
  // Both roots are at most (|B| + √D)/|A|, and a few units in the last place.
  const over = times(g.div(sized, A), 1 / reach);
  const half = g.add(g.abs(g.mul(B, over)), g.abs(g.mul(g.mul(D, over), over)));
  return {
    elsewhere: g.and(any(g, [...before, ...apart]), told),
    rare: any(g, [...before, g.not(inRange), g.isZero(A), g.isZero(D)]),
    inside,
    areInside: (t0, t1) => inside(g.add(g.abs(t0), g.abs(t1))),
    clear: g.or(r.isNegative(of.D), g.less(half, g.of(2 ** -10))),
  };
};

/** Brings 2^480, below which the sum of all inputs must be, to `wide`. */
const SUM_TO_WIDE = 2 ** 500;

interface Places {
  /** Where the numbers are not the trees'; null: nowhere. */
  readonly elsewhere: Node | null;
  /** Where a point may be NaN, so that the method has no hit. */
  readonly lost: Node | null;
  /** Whether a root and its place are in range. */
  readonly inside: (t: Node) => Node;
}

interface Quadratic {
  readonly A: unknown;
  readonly B: unknown;
  readonly C: unknown;
  readonly D: unknown;
}

/**
 * As methods/solvers.ts tells them apart.
 */
function specialOf(
  g: Graph,
  r: Recorder<unknown>,
  { A, B, C, D }: Quadratic,
  { elsewhere, lost, inside }: Places,
): Special {
  const ar = r.arithmetic;
  const place = (verdict: number): Node => g.of(verdict);
  const line = r.isZero(A);
  const twoA = ar.mul(ar.of(2), A);
  const linear = (B: unknown, C: unknown): unknown =>
    evaluate(LINEAR_ROOT, ar, { scalars: { B, C }, vectors: {} });
  const double = evaluate(DOUBLE_ROOT, ar, { scalars: { A, B }, vectors: {} });
  if (r.shown(linear(twoA, B)) !== r.shown(double)) {
    throw new RangeError('-C/B and -B/2A are no longer the same quotient');
  }
  const t = g.unsignedIfLoose(r.shown(linear(r.select(line, B, twoA), r.select(line, C, B))));
  // A denominator that may be 0: then there is no root.
  g.take();
  const [unknownA, unknownB, unknownC, unknownD] = [A, B, C, D].map(r.isUnknown) as Four;
  const ofC = g.select(
    unknownC,
    place(UNDECIDED),
    g.select(r.isZero(C), place(CONTAINED), place(NONE)),
  );
  const ofB = g.select(unknownB, place(UNDECIDED), g.select(r.isZero(B), ofC, place(ONE)));
  const ofD = g.select(
    unknownD,
    place(UNDECIDED),
    g.select(r.isZero(D), place(TANGENT), g.select(r.isNegative(D), place(NONE), place(ASK))),
  );
  const told = g.select(unknownA, place(UNDECIDED), g.select(line, ofB, ofD));
  const isRoot = g.or(g.equal(told, place(ONE)), g.equal(told, place(TANGENT)));
  const certain = lost ? g.and(inside(t), g.not(lost)) : inside(t);
  const asked = g.and(isRoot, g.not(certain));
  return {
    verdict: g.select(elsewhere ? g.or(elsewhere, asked) : asked, place(ASK), told),
    t: g.select(isRoot, t, g.of(Number.NaN)),
  };
}

type Four = [Node, Node, Node, Node];

function flat(
  g: Graph,
  r: Recorder<unknown>,
  { symbols, system, form }: Question,
  formula: FlatFormula,
  ask: Ask,
): Program {
  const ar = r.arithmetic;
  const { values, inputs } = lift(g, r, symbols);
  const rate = evaluate(formula.rate, ar, values);
  const offset = evaluate(formula.offset, ar, values);
  const before = g.take();
  const t = evaluate(formula.t, ar, withScalars(values, { rate }));
  const { x, excesses } = form.meeting(formula, withScalars(values, { rate, t }), ar);
  const shown = system.box ? g.unsigned(r.shown(t)) : r.shown(t);
  const marks = g.take();
  const outside = excesses.map(r.isPositive);
  const missed = outside.length > 0 ? any(g, outside) : null;
  const open = excesses.map((y, k) =>
    g.not(g.or(outside[k] as Node, g.or(r.isNegative(y), r.isZero(y)))),
  );
  // E + t d is no NaN; a place by the moment may be one.
  const places = x.filter((y) => !dependsOn(r.shown(y), shown));
  const bound = Math.sqrt(system.large);
  const sized = g.add(sumOf(g, inputs), g.of(2 ** -490));
  const near = g.isWithin(system.reach ? g.mul(shown, sized) : shown, bound);
  const elsewhere = [...before, ...unusual(g, system, inputs)];
  const rare = any(g, [
    ...marks,
    ...elsewhere,
    g.not(near),
    ...(system.box
      ? [g.not(g.or(r.isNegative(rate), r.isPositive(rate))), ...open]
      : [rate, ...excesses, ...places].map((y) => g.not(r.isWithin(y, bound)))),
  ]);
  const format = system.format;
  const none = g.of(Number.NaN);
  const roots = { t0: missed ? g.unless(missed, shown) : shown, t1: none };
  const margin = missed ? g.signed(missed, g.of(1)) : g.of(1);
  const outputs = ask === 'classes' ? { margin } : roots;
  const classes = ask === 'either' ? { margin, rare: null } : null;
  const place = (verdict: number): Node => g.of(verdict);
  const isParallel = r.isZero(rate);
  const ofOffset = g.select(
    r.isUnknown(offset),
    place(UNDECIDED),
    g.select(r.isZero(offset), place(CONTAINED), place(NONE)),
  );
  const unclear = excesses.map(r.isUnknown);
  const beyond = excesses.map((y) => g.and(r.isPositive(y), g.not(r.isUnknown(y))));
  // A root that overflowed is no answer.
  const lost = system.box ? [] : [g.not(g.isZero(g.sub(shown, shown)))];
  const apart = system.box ? [g.not(near), ...marks] : [];
  const undecided = where(g, [...unclear, ...lost], place(UNDECIDED), place(ASK));
  const ofFigure = where(g, apart, place(ASK), where(g, beyond, place(NONE), undecided));
  const told = g.select(
    r.isUnknown(rate),
    place(UNDECIDED),
    g.select(isParallel, ofOffset, ofFigure),
  );
  const verdict = where(g, elsewhere, place(ASK), told);
  const special = { verdict, t: none };
  return {
    format,
    outputs,
    rare,
    special,
    missed: null,
    rareRoots: null,
    inBlocks: false,
    classes,
  };
}
