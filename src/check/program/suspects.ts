import type { ShapeKind } from '../../math/shapes.ts';
import { type Course, courseOf } from '../course.ts';
import type { Answers, Input } from '../types.ts';
import { roughWork } from '../work.ts';
import type { Case } from './cases.ts';
import { FLAWS, type Flaw, type Root } from './flaws.ts';
import { type Output, sameDirection } from './judge.ts';

/** A flaw that explains every case of its branch, also those with right results. */
export interface Finding {
  readonly flaw: Flaw;
  /** Another flaw with the same results on all of these cases; null if there is none. */
  readonly or: Flaw | null;
  readonly branch: Branch;
  /** Number of cases of the branch, and of those whose results the flaw changes. */
  readonly cases: number;
  readonly changed: number;
  readonly kinds: readonly ShapeKind[];
}

/**
 * Branches of programs: cases that they usually treat in code of their own. Cases in general
 * position are explained first, other branches on top of that, so that a flaw of a branch is not
 * named for results that are wrong everywhere.
 */
export const BRANCHES = {
  general: 'in general position',
  tangent: 'with a tangent (D = 0)',
  border: 'on a rim or an edge',
  linear: 'with A = 0',
  parallel: 'with N·d = 0',
  degenerate: 'with a degenerate shape',
  hard: 'called hard',
} as const;
type Branch = keyof typeof BRANCHES;

/** Least number of cases that count as evidence. */
const LEAST = 3;
/** Share of hard cases that has to fit; others may differ by the order of operations. */
const HARD_SHARE = 0.9;

interface Seen {
  readonly one: Case;
  readonly branch: Branch;
  readonly right: readonly Root[];
  /** The program's roots; null if it threw. */
  readonly t: readonly number[] | null;
  readonly normal: readonly (readonly number[])[] | null;
}

/** The flaws that explain a program's results, found for each shape by itself. */
export function findings(cases: readonly Case[], outputs: readonly Output[]): Finding[] {
  const kinds = [...new Set(cases.map(({ shape }) => shape.kind))];
  const merged = new Map<string, Finding>();
  for (const kind of kinds) {
    const seen = cases.flatMap((one, i) => {
      const output = outputs[i];
      return Object.is(one.shape.kind, kind) && output ? seenOf(one, output) : [];
    });
    // Cases with roots come first, since they tell most formulas apart.
    const telling = [...seen.filter(hasRoots), ...seen.filter((one) => !hasRoots(one))];
    for (const found of findingsFor(kind, telling)) {
      const key = `${found.flaw.id} ${found.branch}`;
      const known = merged.get(key);
      merged.set(key, known ? sum(known, found) : found);
    }
  }
  return [...merged.values()];
}

const sum = (a: Finding, b: Finding): Finding => ({
  ...a,
  // The alternative is kept only if it is the same for both.
  or: a.or === b.or ? a.or : null,
  cases: a.cases + b.cases,
  changed: a.changed + b.changed,
  kinds: [...a.kinds, ...b.kinds],
});

function seenOf(one: Case, output: Output): Seen[] {
  if (!one.expected || output.type === 'stopped' || output.type === 'missing') return [];
  const found = roughWork(courseOf(one.shape), one);
  const right = rootsOf(found);
  const branch = branchOf(one, found);
  if (branch === 'hard' && !settled(one.expected.t, right)) return [];
  const t = output.type === 'value' ? output.t : output.type === 'shape' ? output.meant : null;
  return [{ one, branch, right, t, normal: output.type === 'value' ? output.normal : null }];
}

const hasRoots = ({ t }: Seen): boolean => t !== null && t.length > 0;

/**
 * Whether the right formulas in doubles find the exact roots. In other cases rounding decides, and
 * no formula can be told from another.
 */
const settled = (truth: readonly number[], right: readonly Root[]): boolean =>
  truth.length === right.length && truth.every((t, i) => near(t, right[i]?.t ?? Number.NaN, 1));

function branchOf({ group, family, expected }: Case, found: Answers): Branch {
  if (group === 'hard') return 'hard';
  if (family.endsWith('exactly')) return 'border';
  if (family.includes('degenerate')) return 'degenerate';
  if (found.A === 0) return 'linear';
  if (found['N.d'] === 0) return 'parallel';
  return expected?.class === 'tangent' ? 'tangent' : 'general';
}

function rootsOf(found: Answers): Root[] {
  if (found.case === 'contained' || found.inside === 'outside') return [];
  return ['1', '2'].flatMap((i): Root[] => {
    const t = found[`t${i}`];
    const normal = found[`N${i}`];
    return typeof t === 'number' ? [{ t, normal: typeof normal === 'object' ? normal : [] }] : [];
  });
}

