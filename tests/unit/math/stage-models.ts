import { createAnswers, packRays } from '../../../src/math/batch/batch.ts';
import type { Quadric } from '../../../src/math/batch/quadric.ts';
import { SPLITTER, sumError } from '../../../src/math/float/eft.ts';
import { LEAST_A, momentError, SMALLEST_D } from '../../../src/math/methods/certified/class.ts';
import * as numbers from '../../../src/math/methods/certified/numbers.ts';
import * as recentred from '../../../src/math/methods/certified/recentred.ts';
import * as refined from '../../../src/math/methods/certified/refined.ts';
import * as units from '../../../src/math/methods/certified/units.ts';
import type { Ray } from '../../../src/math/ray.ts';
import { abs, add, cut, defined, div, mul, sqrt, sub } from './operation-errors.ts';
import { known, negative, type Off } from './running-error.ts';

/*
 * The stages for curved shapes written once more, for one ray, by operations that count what they
 * may be off. Each model is compared with its stage: the same verdict and, where the stage answers
 * or hands on, the same bits. So what a model says of its own values holds for the stage's.
 *
 * Of a shape that does not look at y, k, a and what is made of dy and Ey are 0.
 */

const { BOX, FAITHFUL, FAITHFUL_ONCE, GRID_25, GRID_26, GRID_P } = numbers;
const ONE = known(1);
const HALF = known(0.5);
const [GRID25, GRID26, GRIDP] = [known(GRID_25), known(GRID_26), known(GRID_P)];

type Three = readonly [x: Off, y: Off, z: Off];
const three = (make: (i: 0 | 1 | 2) => Off): Three => [make(0), make(1), make(2)];
/** |x| + |y| + |z|. */
const sizeOf = ([x, y, z]: Three): Off => add(add(abs(x), abs(y)), abs(z));

/** A ray and a shape as the stages on grids take them. */
function cutBy(q: Quadric, ray: Ray) {
  const c = numbers.certifiedQuadric(q);
  const numberOf = (name: keyof typeof numbers.AT_SCALED): Off =>
    known(c.numbers[numbers.AT_SCALED[name]] as number);
  const [k, k1, k2, sign] = [numberOf('k'), numberOf('k1'), numberOf('k2'), numberOf('sign')];
  const [rho, rhoLow] = [numberOf('rho'), numberOf('rhoLow')];
  const [x, dy, z] = ray.direction;
  const [ex, ey, ez] = ray.origin;
  const rise = q.hasY ? dy : 0;
  const height = q.hasY ? ey : q.Cy;
  const [px, py, pz] = [ex - q.Cx, height - q.Cy, ez - q.Cz];
  const lost = [sumError(ex, -q.Cx, px), sumError(height, -q.Cy, py), sumError(ez, -q.Cz, pz)];
  const half = (v: number): number => SPLITTER * v - (SPLITTER * v - v);
  /** k·v: the leading product, which is exact, and the rest. */
  const stretched = (v: number): readonly [lead: Off, rest: Off] => {
    const top = known(half(v));
    return [mul(k1, top), add(mul(k1, sub(known(v), top)), mul(k2, known(v)))];
  };
  const [leadD, restD] = stretched(rise);
  const [leadP, rest] = stretched(py);
  const restP = add(rest, mul(k, known(lost[1] as number)));
  const leadingD: Three = [known(x), leadD, known(z)];
  const leadingP: Three = [known(px), leadP, known(pz)];
  const restsD: Three = [known(0), restD, known(0)];
  const restsP: Three = [known(lost[0] as number), restP, known(lost[2] as number)];
  const d: Three = [known(x), add(leadD, restD), known(z)];
  /** u·v of the shape: ux vx + uz vz ∓ uy vy. */
  const form = (u: Three, v: Three): Off =>
    sub(add(mul(u[0], v[0]), mul(u[2], v[2])), mul(sign, mul(u[1], v[1])));
  /** d and p on their grids, and what is left. */
  const onGrids = (gridD: Off, gridP: Off) => {
    const dh = three((i) => cut(leadingD[i], gridD));
    const dl = three((i) => add(sub(leadingD[i], dh[i]), restsD[i]));
    const ph = three((i) => cut(leadingP[i], gridP));
    const pl = three((i) => add(sub(leadingP[i], ph[i]), restsP[i]));
    return { dh, dl, ph, pl };
  };
  /** q + rest on the grid for |q|, and what is left; f = q·q − ρ. */
  const residual = (q: Three, rest: Three) => {
    const size = sizeOf(q);
    const grid = mul(GRID26, size);
    const qh = three((i) => cut(q[i], grid));
    const ql = three((i) => add(sub(q[i], qh[i]), rest[i]));
    const twice = three((i) => add(add(qh[i], qh[i]), ql[i]));
    const f = add(sub(form(qh, qh), rho), sub(form(ql, twice), rhoLow));
    return { size, qh, ql, f };
  };
  const [dx, dy2, dz] = d;
  const round = add(mul(dx, dx), mul(dz, dz));
  const yy = mul(dy2, dy2);
  return {
    ...{ k, sign, rho, py: known(py), d, leadingP, form, onGrids, residual, round, yy },
    A: sub(round, mul(sign, yy)),
    speed: defined(sizeOf(d)),
    reachP: sizeOf(leadingP),
  };
}

