import { CONTAINED, NONE, ONE, TANGENT, TWO } from '../../batch/batch.ts';
import type { RootSlot } from '../../batch/exact-quadric.ts';
import type { Quadric } from '../../batch/quadric.ts';
import {
  accumulate,
  accumulateProduct,
  exactlyZero,
  LEVELS,
  newLevels,
} from '../../float/accumulate.ts';
import * as dd from '../../float/double-double.ts';
import {
  LEAST_EXACT_PRODUCT,
  productError,
  SPLITTER,
  squareError,
  sumError,
} from '../../float/eft.ts';
import { lazily } from '../../lazily.ts';
import type { Ray } from '../../ray.ts';
import { UU } from './numbers.ts';

/*
 * A, b = B/2, C and D/4 = b² − AC as sums of two doubles. u = 2^-53. Sums and products of doubles
 * are split without loss (eft.ts); p = E − C is two doubles exactly, so are c² and r². Only the
 * lower halves are rounded when they are added up, and their own small products left out:
 *
 *   quantity        bound         reason
 *   A               14u² Am       lower halves: of two sums, three products, a·(y²'s), a's; 5
 *                                 steps, the first of them on most of these; 1u² left out
 *   b               23u² bm       the same, and p's lower half in each product: 2 steps more, and
 *                                 3u² left out
 *   C               36u² Cm       the same with twice p's lower half; one sum more, and ρ's lower
 *                                 half: 2 steps; 4u² left out
 *   D/4 = b² − AC   124u² AmCm    2|b|δb + |A|δC + |C|δA ≤ 96u²; lower halves of b², AC and their
 *                                 difference, and of b, A, C: 14u² of b² + |AC|
 *
 * with Am = dx² + dz² + |a|dy², Cm = px² + pz² + |a|py² + ρ, bm = |dx px| + |dz pz| + |a dy py| ≤
 * √(Am Cm). A product that leaves the doubles is off by ≤ 2^-1072, with what multiplies its lower
 * half; that many times 2^200, by a, or if a = c² is what leaves them by y·y', are SMALLEST_ALGEBRA
 * in A, b and C, and these 2^202 times in D (dy was let grow beyond any bound: tests/repro). What
 * is then divided is above 2^-968, where products are split without loss.
 */
/** Bounds of the table: of A in Am, b in bm, C in Cm, D/4 in AmCm; then absolute ones. */
export const ERROR_A = 15 * UU;
export const ERROR_B = 24 * UU;
export const ERROR_C = 38 * UU;
export const ERROR_D = 136 * UU;
export const SMALLEST_ALGEBRA = 2 ** -872;
export const SMALLEST_ALGEBRA_D = 2 ** -670;
export const LARGE = 2 ** 200;

/**
 * What is known of a ray and a shape: A, b, C and D/4 as two doubles each, their error bounds, p =
 * E − C and a as two doubles each, and AmCm, which is NaN where the bounds mean nothing. putAlgebra
 * and putShort write all of it. Each stage has one of its own, as each may have the ray in units of
 * its own: one that they shared was refilled in other units by a call between writing and reading
 * (tests/repro).
 */
export type Algebra = Float64Array;
/** An `Algebra` of zeros. */
export const createAlgebra = (): Algebra => new Float64Array(21);

/**
 * Indices into `Algebra`; `…_LOW` is the lower half of the number before, OFF a bound on |error|.
 */
export const AT_A = 0;
export const AT_A_LOW = 1;
export const AT_B = 2;
export const AT_B_LOW = 3;
export const AT_C = 4;
export const AT_C_LOW = 5;
export const AT_D = 6;
export const AT_D_LOW = 7;
export const AT_OFF_A = 8;
export const AT_OFF_B = 9;
export const AT_OFF_C = 10;
export const AT_OFF_D = 11;
export const AT_PX = 12;
export const AT_PX_LOW = 13;
export const AT_PY = 14;
export const AT_PY_LOW = 15;
export const AT_PZ = 16;
export const AT_PZ_LOW = 17;
export const AT_FLARE = 18;
export const AT_FLARE_LOW = 19;
export const AT_SIZE = 20;