type Predict = (flaws: readonly Flaw[], one: Input) => readonly Root[];

/**
 * Predicts what a program with exactly these flaws returns; results of equal formulas are cached.
 */
function prediction(): Predict {
  const edits = rememberedEdits();
  const known = new Map<Input, Map<string, Worked>>();
  const changesFormulas = (flaw: Flaw, one: Input): boolean => {
    if (flaw.input && flaw.input(one) !== one) return true;
    const course = courseOf(one.shape);
    return flaw.course !== undefined && edits([flaw], course) !== course;
  };
  const workedOut = (flaws: readonly Flaw[], one: Input): Worked => {
    const input = flaws.reduce<Input>((taken, flaw) => flaw.input?.(taken) ?? taken, one);
    const found = roughWork(edits(flaws, courseOf(input.shape)), input);
    return { about: { input: one, found }, roots: rootsOf(found) };
  };
  return (flaws, one) => {
    const own = known.get(one) ?? new Map<string, Worked>();
    known.set(one, own);
    const formulas = flaws.filter((flaw) => changesFormulas(flaw, one));
    const key = formulas.map(({ id }) => id).join();
    const { about, roots } = own.get(key) ?? workedOut(formulas, one);
    own.set(key, { about, roots });
    return flaws.reduce((left, flaw) => flaw.answer?.(left, about) ?? left, roots);
  };
}

interface Worked {
  readonly about: { readonly input: Input; readonly found: Answers };
  readonly roots: readonly Root[];
}

type Edits = (flaws: readonly Flaw[], course: Course) => Course;

/** Edits courses by flaws, with a cache. */
function rememberedEdits(): Edits {
  const known = new Map<Course, Map<Flaw, Course>>();
  const edited = (course: Course, flaw: Flaw): Course => {
    const own = known.get(course) ?? new Map<Flaw, Course>();
    known.set(course, own);
    const found = own.get(flaw) ?? flaw.course?.(course) ?? course;
    own.set(flaw, found);
    return found;
  };
  return (flaws, course) => flaws.reduce(edited, course);
}

function findingsFor(kind: ShapeKind, seen: readonly Seen[]): Finding[] {
  const trial = newTrial();
  const within = (branch: Branch): readonly Seen[] => seen.filter((one) => one.branch === branch);
  const general = within('general');
  const hard = within('hard');
  // Without an explanation of the general cases, flaws of a branch cannot be told from it.
  const causes = causesOf(general, hard, trial);
  if (!causes) return [];
  const found: Finding[] = [];
  const all: Flaw[] = [];
  const add = ({ flaw, or }: Cause, branch: Branch, others: readonly Flaw[]): void => {
    const of = within(branch);
    const changed = trial.changes(flaw, others, of).length;
    found.push({ flaw, or, branch, cases: of.length, changed, kinds: [kind] });
    all.push(flaw);
  };
  for (const cause of causes) {
    add(
      cause,
      'general',
      causes.filter((one) => one !== cause).map(({ flaw }) => flaw),
    );
  }
  for (const branch of Object.keys(BRANCHES) as Branch[]) {
    const of = within(branch);
    const fitting = (flaw: Flaw): boolean =>
      (branch === 'hard' ? trial.helps : trial.explains)(flaw, all, of) &&
      trial.misfits([...all, flaw], general).length === 0;
    if (branch === 'general' || trial.misfits(all, of).length < LEAST) continue;
    const cause = causeOf(FLAWS.filter(fitting));
    if (cause) add(cause, branch, [...all]);
  }
  return found;
}

interface Cause {
  readonly flaw: Flaw;
  readonly or: Flaw | null;
}

/** The first of several flaws with equal results, and the next one with another id. */
function causeOf([flaw, ...others]: readonly Flaw[]): Cause | null {
  if (!flaw) return null;
  return { flaw, or: others.find(({ id }) => id !== flaw.id) ?? null };
}

/**
 * The one or two flaws that explain all cases in general position; empty for a right program; null
 * if nothing explains them. Hard cases are not decisive, but are evidence and tell flaws apart that
 * agree in the others.
 */
