import type { Arithmetic } from '../arithmetic/arithmetic.ts';
import type { Triple, Values } from '../formula/evaluate.ts';
import { comp, num, plus, type Relation, scalar, times } from '../formula/expr.ts';
import { lazily } from '../lazily.ts';
import { type Axis, axisIndex, type Vec3 } from '../vec3.ts';
import { planarBody } from './body.ts';
import type { ShapeDefinition } from './define.ts';
import { drawSquare, inPlaneAxes, unitAlong } from './flat-drawing.ts';
import { pointGrip, sideGrip } from './grips.ts';
import type { PlanarNumbers } from './numbers.ts';
import { LENGTH, POINT } from './params.ts';
import { type Bound, type FlatFormula, planarFormula, planarSurface } from './planar.ts';

/**
 * A square with sides along the axes, from its corner towards larger coordinates; its normal points
 * along +axis.
 */
export interface Square {
  readonly kind: 'square';
  readonly corner: Vec3;
  readonly side: number;
  readonly axis: Axis;
}

/** Px ≤ x and x ≤ Px + L. */
function between(axis: Axis): Relation[] {
  const corner = comp('P', axis);
  return [
    { left: corner, relation: '≤', right: scalar(axis) },
    { left: scalar(axis), relation: '≤', right: plus(corner, scalar('L')) },
  ];
}

/** 0 ≤ w and w ≤ L |N·d|: Px + L, which need not be a double, does not occur. */
function betweenByMoment(axis: Axis): Relation[] {
  const w = comp('w', axis);
  return [
    { left: num(0), relation: '≤', right: w },
    { left: w, relation: '≤', right: times(scalar('L'), scalar('rate')) },
  ];
}

/** How far x lies beyond the interval [from, from + length]; 0 inside. */
function beyond<T>(x: T, from: T, length: T, ar: Arithmetic<T>): T {
  const before = ar.sub(from, x);
  if (ar.sign(before) > 0) return before;
  const after = ar.sub(ar.sub(x, from), length);
  return ar.sign(after) > 0 ? after : ar.of(0);
}

function boundOf(axis: Axis): Bound {
  const [first, second] = inPlaneAxes(axis);
  const i = axisIndex(first);
  const j = axisIndex(second);
  return {
    conditions: [first, second].sort().flatMap(between),
    momentConditions: [first, second].sort().flatMap(betweenByMoment),
    distance(x, values, ar) {
      const { P, L } = get(values);
      const u = beyond(x[i], P[i], L, ar);
      const v = beyond(x[j], P[j], L, ar);
      return ar.sqrt(ar.add(ar.sqr(u), ar.sqr(v)));
    },
    span: (values, ar) => common(throughSlab(values, ar, i), throughSlab(values, ar, j), ar),
    meetsLine: (values, ar) => cornersOnBothSides(values, ar, i, j),
  };
}

const get = <T>(values: Values<T>) => ({
  E: values.vectors.E as Triple<T>,
  d: values.vectors.d as Triple<T>,
  P: values.vectors.P as Triple<T>,
  L: values.scalars.L as T,
});

type Span<T> = readonly [T, T] | 'always' | null;

/** The t at which P ≤ E + t d ≤ P + L, in one coordinate. */
function throughSlab<T>(values: Values<T>, ar: Arithmetic<T>, i: 0 | 1 | 2): Span<T> {
  const { E, d, P, L } = get(values);
  const from = ar.sub(P[i], E[i]);
  const to = ar.add(from, L);
  const rate = d[i];
  const turn = ar.sign(rate);
  if (turn === 0) return ar.sign(from) <= 0 && ar.sign(to) >= 0 ? 'always' : null;
  const [first, second] = turn > 0 ? [from, to] : [to, from];
  return [ar.div(first, rate), ar.div(second, rate)];
}