/** a·b − p for a = ah + al, b = bh + bl cut in halves (Dekker). */
export const lost = (ah: number, al: number, bh: number, bl: number, p: number): number =>
  al * bl - (p - ah * bh - al * bh - ah * bl);

/**
 * Puts A, b, C and D/4 of a ray into `algebra`. In one piece: a call that is not inlined boxes its
 * doubles.
 */
export function putAlgebra(q: Quadric, { origin: E, direction: d }: Ray, algebra: Algebra): void {
  const x = d[0];
  const y = q.hasY ? d[1] : 0;
  const z = d[2];
  const ex = E[0];
  const ey = q.hasY ? E[1] : 0;
  const ez = E[2];
  const cy = q.hasY ? q.Cy : 0;
  const px = ex - q.Cx;
  const py = ey - cy;
  const pz = ez - q.Cz;
  const pxl = sumError(ex, -q.Cx, px);
  const pyl = sumError(ey, -cy, py);
  const pzl = sumError(ez, -q.Cz, pz);
  const a = q.squared ? q.flare * q.flare : q.flare;
  const aLow = q.squared ? squareError(q.flare, a) : 0;
  const rho = q.r * q.r;
  const rhoLow = squareError(q.r, rho);
  let big = SPLITTER * x;
  const xh = big - (big - x);
  const xl = x - xh;
  big = SPLITTER * y;
  const yh = big - (big - y);
  const yl = y - yh;
  big = SPLITTER * z;
  const zh = big - (big - z);
  const zl = z - zh;
  big = SPLITTER * px;
  const pxh = big - (big - px);
  const pxm = px - pxh;
  big = SPLITTER * py;
  const pyh = big - (big - py);
  const pym = py - pyh;
  big = SPLITTER * pz;
  const pzh = big - (big - pz);
  const pzm = pz - pzh;
  big = SPLITTER * a;
  const ah = big - (big - a);
  const al = a - ah;

  const xx = x * x;
  const yy = y * y;
  const zz = z * z;
  const ayy = a * yy;
  big = SPLITTER * yy;
  const yyh = big - (big - yy);
  const round = xx + zz;
  const A0 = round - ayy;
  const A1 =
    sumError(xx, zz, round) +
    sumError(round, -ayy, A0) +
    (lost(xh, xl, xh, xl, xx) + lost(zh, zl, zh, zl, zz)) -
    (lost(ah, al, yyh, yy - yyh, ayy) + (a * lost(yh, yl, yh, yl, yy) + aLow * yy));
  const Ah = A0 + A1;
  const Al = sumError(A0, A1, Ah);

  const xp = x * px;
  const yp = y * py;
  const zp = z * pz;
  const ayp = a * yp;
  big = SPLITTER * yp;
  const yph = big - (big - yp);
  const sum = xp + zp;
  const b0 = sum - ayp;
  const b1 =
    sumError(xp, zp, sum) +
    sumError(sum, -ayp, b0) +
    (lost(xh, xl, pxh, pxm, xp) + x * pxl + (lost(zh, zl, pzh, pzm, zp) + z * pzl)) -
    (lost(ah, al, yph, yp - yph, ayp) + (a * (lost(yh, yl, pyh, pym, yp) + y * pyl) + aLow * yp));
  const bh = b0 + b1;
  const bl = sumError(b0, b1, bh);

  const pp = px * px;
  const qq = py * py;
  const rr = pz * pz;
  const aqq = a * qq;
  big = SPLITTER * qq;
  const qqh = big - (big - qq);
  const wide = pp + rr;
  const less = wide - aqq;
  const C0 = less - rho;
  const C1 =
    sumError(pp, rr, wide) +
    sumError(wide, -aqq, less) +
    sumError(less, -rho, C0) -
    rhoLow +
    (lost(pxh, pxm, pxh, pxm, pp) + 2 * px * pxl + (lost(pzh, pzm, pzh, pzm, rr) + 2 * pz * pzl)) -
    (lost(ah, al, qqh, qq - qqh, aqq) +
      (a * (lost(pyh, pym, pyh, pym, qq) + 2 * py * pyl) + aLow * qq));
  const Ch = C0 + C1;
  const Cl = sumError(C0, C1, Ch);

  const bb = bh * bh;
  const AC = Ah * Ch;
  big = SPLITTER * Ah;
  const Ahh = big - (big - Ah);
  big = SPLITTER * Ch;
  const Chh = big - (big - Ch);
  big = SPLITTER * bh;
  const bhh = big - (big - bh);
  const D0 = bb - AC;
  const D1 =
    sumError(bb, -AC, D0) +
    (lost(bhh, bh - bhh, bhh, bh - bhh, bb) + 2 * bh * bl) -
    (lost(Ahh, Ah - Ahh, Chh, Ch - Chh, AC) + (Ah * Cl + Al * Ch));
  const Dh = D0 + D1;
  const size = Math.abs(a);
  const Am = round + size * yy;
  const Cm = wide + size * qq + rho;
  algebra[AT_A] = Ah;
  algebra[AT_A_LOW] = Al;
  algebra[AT_B] = bh;
  algebra[AT_B_LOW] = bl;
  algebra[AT_C] = Ch;
  algebra[AT_C_LOW] = Cl;
  algebra[AT_D] = Dh;
  algebra[AT_D_LOW] = sumError(D0, D1, Dh);
  algebra[AT_OFF_A] = ERROR_A * Am + SMALLEST_ALGEBRA;
  algebra[AT_OFF_B] = ERROR_B * (Math.abs(xp) + Math.abs(zp) + Math.abs(ayp)) + SMALLEST_ALGEBRA;
  algebra[AT_OFF_C] = ERROR_C * Cm + SMALLEST_ALGEBRA;
  algebra[AT_OFF_D] = ERROR_D * (Am * Cm) + SMALLEST_ALGEBRA_D;
  algebra[AT_PX] = px;
  algebra[AT_PX_LOW] = pxl;
  algebra[AT_PY] = py;
  algebra[AT_PY_LOW] = pyl;
  algebra[AT_PZ] = pz;
  algebra[AT_PZ_LOW] = pzl;
  algebra[AT_FLARE] = a;
  algebra[AT_FLARE_LOW] = aLow;
  const bounded = Am < LARGE && Cm < LARGE && size < LARGE;
  const exactA = !q.squared || (yy < LARGE && qq < LARGE);
  algebra[AT_SIZE] = bounded && exactA ? Am * Cm : Number.NaN;
}