function causesOf(
  general: readonly Seen[],
  hard: readonly Seen[],
  { misfits, explains, changes }: Trial,
): readonly Cause[] | null {
  if (misfits([], general, 1).length === 0) return [];
  const both = [...general, ...hard];
  if (!both.some(hasRoots)) return null;
  // Evidence is a wrong root that the flaws predict, or some right ones. Flaws that only remove
  // roots fit too many programs.
  const isEvidence = (flaws: readonly Flaw[]): boolean => {
    const off = new Set(misfits(flaws, both));
    const fitting = both.filter((one) => !off.has(one) && hasRoots(one));
    return fitting.length >= LEAST || misfits([], fitting, 1).length > 0;
  };
  const alternatives = (others: readonly Flaw[]): Cause | null => {
    const fitting = FLAWS.filter(
      (flaw) => explains(flaw, others, general, both) && isEvidence([...others, flaw]),
    ).map((flaw) => ({ flaw, off: misfits([...others, flaw], hard).length }));
    const least = Math.min(...fitting.map(({ off }) => off));
    return causeOf(fitting.flatMap(({ flaw, off }) => (off === least ? [flaw] : [])));
  };
  const one = alternatives([]);
  if (one) return [one];
  for (const [i, first] of FLAWS.entries()) {
    for (const second of FLAWS.slice(i + 1)) {
      if (misfits([first, second], general, 1).length > 0) continue;
      const needed = (flaw: Flaw, other: Flaw): boolean =>
        changes(flaw, [other], both).length >= LEAST;
      if (!needed(first, second) || !needed(second, first)) continue;
      const [a, b] = [alternatives([second]), alternatives([first])];
      if (a && b) return [a, b];
    }
  }
  return null;
}

/** Comparisons of what programs with some flaws return with what was seen. */
interface Trial {
  /** The cases whose results differ from the prediction, `most` of them at most. */
  misfits(flaws: readonly Flaw[], of: readonly Seen[], most?: number): readonly Seen[];
  /** The cases whose predicted results a flaw changes, on top of the others. */
  changes(flaw: Flaw, others: readonly Flaw[], of: readonly Seen[]): readonly Seen[];
  /** Whether it predicts all cases, and changes at least `LEAST` of them or of a larger set. */
  explains(
    flaw: Flaw,
    others: readonly Flaw[],
    of: readonly Seen[],
    larger?: readonly Seen[],
  ): boolean;
  /** Whether it predicts most of the cases it changes, and at least `LEAST` that misfit before. */
  helps(flaw: Flaw, others: readonly Flaw[], of: readonly Seen[]): boolean;
}

function newTrial(): Trial {
  const predicted = prediction();
  const rootsWith = (flaws: readonly Flaw[], { one }: Seen): readonly Root[] =>
    predicted(inOrder(flaws), one);
  const misfits: Trial['misfits'] = (flaws, of, most = of.length) => {
    const found: Seen[] = [];
    for (const seen of of) {
      if (found.length >= most) break;
      const fits = seen.t !== null && same(rootsWith(flaws, seen), seen.t, seen.normal);
      if (!fits) found.push(seen);
    }
    return found;
  };
  const changes: Trial['changes'] = (flaw, others, of) =>
    of.filter((seen) => {
      const without = rootsWith(others, seen);
      const normals = seen.normal && without.map(({ normal }) => normal);
      const t = without.map((root) => root.t);
      return !same(rootsWith([...others, flaw], seen), t, normals);
    });
  return {
    misfits,
    changes,
    explains: (flaw, others, of, larger = of) =>
      misfits([...others, flaw], of, 1).length === 0 &&
      changes(flaw, others, larger).length >= LEAST,
    helps(flaw, others, of) {
      const changed = changes(flaw, others, of);
      const off = misfits([...others, flaw], changed).length;
      return (
        off <= (1 - HARD_SHARE) * changed.length && misfits(others, changed).length - off >= LEAST
      );
    },
  };
}

/** The flaws in the order in which they take effect: input, formulas, roots. */
const inOrder = (flaws: readonly Flaw[]): readonly Flaw[] =>
  [...flaws].sort((a, b) => (ORDER.get(a) ?? 0) - (ORDER.get(b) ?? 0));
const ORDER = new Map(FLAWS.map((flaw, i) => [flaw, i] as const));

/** Relative tolerance for the roots of two programs with another order of operations. */
const ALIKE = 1e-6;

function same(
  roots: readonly Root[],
  t: readonly number[],
  normals: readonly (readonly number[])[] | null,
): boolean {
  if (roots.length !== t.length) return false;
  const size = Math.max(1, ...t.filter(Number.isFinite).map(Math.abs));
  if (!roots.every((root, i) => near(root.t, t[i] ?? Number.NaN, size))) return false;
  return !normals || roots.every(({ normal }, i) => sameDirection(normals[i] ?? [], normal));
}

/** Whether two roots agree: relative to their size, or near 0 relative to `size`. */
function near(x: number, y: number, size: number): boolean {
  if (!Number.isFinite(x) || !Number.isFinite(y)) return Number.isFinite(x) === Number.isFinite(y);
  const off = Math.abs(x - y);
  return off <= ALIKE * Math.max(Math.abs(x), Math.abs(y)) || off <= 1e-12 * size;
}
