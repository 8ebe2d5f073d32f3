import { Graph, type Node } from '../../scripts/kernels/trees/graph.ts';
import {
  asksOf,
  lift,
  type Program,
  programOf,
  type Question,
} from '../../scripts/kernels/trees/program.ts';
import { bySign } from '../../src/math/arithmetic/arithmetic.ts';
import { NONE } from '../../src/math/batch/batch.ts';
import { evaluate, evaluateTriple, withScalars } from '../../src/math/formula/evaluate.ts';
import { STABLE_Q } from '../../src/math/methods/solvers.ts';
import type { CurvedFormula } from '../../src/math/shapes/axial-quadric.ts';

/*
 * Programs that no kernel is made of, compiled by the same generator to be timed beside those that
 * are: what would be cheaper if it were right, and what was tried.
 */

export type CurvedQuestion = Question & { readonly formula: CurvedFormula };

/** Two numbers that `oneRoot` takes after the shape's. */
export const RANGE = ['tMin', 'tMax'] as const;

/** What is left of a program when nothing is asked beside the answers. */
function bare(g: Graph, t0: Node, t1: Node, rare: readonly Node[]): Program {
  const never = g.less(g.of(1), g.of(0));
  return {
    format: g.format,
    outputs: { t0, t1 },
    rare: rare.reduce((a, b) => g.or(a, b), never),
    special: { verdict: g.of(NONE), t: g.of(Number.NaN) },
    missed: null,
    rareRoots: null,
    inBlocks: false,
    classes: null,
  };
}

/** A number of the pair or of the interval, near enough to compare sizes by. */
const leading = (x: unknown): Node =>
  typeof x === 'object' && x !== null && 'hi' in x ? (x.hi as Node) : (x as Node);

/** A program as it is, and what it is made of. */
function parted(question: CurvedQuestion) {
  const { system, symbols, form, formula } = question;
  const g = new Graph(system.format);
  const program = programOf(question, asksOf(system)[0] ?? 'both', g);
  const r = system.make(g);
  const { values } = lift(g, r, symbols);
  const [A, B, C] = evaluateTriple([formula.A, formula.B, formula.C], r.arithmetic, values);
  const D = form.discriminant(formula, withScalars(values, { A, B, C }), r.arithmetic);
  return { g, r, program, A, B, C, D };
}

/**
 * The first root in the range, of which alone the quotient is worked out. Both solvers have two
 * quotients: which is the lesser one is told by signs, and whether it is below tMin by a product
 * with the denominator, with some room. Rays near the room's edges are rare, and so is one whose
 * root then turns out to be below tMin. It asks less than a kernel would have to: not whether the
 * other root is in range.
 */
export function oneRoot(question: CurvedQuestion): Program {
  const { g, r, program, A, B, C, D } = parted(question);
  const { format, far } = RANGES[question.system.format.width];
  const [tMin, tMax] = RANGE.map(g.number) as [Node, Node];
  const zero = g.of(0);
  const below = g.sub(g.sub(tMin, g.mul(g.abs(tMin), g.of(format))), g.of(1 / far));
  const isBelow = (over: Node, under: Node): Node =>
    g.less(g.signed(g.less(under, zero), over), g.mul(g.abs(under), below));

  const { t0, t1 } = program.outputs;
  const [x, turned] = t0?.args[0]?.args ?? [];
  let t: Node;
  let isFar: Node;
  let unclear: Node;
  if (t0?.op === 'div' && t1?.op === 'div' && x && turned?.op === 'signed') {
    // (x ∓ s)/w.
    const [under, w] = t0.args as [Node, Node];
    isFar = isBelow(under, w);
    t = g.div(g.sub(x, g.signed(isFar, turned)), w);
    const reach = g.add(g.abs(x), turned.args[1] as Node);
    const size = g.abs(w);
    unclear = g.or(
      g.atMost(g.mul(size, g.of(far)), reach),
      g.atMost(g.mul(reach, g.of(far)), size),
    );
  } else {
    // q/A and C/q.
    const ar = r.arithmetic;
    const of = (which: 0 | 1): unknown =>
      evaluate(STABLE_Q[which], ar, { scalars: { A, B, C, D }, vectors: {} });
    const q = bySign(
      B,
      () => of(1),
      () => of(0),
      ar,
    );
    const either = (a: Node, b: Node): Node => g.or(g.and(a, g.not(b)), g.and(b, g.not(a)));
    const isFirst = either(r.isNegative(q), r.isNegative(A));
    const [a, c, k] = [A, C, q].map(leading) as [Node, Node, Node];
    isFar = g.or(g.and(isFirst, isBelow(k, a)), g.and(g.not(isFirst), isBelow(c, k)));
    const byA = either(isFirst, isFar);
    const found = r.shown(ar.div(r.select(byA, q, C), r.select(byA, A, q)));
    t = question.system.box ? g.unsigned(found) : found;
    unclear = g.or(
      g.not(g.less(g.mul(g.abs(g.mul(a, c)), g.of(1 + 2 ** -40)), g.mul(k, k))),
      g.not(g.isWithin(t, far)),
    );
    g.take();
  }
  const isIn = g.and(g.atMost(tMin, t), g.atMost(t, tMax));
  const outputs = { t0: g.unless(g.not(isIn), t), t1: g.of(Number.NaN) };
  const isWrong = g.or(unclear, g.and(g.not(isFar), g.less(t, tMin)));
  if (program.missed) return { ...program, outputs, rareRoots: isWrong };
  const d = r.shown(D);
  const rare = g.or(g.or(g.isZero(d), g.isZero(r.shown(A))), g.not(g.isFinite(d)));
  return { ...program, outputs, rare: g.or(rare, g.and(isWrong, g.not(g.less(d, zero)))) };
}