/*
 * C = px² + pz² − a·py² − r² where it cancels beyond twice the digits, E being nearly on the
 * surface: added up from the exact terms of its expansion.
 *
 *   quantity           bound              reason
 *   terms              38 of them, their  three squares for each coordinate of p, twice as many
 *                      sizes < 2Cm        products with a for the one along y, each of which is two
 *                                         doubles, and r²
 *   levels             (2n u)^4 of that   `accumulate`
 *   their sum          9u² of it          3u² in each of three sums
 *   a lost product     ≤ 2^-1073          those of the squares along y are multiplied by a, that of
 *                                         a = c² by py², both < 2^200
 */
const TERMS = 38;
/** Bounds of the table: in Cm, in |C|, and an absolute one. */
export const ACCUMULATED_ERROR = 2 * (2 * TERMS * 2 ** -53) ** 4;
export const ERROR_LEVELS = 9 * UU;
export const SMALLEST_C = 2 ** -870;

const ownLevels = lazily(newLevels);

/** The levels' sum, and one of them, as two doubles each. */
const ownSum = lazily(() => new Float64Array(4));
const TOTAL = 0;
const TOTAL_LOW = 1;
const LEVEL = 2;

/**
 * Puts C and its bound once more, from p and a in `algebra`, if that bound is the narrower one:
 * SMALLEST_C is wider than SMALLEST_ALGEBRA. A C that is 0 exactly is off by
 * nothing.
 */
