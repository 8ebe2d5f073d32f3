import {
  type Arithmetic,
  evaluate,
  evaluateTriple,
  float64,
  type Values,
  withPoint,
  withScalars,
} from '../math/formula.ts';
import type { Vec3 } from '../math/index.ts';
import type { CurvedCourse, Rules } from './course.ts';
import { ownNumber, ownTriple, roundedTriple, usableTriple } from './own-values.ts';
import { ABSENT, type Answer, type Answers } from './types.ts';

/**
 * A, B, C, D, case, t1, t2, P1, P2, N1, N2, and of the first visible hit first, why, t, P, N. A
 * line depends on lines before it only: D on A, B, C; the roots on all four; a point on its own
 * root; a normal on its own point.
 */
export function curvedWork<T>(
  course: CurvedCourse,
  values: Values<T>,
  own: Answers,
  ar: Arithmetic<T>,
): Answers {
  const letters = lettersOf(course, values, own, ar);
  const { D } = letters;
  const all = withScalars(values, letters);
  const solved = caseOf(course, letters, ar);
  const roots = rootsOf(course, solved, all, ar);
  const ordered = course.rules.order === 'ascending' ? roots : [...roots].reverse();
  const known = ordered.map((t) => onKnownNappe(course, values, t, ar));
  const count = known.filter(Boolean).length;
  const verdict = count < ordered.length ? (COUNTED[count] ?? '') : solved;
  const { toNumber } = ar;
  const found: Record<string, Answer> = {
    ...{ A: toNumber(letters.A), B: toNumber(letters.B), C: toNumber(letters.C), D: toNumber(D) },
    case: verdict,
  };
  const forgotten = ordered.flatMap((root, i) =>
    known[i] ? [] : [{ ...hitAt(course, all, root, undefined, ar), place: i, known: false }],
  );
  // t1 and t2 number only the roots on a nappe that was not forgotten.
  const places = ordered.flatMap((_, i) => (known[i] ? [i] : []));
  const kept = ([1, 2] as const).map((i): Hit => {
    const place = places[i - 1] ?? i + 1;
    const t = ownRoot(own, i, known[place] ? ordered[place] : undefined, ar);
    return { ...hitAt(course, all, t, own[`P${i}`], ar), place, known: true };
  });
  for (const [i, { t, P, N }] of kept.entries()) {
    const some = { [`t${i + 1}`]: t, [`P${i + 1}`]: P, [`N${i + 1}`]: N };
    for (const [id, x] of Object.entries(some)) if (x !== undefined) found[id] = x;
  }
  const hits = [...forgotten, ...kept].filter(({ t }) => t !== undefined);
  hits.sort((a, b) => a.place - b.place);
  const seen = firstVisible(hits as readonly Met[], verdict, course.rules);
  const point = ownTriple(own, 'P', ar);
  if (!point) return { ...found, ...seen };
  const N = roundedTriple(evaluateTriple(course.N, ar, withPoint(values, point)), ar);
  return { ...found, ...seen, P: roundedTriple(point, ar), N };
}

type Letters<T> = Readonly<Record<'A' | 'B' | 'C' | 'D', T>>;

function lettersOf<T>(
  course: CurvedCourse,
  values: Values<T>,
  own: Answers,
  ar: Arithmetic<T>,
): Letters<T> {
  const coefficient = (id: 'A' | 'B' | 'C'): T =>
    ownNumber(own, id, ar) ?? evaluate(course[id], ar, values);
  const ABC = { A: coefficient('A'), B: coefficient('B'), C: coefficient('C') };
  const D = ownNumber(own, 'D', ar) ?? evaluate(course.D, ar, withScalars(values, ABC));
  return { ...ABC, D };
}

/** A, B, C, D and the case alone: what most inputs of a search are dropped by. */
export function curvedCase(course: CurvedCourse, values: Values<number>): Answers {
  const letters = lettersOf(course, values, {}, float64);
  return { ...letters, case: caseOf(course, letters, float64) };
}

/** The student's root if there is one or it was said not to exist, else that of the formula. */
function ownRoot<T>(own: Answers, i: 1 | 2, root: T | undefined, ar: Arithmetic<T>): T | undefined {
  return own[`t${i}`] === ABSENT ? undefined : (ownNumber(own, `t${i}`, ar) ?? root);
}

/** t, point and normal of a hit, as far as they exist. */
interface PartialHit {
  readonly t: number | undefined;
  readonly P: Vec3 | undefined;
  readonly N: Vec3 | undefined;
}