const inBox = (speed: number, reach: number): boolean =>
  speed < BOX && speed * BOX > 1 && reach < BOX;

/** `formed`: with A, b and D taken as they are. */
export function recentredModel(q: Quadric, ray: Ray, formed = false) {
  const as = formed ? defined : (x: Off): Off => x;
  const s = cutBy(q, ray);
  const { d, speed, form } = s;
  const A = as(s.A);
  const slope = form(d, s.leadingP);
  const inverse = div(ONE, mul(A, speed));
  const overA = mul(inverse, speed);
  const middle = mul(negative(slope), overA);
  const reach = add(mul(abs(middle), speed), s.reachP);
  const gridT = mul(GRID25, mul(abs(mul(inverse, A)), reach));
  const { dh, dl, ph, pl } = s.onGrids(mul(GRID25, speed), mul(GRIDP, reach));
  const t = cut(middle, gridT);
  const at = three((i) => add(ph[i], mul(t, dh[i])));
  const { size, qh, ql, f } = s.residual(
    at,
    three((i) => add(mul(t, dl[i]), pl[i])),
  );
  const cross = (i: 0 | 1 | 2): Off => add(mul(ql[i], d[i]), mul(qh[i], dl[i]));
  // In the order of the stage: x's two products, then z's together.
  const round = add(cross(0), cross(2));
  const b = as(add(form(qh, dh), sub(round, mul(s.sign, cross(1)))));
  const D = as(sub(mul(b, b), mul(A, f)));
  const width = size.x + reach.x;
  const sizeB = Math.abs(b.x);
  const square = speed.x * speed.x;
  const charged = recentred.CROSS_ERROR * width;
  const error =
    sizeB * (charged * speed.x + recentred.SLOPE_SQUARE_ERROR * sizeB) +
    square *
      (charged * (size.x + recentred.NARROW_RECENTRED * width) +
        recentred.RESIDUAL_SHARE * Math.abs(f.x)) +
    SMALLEST_D;
  const inside = inBox(speed.x, s.reachP.x);
  const certainA = !q.hasY || Math.abs(A.x) > LEAST_A * (s.round.x + s.yy.x);
  const clear = D.x > 2 * error && inside && certainA;
  const missed = D.x < -error && inside;
  const root = sqrt(D);
  const overSize = Math.abs(overA.x);
  /** A root's distance from the point that both are seen from: what is added to t last. */
  const around = sub(mul(root, abs(overA)), mul(b, overA));
  const near = t.x + (-b.x * overA.x - root.x * overSize);
  const far = t.x + around.x;
  const off =
    (recentred.SLOPE_ERROR * width * speed.x +
      (0.6 * error) / root.x +
      (sizeB + root.x) * (recentred.CLOSED_A * square * overSize + recentred.CLOSED)) *
    overSize;
  const settled = off <= FAITHFUL_ONCE * Math.abs(near) && off <= FAITHFUL_ONCE * Math.abs(far);
  return {
    ...{ A, b, D, f, t, around, speed: speed.x, size: size.x, width, square, sizeB, overSize },
    ...{ root: root.x, overA: overA.x, error, off, near, far, inside, clear, missed, settled },
  };
}