export function sharpenC(algebra: Algebra, r: number): void {
  const a = algebra[AT_FLARE] as number;
  const rho = r * r;
  const levels = ownLevels();
  const sum = ownSum();
  levels.fill(0);
  addSquare(levels, algebra[AT_PX] as number, algebra[AT_PX_LOW] as number, 1, 0);
  addSquare(levels, algebra[AT_PZ] as number, algebra[AT_PZ_LOW] as number, 1, 0);
  if (a !== 0) {
    const low = algebra[AT_FLARE_LOW] as number;
    addSquare(levels, algebra[AT_PY] as number, algebra[AT_PY_LOW] as number, -a, -low);
  }
  accumulate(levels, -rho);
  accumulate(levels, -squareError(r, rho));
  // r², or a = c², underflowed, and its error with it.
  if (lostBits(r, rho) || lostBits(a, a)) levels[LEVELS] = Number.POSITIVE_INFINITY;
  dd.set(sum, TOTAL, levels[0] as number);
  for (let k = 1; k < LEVELS; k++) {
    dd.set(sum, LEVEL, levels[k] as number);
    dd.add(sum, TOTAL, TOTAL, LEVEL);
  }
  const before = algebra[AT_OFF_C] as number;
  const Cm = before / ERROR_C;
  const off = exactlyZero(levels)
    ? 0
    : ACCUMULATED_ERROR * Cm + SMALLEST_C + ERROR_LEVELS * Math.abs(sum[TOTAL] as number);
  if (!(off < before)) return;
  algebra[AT_C] = sum[TOTAL] as number;
  algebra[AT_C_LOW] = sum[TOTAL_LOW] as number;
  algebra[AT_OFF_C] = off;
}

/**
 * Whether the product p of something that is not 0 is so small that bits of it, or all, are lost,
 * and a zero would prove nothing.
 */
const lostBits = (x: number, p: number): boolean =>
  x !== 0 && !(Math.abs(p) >= LEAST_EXACT_PRODUCT);

type Levels = ReturnType<typeof newLevels>;

/** Adds (hi + lo)²·(a + aLow). */
function addSquare(levels: Levels, hi: number, lo: number, a: number, aLow: number): void {
  if (hi === 0) return;
  addScaled(levels, hi * hi, squareError(hi, hi * hi), a, aLow);
  if (lo === 0) return;
  const cross = 2 * hi * lo;
  addScaled(levels, cross, productError(2 * hi, lo, cross), a, aLow);
  addScaled(levels, lo * lo, squareError(lo, lo * lo), a, aLow);
}

function addScaled(levels: Levels, p: number, e: number, a: number, aLow: number): void {
  if (lostBits(1, p)) levels[LEVELS] = Number.POSITIVE_INFINITY;
  accumulateProduct(levels, p, a);
  accumulateProduct(levels, e, a);
  accumulateProduct(levels, p, aLow);
  accumulateProduct(levels, e, aLow);
}

/**
 * The near root and the far one, each as two doubles with a bound on its error, from NEAR and FAR
 * on. Each stage has its own, as with Algebra.
 */
export type Roots = Float64Array;
/** A `Roots` of zeros. */
export const createRoots = (): Roots => new Float64Array(6);
/** Indices into `Roots`: where the near and the far root begin. */
export const NEAR = 0;
export const FAR = 3;
/** From NEAR or FAR: what the root is more than its double, and how far both may be off. */
export const ROOT_LOW = 1;
export const ROOT_OFF = 2;

/*
 * Numbers that people type: whole multiples of 2^-8, none above 2^8, so 16 bits of units and a
 * sign; a = c² likewise. Nothing rounds then:
 *
 *   p = E − C         17 bits of 2^-8
 *   A, b, C           terms of ≤ 2^(16 + 2·17) units of 2^-24, four of them at most: ≤ 2^52
 *   b², AC            ≤ 2^104 of 2^-48, each a double and an error ≤ 2^51, which is whole
 *   D/4 = b² − AC     the difference, and what it and the products lost: ≤ 3·2^51, whole, exact
 *
 * So zeros, tangents and ties are decided here, and not by whole numbers of any length.
 */