interface Hit extends PartialHit {
  /** Index among the roots in the student's order, from 0. */
  readonly place: number;
  /** False if it is on a nappe that was forgotten. */
  readonly known: boolean;
}

type Met = Hit & { readonly t: number };

type Case = 'none' | 'tangent' | 'one' | 'two' | 'contained';

const COUNTED = ['none', 'one', 'two'];

/** The absolute threshold of the misconceptions about epsilons, as in many programs. */
const EPSILON = 1e-6;

function caseOf<T>({ rules }: CurvedCourse, { A, B, C, D }: Letters<T>, ar: Arithmetic<T>): Case {
  const isZero = (x: T, epsilon: boolean): boolean =>
    ar.sign(x) === 0 || (epsilon && Math.abs(ar.toNumber(x)) < EPSILON);
  if (rules.linear !== 'ignored' && isZero(A, rules.linear === 'epsilon')) {
    if (ar.sign(B) !== 0) return 'one';
    return ar.sign(C) === 0 ? 'contained' : 'none';
  }
  const sign = isZero(D, rules.tangent === 'epsilon') ? 0 : ar.sign(D);
  if (sign < 0 || (sign === 0 && rules.tangent === 'lost')) return 'none';
  return sign === 0 ? 'tangent' : 'two';
}

/** The roots of a case, in ascending order. */
function rootsOf<T>(
  { linear, double, roots }: CurvedCourse,
  verdict: Case,
  values: Values<T>,
  ar: Arithmetic<T>,
): readonly T[] {
  if (verdict === 'none' || verdict === 'contained') return [];
  if (verdict !== 'two') return [evaluate(verdict === 'one' ? linear : double, ar, values)];
  const pair = [evaluate(roots, ar, values, -1), evaluate(roots, ar, values, 1)] as const;
  const swapped = ar.toNumber(pair[0]) > ar.toNumber(pair[1]);
  return swapped ? [pair[1], pair[0]] : pair;
}

/** Whether a root is on the upper nappe, or both nappes count. */
function onKnownNappe<T>(
  { rules, P }: CurvedCourse,
  values: Values<T>,
  t: T,
  ar: Arithmetic<T>,
): boolean {
  const vertex = values.vectors.V;
  if (rules.nappes === 'both' || !vertex) return true;
  const y = evaluate(P[1], ar, withScalars(values, { t }));
  return ar.sign(ar.sub(y, vertex[1])) >= 0;
}

function hitAt<T>(
  { P, N }: CurvedCourse,
  values: Values<T>,
  t: T | undefined,
  own: Answer | undefined,
  ar: Arithmetic<T>,
): PartialHit {
  const { toNumber } = ar;
  const computed = t === undefined ? undefined : evaluateTriple(P, ar, withScalars(values, { t }));
  const point = own === ABSENT ? undefined : (usableTriple(own, ar) ?? computed);
  const normal = point && evaluateTriple(N, ar, withPoint(values, point));
  return {
    t: t === undefined ? undefined : toNumber(t),
    P: point && roundedTriple(point, ar),
    N: normal && roundedTriple(normal, ar),
  };
}

/** The first visible of the student's hits. A tangent's one root is t1. */
function firstVisible(
  hits: readonly Met[],
  verdict: string,
  { behind, first, light }: Rules,
): Answers {
  const seen = hits.filter(({ t, known }) => known && (behind === 'accepted' || t >= 0));
  const ts = seen.map(({ t }) => t);
  const t = first === 'nearest' ? Math.min(...ts) : Math.max(...ts);
  const found = seen.find((one) => Object.is(one.t, t));
  const why = reason(hits, found, verdict);
  if (!found) return { first: 'none', why, shadow: 'lit' };
  const hidden = (t > 0 || behind === 'accepted') && (light === 'forgotten' || t < 1);
  const shadow = hidden ? 'dark' : 'lit';
  const { P, N } = found;
  const place = { first: `t${hits.indexOf(found) + 1}`, why, shadow, t };
  return P && N ? { ...place, P, N } : place;
}

/** Why the other root is not the first visible hit. */
function reason(hits: readonly Met[], found: Met | undefined, verdict: string): string {
  if (hits.length === 0) return 'no-root';
  if (!found) return 'behind';
  const other = hits.find((one) => one !== found);
  if (!other) return verdict === 'tangent' ? 'double' : 'alone';
  if (!other.known) return 'behind';
  return other.t < 0 && found.t >= 0 ? 'behind' : 'farther';
}