export function refinedModel(q: Quadric, ray: Ray) {
  const s = cutBy(q, ray);
  const { d, k, sign, rho, A, form, speed } = s;
  const [px, , pz] = s.leadingP;
  const p: Three = [px, mul(k, s.py), pz];
  const minor = (i: 0 | 1 | 2, j: 0 | 1 | 2): Off => sub(mul(d[i], p[j]), mul(d[j], p[i]));
  const m: Three = [minor(1, 2), minor(2, 0), minor(0, 1)];
  const squares = three((i) => mul(m[i], m[i]));
  const outer = mul(sign, add(squares[0], squares[2]));
  const D = sub(add(mul(rho, A), outer), squares[1]);
  const S = speed.x * s.reachP.x;
  const Am = s.round.x + s.yy.x;
  const error = momentError(S, sizeOf(m).x, rho.x * Am);
  const inside = inBox(speed.x, s.reachP.x);
  const clear =
    D.x > refined.CLEAR_REFINED * error &&
    inside &&
    D.x > refined.APART * (S * S) &&
    Math.abs(A.x) > LEAST_A * Am;
  const slope = form(d, p);
  const root = sqrt(D);
  const As = mul(A, root);
  const inverse = div(ONE, mul(As, speed));
  const overA = mul(inverse, mul(root, speed));
  const half = mul(mul(HALF, inverse), mul(A, speed));
  const over = mul(inverse, As);
  const ta = defined(mul(sub(negative(slope), root), overA));
  const tb = defined(mul(sub(root, slope), overA));
  const reachOf = (t: Off): Off => add(mul(abs(t), speed), s.reachP);
  const reaches = add(reachOf(ta), reachOf(tb));
  const { dh, dl, ph, pl } = s.onGrids(mul(GRID25, speed), mul(GRIDP, reaches));
  /** The residual at a rough root, and what the step from there is charged with. */
  const at = (t: Off) => {
    const reach = reachOf(t);
    const th = cut(t, mul(GRID25, mul(over, reach)));
    const tl = sub(t, th);
    const { size, f } = s.residual(
      three((i) => add(ph[i], mul(th, dh[i]))),
      three((i) => add(add(mul(th, dl[i]), mul(tl, d[i])), pl[i])),
    );
    const width = size.x + reach.x;
    const own = refined.RESIDUAL_ERROR * width * (size.x + refined.NARROW_REFINED * width);
    const error = half.x * (own + refined.STEP_ERROR * Math.abs(f.x));
    return { t: t.x, f, size: size.x, width, error };
  };
  const [a, b] = [at(ta), at(tb)];
  const ra = a.t + a.f.x * half.x;
  const rb = b.t - b.f.x * half.x;
  const [f, g] = [Math.abs(a.f.x), Math.abs(b.f.x)];
  /** Whether it is settled but for the size of its error. */
  const allowed =
    reaches.x <= refined.SPREAD * s.reachP.x && (f + g) * Math.abs(A.x) <= refined.STEP_SHARE * D.x;
  const settled =
    a.error <= FAITHFUL * Math.abs(ra) && b.error <= FAITHFUL * Math.abs(rb) && allowed;
  return {
    ...{ A, D, a, b, ra, rb, half: half.x, root: root.x, error, inside, clear, allowed, settled },
    missed: false,
    near: Math.min(ra, rb),
    far: Math.max(ra, rb),
  };
}