/** x + ON_GRID − ON_GRID is x rounded to a multiple of 2^-8. */
export const ON_GRID = 1.5 * 2 ** 44;
const LONGEST = 2 ** 8;

const isShort = (x: number): boolean =>
  x + ON_GRID - ON_GRID === x && x <= LONGEST && x >= -LONGEST;

/**
 * Puts A, b, C and D/4 of a ray into `algebra`, with no error; false where a number is not short.
 */
export function putShort(q: Quadric, { origin: E, direction: d }: Ray, algebra: Algebra): boolean {
  const x = d[0];
  const z = d[2];
  if (!(isShort(x) && isShort(z) && isShort(E[0]) && isShort(E[2]))) return false;
  if (!(isShort(E[1]) && isShort(d[1]) && isShort(q.Cx) && isShort(q.Cz))) return false;
  if (!(isShort(q.r) && isShort(q.flare))) return false;
  const a = q.squared ? q.flare * q.flare : q.flare;
  if (!isShort(a) || !(q.hasY ? isShort(q.Cy) : true)) return false;
  const y = q.hasY ? d[1] : 0;
  const px = E[0] - q.Cx;
  const py = q.hasY ? E[1] - q.Cy : 0;
  const pz = E[2] - q.Cz;
  const A0 = x * x + z * z - a * (y * y) + 0;
  const b = x * px + z * pz - a * (y * py) + 0;
  const C0 = px * px + pz * pz - a * (py * py) - q.r * q.r + 0;
  const bb = b * b;
  const AC = A0 * C0;
  const D0 = bb - AC;
  const D1 = sumError(bb, -AC, D0) + (squareError(b, bb) - productError(A0, C0, AC));
  const Dh = D0 + D1 + 0;
  algebra.fill(0);
  algebra[AT_A] = A0;
  algebra[AT_B] = b;
  algebra[AT_C] = C0;
  algebra[AT_D] = Dh;
  algebra[AT_D_LOW] = sumError(D0, D1, Dh);
  algebra[AT_PX] = px;
  algebra[AT_PY] = py;
  algebra[AT_PZ] = pz;
  algebra[AT_FLARE] = a;
  const size = Math.abs(a);
  algebra[AT_SIZE] =
    (x * x + z * z + size * y * y) * (px * px + pz * pz + size * py * py + q.r * q.r);
  return true;
}

/** The verdict that the signs in `algebra` tell. */
export function shortVerdict(algebra: Algebra): number {
  const D1 = algebra[AT_D] as number;
  if (algebra[AT_A] === 0) {
    if (algebra[AT_B] !== 0) return ONE;
    return algebra[AT_C] === 0 ? CONTAINED : NONE;
  }
  if (D1 === 0) return TANGENT;
  return D1 < 0 ? NONE : TWO;
}

/** Numerator of the single root of class `verdict`, ONE or TANGENT; exact after putShort. */
export const topOf = (algebra: Algebra, verdict: number): number =>
  verdict === ONE ? -(algebra[AT_C] as number) : -(algebra[AT_B] as number);
/** Denominator of that root. */
export const bottomOf = (algebra: Algebra, verdict: number): number =>
  verdict === ONE ? 2 * (algebra[AT_B] as number) : (algebra[AT_A] as number);

/** Puts the only root, or none; `TWO` is left to putRoots. */
export function putSingle(algebra: Algebra, verdict: number, slot: RootSlot): void {
  const has = verdict === ONE || verdict === TANGENT;
  slot.t0 = has ? topOf(algebra, verdict) / bottomOf(algebra, verdict) + 0 : Number.NaN;
  slot.t1 = Number.NaN;
}

/** D/4's root if that is a double, which makes both roots quotients of whole numbers; else NaN. */
export function wholeRoot(algebra: Algebra): number {
  const s = Math.sqrt(algebra[AT_D] as number);
  const ss = s * s;
  const exact = ss === algebra[AT_D] && squareError(s, ss) === algebra[AT_D_LOW];
  return exact ? s : Number.NaN;
}
