import {
  type Answers,
  CONTAINED,
  type Kernel,
  NONE,
  ONE,
  type Rays,
  TANGENT,
  TWO,
  UNDECIDED,
} from './batch.ts';
import { kernelOf, type SolveRay, withoutRoots } from './loops.ts';
import {
  A,
  B,
  C,
  coefficients,
  D,
  discriminant,
  discriminantByMoment,
  FLARE,
  loadShape,
  REGISTERS,
  T0,
  T1,
  TWO_,
  X,
} from './machine-forms.ts';
import { isRoomy, isWhole, loadRay } from './machine-place.ts';
import type { Quadric } from './quadric.ts';
import type { Machine } from './register-machine.ts';

/** D by B² − 4AC, or by the moment; everything else is one program. */
export type DiscriminantBy = 'course' | 'moment';

/**
 * The stable solver over the course's A, B, C in a register machine: methods/tree-method.ts
 * unrolled, operation by operation. That class and roots are bit-equal to it is tested.
 */
export function machineQuadric(q: Quadric, machine: Machine, by: DiscriminantBy): Kernel {
  const R = new Float64Array(REGISTERS);
  loadShape(q, machine, R);
  // A hit's place and normal are only looked at where they might be no numbers.
  const slopes = 1 + machine.size(R, FLARE);
  const reach = Math.abs(q.Cx) + Math.abs(q.Cy) + Math.abs(q.Cz);
  const put = (rays: Rays, i: number): void => {
    loadRay(rays, i, machine, R);
    coefficients(q, machine, R);
    if (by === 'moment') discriminantByMoment(q, machine, R);
    else discriminant(machine, R);
  };
  const solved: SolveRay = (_, i, out) => {
    const verdict = solve(machine, R);
    if (verdict === NONE || verdict >= CONTAINED) return withoutRoots(out, i, verdict);
    return keep(q, machine, R, out, i, verdict, slopes, reach);
  };
  return kernelOf(
    'two',
    (rays, i, out) => {
      put(rays, i);
      return solved(rays, i, out);
    },
    (rays, i, out) => {
      put(rays, i);
      const signA = machine.sign(R, A);
      const signD = machine.sign(R, D);
      if (signA * signD < 0 || signA * signD > 0) {
        if (signD < 0) return NONE;
        if (isRoomy(machine, R, largestRoot(machine, R), slopes, reach)) return TWO;
      }
      return solved(rays, i, out);
    },
  );
}

/**
 * |t| is not above this: t = q/A and C/q, where |q| lies between √D and |B| + √D, halved; NaN where
 * the sign of B is not known.
 */
function largestRoot(m: Machine, R: Float64Array): number {
  const most = m.size(R, B) + Math.sqrt(m.size(R, D));
  const other = (2 * m.size(R, C)) / Math.sqrt(m.least(R, D));
  return Math.max(most / m.least(R, A), other) + 0 * m.sign(R, B);
}

/** methods/solvers.ts: the class, with one root in T0 or both in T0 and T1. */
function solve(m: Machine, R: Float64Array): number {
  const signA = m.sign(R, A);
  if (signA === 0) return solveLinear(m, R);
  const signD = m.sign(R, D);
  if (Number.isNaN(signA) || Number.isNaN(signD)) return UNDECIDED;
  if (signD < 0) return NONE;
  if (signD === 0) {
    m.neg(R, T0, B);
    m.mul(R, X, TWO_, A);
    m.div(R, T0, T0, X);
    return TANGENT;
  }
  m.sqrt(R, X, D);
  if (m.sign(R, B) < 0) m.sub(R, X, X, B);
  else {
    m.add(R, X, B, X);
    m.neg(R, X, X);
  }
  m.div(R, X, X, TWO_);
  m.div(R, T0, X, A);
  m.div(R, T1, C, X);
  m.sort(R, T0, T1);
  return TWO;
}

function solveLinear(m: Machine, R: Float64Array): number {
  const signB = m.sign(R, B);
  if (Number.isNaN(signB)) return UNDECIDED;
  if (signB !== 0) {
    m.neg(R, T0, C);
    m.div(R, T0, T0, B);
    return ONE;
  }
  const signC = m.sign(R, C);
  if (Number.isNaN(signC)) return UNDECIDED;
  return signC === 0 ? CONTAINED : NONE;
}

/** Writes the roots, unless one of them or its place or normal is no number. */
function keep(
  q: Quadric,
  m: Machine,
  R: Float64Array,
  out: Answers,
  i: number,
  verdict: number,
  slopes: number,
  reach: number,
): number {
  const t = Math.max(m.size(R, T0), verdict === TWO ? m.size(R, T1) : 0);
  const roomy = isRoomy(m, R, t, slopes, reach);
  if (!roomy && !isWhole(q, m, R, T0)) return withoutRoots(out, i, UNDECIDED);
  if (!roomy && verdict === TWO && !isWhole(q, m, R, T1)) return withoutRoots(out, i, UNDECIDED);
  m.store(R, T0, out.t0, i);
  if (verdict === TWO) m.store(R, T1, out.t1, i);
  else out.t1[i] = Number.NaN;
  return verdict;
}