/** Pass 1 over ordinary rays. */
export function roughModel(q: Quadric, lattice: numbers.Lattice, { origin, direction }: Ray) {
  const at = (name: keyof typeof numbers.AT_LATTICE): number =>
    lattice[numbers.AT_LATTICE[name]] as number;
  const a = q.hasY ? at('a') : 0;
  const [x, y, z] = direction;
  const [px, py, pz] = [origin[0] - q.Cx, origin[1] - q.Cy, origin[2] - q.Cz];
  const [round, ayy] = [x * x + z * z, a * (y * y)];
  const [wide, app] = [px * px + pz * pz, a * (py * py)];
  const A = round - ayy;
  const b = x * px + z * pz - a * (y * py);
  const D = b * b - A * (wide - app - at('rho'));
  const Am = round + Math.abs(ayy);
  const Q = Am * (wide + Math.abs(app) + at('rho'));
  const smallest = at('smallest');
  const fits = Am > at('smallestDirection') && Am < at('largestDirection');
  const root = Math.sqrt(D);
  const inverse = 1 / (A * D);
  const over = inverse * D;
  const h = root * Math.abs(over);
  const middle = -b * over;
  return {
    ...{ A, D, Q, root, fits, near: middle - h, far: middle + h, slope: A * h },
    clear:
      D > units.CLEAR_ROUGH * Q + smallest && fits && (!q.hasY || Math.abs(A) > units.LEAST * Am),
    missed: D < units.CERTAIN * Q - smallest && fits,
  };
}

const out = createAnswers(1);
const scratch = units.createScratch();
const coarse = [units.coarseAroundAxis(scratch), units.coarseInSpace(scratch)] as const;

/** The model of a stage, once it is known to be what the stage does with this ray. */
function agreed<M>(model: M, stage: readonly unknown[], expected: readonly unknown[]): M {
  if (stage.some((x, k) => !Object.is(x, expected[k])))
    throw new Error(`the stage has ${stage}, its model ${expected}`);
  return model;
}

interface Answering {
  readonly near: number;
  readonly far: number;
  readonly clear: boolean;
  readonly settled: boolean;
  readonly missed: boolean;
}

/** Not Object.is: a root that is 0 has either sign. */
const unsigned = (t: number): number => t + 0;

function asAnswered<M extends Answering>(model: M, left: number): M {
  const { clear, settled, missed, near, far } = model;
  const answered = clear && settled;
  const open = !answered && (clear || !missed);
  const roots = answered ? [near, far] : open ? [-1, -1] : [Number.NaN, Number.NaN];
  const found = [out.t0[0] as number, out.t1[0] as number];
  return agreed(model, [left, ...found.map(unsigned)], [open ? 1 : 0, ...roots.map(unsigned)]);
}

const answeredBy = (pass: recentred.RecentredPass, q: Quadric, ray: Ray): number => {
  out.t0[0] = -1;
  out.t1[0] = -1;
  return pass(numbers.certifiedQuadric(q).numbers, packRays([ray]), out, Int32Array.of(0), 1);
};

export function recentredLike(q: Quadric, ray: Ray) {
  const pass = q.hasY ? recentred.recentredInSpace : recentred.recentredAroundAxis;
  return asAnswered(recentredModel(q, ray), answeredBy(pass, q, ray));
}

export const refinedLike = (q: Quadric, ray: Ray) =>
  asAnswered(
    refinedModel(q, ray),
    answeredBy(
      (n, rays, out, places, count) => refined.refine(n, q.hasY, rays, out, places, count),
      q,
      ray,
    ),
  );

export function roughLike(q: Quadric, lattice: numbers.Lattice, ray: Ray) {
  const model = roughModel(q, lattice, ray);
  const { clear, missed, A, near, far, slope } = model;
  out.t0[0] = -1;
  coarse[q.hasY ? 1 : 0](lattice, packRays([ray]), out, 0, 1);
  const handed = [scratch.A, scratch.near, scratch.far, scratch.slope].map(([x]) => x);
  return agreed(
    model,
    [scratch.count[units.HITS], Number.isNaN(out.t0[0]), ...(clear ? handed : [])],
    [clear ? 1 : 0, !clear && missed, A, near, far, slope],
  );
}