/** Both at once; a line along neither coordinate would be no line. */
function common<T>(a: Span<T>, b: Span<T>, ar: Arithmetic<T>): readonly [T, T] | null {
  if (a === null || b === null) return null;
  if (a === 'always') return b === 'always' ? null : b;
  if (b === 'always') return a;
  const from = ar.sign(ar.sub(a[0], b[0])) > 0 ? a[0] : b[0];
  const to = ar.sign(ar.sub(a[1], b[1])) < 0 ? a[1] : b[1];
  return ar.sign(ar.sub(to, from)) < 0 ? null : [from, to];
}

/** A line meets a square iff its corners do not all lie strictly on one side of it. */
function cornersOnBothSides<T>(
  values: Values<T>,
  ar: Arithmetic<T>,
  i: 0 | 1 | 2,
  j: 0 | 1 | 2,
): boolean | null {
  const { E, d, P, L } = get(values);
  const none = ar.of(0);
  const side = (u: T, v: T): number => {
    const x = ar.add(ar.sub(P[i], E[i]), u);
    const y = ar.add(ar.sub(P[j], E[j]), v);
    return ar.sign(ar.sub(ar.mul(d[i], y), ar.mul(d[j], x)));
  };
  const signs = [side(none, none), side(L, none), side(none, L), side(L, L)];
  if (signs.some(Number.isNaN)) return null;
  return Math.min(...signs) <= 0 && Math.max(...signs) >= 0;
}

const FORMULAS: Readonly<Record<Axis, () => FlatFormula>> = {
  x: lazily(() => planarFormula('P', boundOf('x'))),
  y: lazily(() => planarFormula('P', boundOf('y'))),
  z: lazily(() => planarFormula('P', boundOf('z'))),
};
const surface = lazily(() => planarSurface('P'));

const NUMBERS: PlanarNumbers<Square> = {
  family: 'planar',
  read: ({ corner, side, axis }) => {
    const n = axisIndex(axis);
    return {
      N: unitAlong(axis),
      P: corner,
      bound: 'square',
      size: side,
      u: n === 0 ? 1 : 0,
      v: n === 2 ? 1 : 2,
    };
  },
};

/**
 * A square with sides along two of the axes: its edges belong to it.
 * The entry of SHAPES, for `prepareWith`.
 */
export const square: ShapeDefinition<Square> = {
  kind: 'square',
  title: 'square',
  named: ({ side }) => ({
    name: 'square',
    singular: null,
    straight: null,
    border:
      side === 0
        ? Array(4).fill('the corner, all that is left of the square')
        : ['on an edge, which belongs to the square', 'at a corner, which belongs to the square'],
  }),
  icon: 'M12 5.5L21.5 12L12 18.5L2.5 12z',
  params: [
    { ...POINT, key: 'corner', symbol: 'P', title: 'corner', initial: [0, 0, -1] },
    { ...LENGTH, key: 'side', symbol: 'L', title: 'side', initial: 2 },
    { type: 'axis', key: 'axis', symbol: 'axis', title: 'axis of the normal', initial: 'x' },
  ],
  get surface() {
    return surface();
  },
  formula: ({ axis }) => FORMULAS[axis](),
  values: ({ corner, side, axis }) => ({
    scalars: { L: side },
    vectors: { N: unitAlong(axis), P: corner },
  }),
  numbers: NUMBERS,
  body: lazily(() => planarBody(NUMBERS.read)),
  ownFamilies: true,
  meaning: ({ side }) => (side === 0 ? 'L = 0: only the corner is left' : ''),
  anchor: ({ corner, side, axis }) => ({
    at: middle(corner, side, axis),
    size: side * Math.SQRT1_2,
  }),
  draw: ({ corner, side, axis }) => ({
    ...drawSquare(axis, corner, side),
    grips: [pointGrip('corner', corner), sideGrip('side', corner, side, axis)],
  }),
};

function middle(corner: Vec3, side: number, axis: Axis): Vec3 {
  const half = (k: Axis): number => corner[axisIndex(k)] + (k === axis ? 0 : side / 2);
  return [half('x'), half('y'), half('z')];
}