/** What products are rounded by, with room; and sizes of roots that are not rare. */
const RANGES = {
  32: { format: 2 ** -21, far: 2 ** 100 },
  64: { format: 2 ** -50, far: 2 ** 500 },
} as const;

/** What is made of `stable`, and a program of other roots t and s with its rare cases. */
function stableParts(question: CurvedQuestion) {
  const { g, r, program, A, C, D } = parted(question);
  const q = program.outputs.t0?.args[0]?.args[0];
  if (q?.op !== 'signed') throw new RangeError('stable no longer divides a signed q by A');
  const [a, c] = [A, C] as [Node, Node];
  const d = r.shown(D);
  const trial = (t: Node, s: Node, t0: Node, t1: Node): Program => {
    const size = g.add(g.abs(t), g.abs(s));
    const rare = [
      g.atMost(g.of(question.system.large), size),
      g.atMost(size, g.of(0)),
      g.isZero(d),
      g.isZero(a),
      g.not(g.isFinite(d)),
    ];
    return { ...bare(g, t0, t1, rare), special: program.special };
  };
  return { g, q, a, c, trial };
}

/** `stable`, but q always of the same sign, and the roots in the order that they come in. */
export function unordered(question: CurvedQuestion): Program {
  const { g, q, a, c, trial } = stableParts(question);
  const positive = q.args[1] as Node;
  const [t, s] = [g.div(positive, a), g.div(c, positive)];
  return trial(t, s, t, s);
}

/** `stable`, its roots put in order by products with 0 and 1: the sign of a zero is lost. */
export function orderedByProducts(question: CurvedQuestion): Program {
  const { g, q, a, c, trial } = stableParts(question);
  const [t, s] = [g.div(q, a), g.div(c, q)];
  const later = g.less(s, t);
  const program = trial(t, s, g.select(later, s, t), g.select(later, t, s));
  return { ...program, format: { ...g.format, strict: false } };
}

/** Reads the six arrays of a ray and writes two answers. */
export function reading({ system }: Question): Program {
  const g = new Graph(system.format);
  const [Ex, Ey, Ez, dx, dy, dz] = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'].map(g.input) as Six;
  return bare(g, g.add(g.add(Ex, Ey), Ez), g.add(g.add(dx, dy), dz), []);
}

type Six = [Node, Node, Node, Node, Node, Node];

/** Chains that do not wait for one another, and the steps of each. */
const CHAINS = 8;
const STEPS = 16;
export const PIECES = CHAINS * STEPS;

/** What a program does again and again, as one more step from x. */
export const STEP = {
  '+ −': (g: Graph, x: Node, k: Node): Node => g.add(x, k),
  '×': (g: Graph, x: Node): Node => g.mul(x, g.of(1.0625)),
  '÷': (g: Graph, x: Node, k: Node): Node => g.div(k, x),
  '√': (g: Graph, x: Node): Node => g.sqrt(x),
  choices: (g: Graph, x: Node, k: Node): Node => g.signed(g.less(x, k), x),
} as const;

export type Piece = keyof typeof STEP;

/** PIECES steps of one kind. */
export function steps({ system }: Question, piece: Piece): Program {
  const g = new Graph({ ...system.format, strict: true });
  const inputs = ['Ex', 'Ey', 'Ez', 'dx', 'dy', 'dz'].map(g.input);
  const ends = Array.from({ length: CHAINS }, (_, k) => {
    let x = g.add(g.abs(inputs[k % 6] as Node), g.of(k));
    for (let n = 0; n < STEPS; n++) x = STEP[piece](g, x, inputs[(k + n) % 6] as Node);
    return x;
  });
  const sum = ends.reduce((a, b) => g.add(a, b));
  return bare(g, sum, sum, []);
}
