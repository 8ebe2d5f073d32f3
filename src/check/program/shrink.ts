import { intersect, type Vec3 } from '../../math/index.ts';
import { seeded } from '../../math/rng.ts';
import { AXES, definitionOf, type Param } from '../../math/shapes.ts';
import { drawInput } from '../exercises/draw.ts';
import type { Input } from '../types.ts';
import { caseBranch } from './branches.ts';
import type { Case } from './cases.ts';
import { judgeCase, type Output } from './judge.ts';
import { type BranchReport, type Failure, reasonOf } from './report.ts';

/*
 * The smallest case that fails as a given one does: the program runs again on simpler inputs of the
 * same branch, and the simplest that it fails in the same way is the next to be made simpler. The
 * same program gives the same case each time, if it gives the same results.
 */

/** Runs the program on further cases; fewer outputs than cases if it ended before. */
export type RunAgain = (cases: readonly Case[]) => Promise<readonly (Output | undefined)[]>;

/** Most times that the program is started again, and cases of a branch at a time. */
const MOST_ROUNDS = 12;
const MOST_CASES = 40;

/** Inputs with small whole numbers, among which those of a branch are looked for first. */
const DRAWN = 600;

/** The branches with their failing cases shrunk; `progress` is told of each start. */
export async function shrunk(
  branches: readonly BranchReport[],
  again: RunAgain,
  progress: (round: number) => void = () => {},
): Promise<readonly BranchReport[]> {
  let found = branches;
  let open = new Set(branches.filter(isOpen));
  for (let round = 1; round <= MOST_ROUNDS && open.size > 0; round++) {
    progress(round);
    const asked = [...open].map((branch) => ({ branch, cases: simpler(branch, round === 1) }));
    const cases = asked.flatMap((one) => one.cases);
    if (cases.length === 0) break;
    const outputs = await again(cases);
    let at = 0;
    const next = new Set<BranchReport>();
    for (const { branch, cases: own } of asked) {
      const fails = own.flatMap((one, i): Failure[] => failure(branch, one, outputs[at + i]));
      at += own.length;
      const [first] = fails;
      if (!first) continue;
      const smaller = { ...branch, first };
      found = found.map((one) => (one === branch ? smaller : one));
      next.add(smaller);
    }
    open = next;
  }
  return found;
}

/** Invalid inputs are as simple as they can be. */
const isOpen = ({ id, first }: BranchReport): boolean => first !== null && id !== 'invalid';

function failure(branch: BranchReport, one: Case, output: Output | undefined): Failure[] {
  if (!output || output.type === 'missing') return [];
  const verdict = judgeCase(one, output);
  const before = branch.first?.verdict;
  const same = before !== undefined && reasonOf(verdict.says) === reasonOf(before.says);
  return !verdict.passed && same ? [{ case: one, output, verdict }] : [];
}

/** Simpler cases of the branch, the simplest first. */
function simpler({ id, first }: BranchReport, isFirst: boolean): Case[] {
  if (!first) return [];
  const { shape, ray, group, family } = first.case;
  const now: Input = { shape, ray };
  const limit = sizeOf(now);
  const seen = new Set([textOf(now)]);
  const all = [...(isFirst && id !== 'hard' ? drawn(now) : []), ...edits(now)]
    .map((input) => ({ input, size: sizeOf(input) }))
    .filter(({ size }) => size < limit)
    .sort((a, b) => a.size - b.size);
  const found: Case[] = [];
  for (const { input } of all) {
    if (found.length === MOST_CASES) break;
    const text = textOf(input);
    if (seen.has(text)) continue;
    seen.add(text);
    if (!isValid(input) || caseBranch(input, group) !== id) continue;
    const { class: verdict, hits } = intersect(input.shape, input.ray, 'exact');
    if (hits.some(({ t }) => !Number.isFinite(t))) continue;
    const t = hits.map((hit) => hit.t);
    const normal = hits.map((hit) => hit.normal);
    const expected = { class: verdict, t, normal };
    found.push({ ...input, id: `${first.case.id}/simpler`, group, family, expected });
  }
  return found;
}

const textOf = ({ shape, ray }: Input): string => JSON.stringify([shape, ray]);

/** Whole numbers, 0 and 1 first: how much there is to write, and then how large it is. */
const costOf = (x: number): number => {
  if (x === 0) return 0;
  const digits = Number.isInteger(x) ? String(Math.abs(x)).length : 3 + String(Math.abs(x)).length;
  return 1 + digits + (x < 0 ? 0.5 : 0) + Math.min(1, Math.abs(x) / 100);
};

const sizeOf = (input: Input): number =>
  numbersOf(input).reduce((sum, { value }) => sum + costOf(value), 0);

/** One number of an input, and the same input with another in its place. */
interface InputNumber {
  readonly value: number;
  with(x: number): Input;
}

const replaced = (v: Vec3, i: number, x: number): Vec3 =>
  v.map((old, k) => (k === i ? x : old)) as unknown as Vec3;

function numbersOf(input: Input): InputNumber[] {
  const { shape, ray } = input;
  const ofRay = (['origin', 'direction'] as const).flatMap((key) =>
    AXES.map(
      (_, i): InputNumber => ({
        value: ray[key][i] ?? 0,
        with: (x) => ({ shape, ray: { ...ray, [key]: replaced(ray[key], i, x) } }),
      }),
    ),
  );
  const numbers = shape as unknown as Readonly<Record<string, unknown>>;
  const put = (key: string, value: unknown): Input => ({
    shape: { ...shape, [key]: value } as Input['shape'],
    ray,
  });
  const ofShape = definitionOf(shape).params.flatMap(({ key, type }: Param): InputNumber[] => {
    const value = numbers[key];
    if (type === 'number' && typeof value === 'number') {
      return [{ value, with: (x) => put(key, x) }];
    }
    if (type !== 'vector' || !Array.isArray(value)) return [];
    const vector = value as unknown as Vec3;
    return AXES.map((_, i) => ({
      value: vector[i] ?? 0,
      with: (x) => put(key, replaced(vector, i, x)),
    }));
  });
  return [...ofRay, ...ofShape];
}

const rounded = (x: number, digits: number): number => Number(x.toPrecision(digits));

/** All numbers changed alike. */
const everywhere = (input: Input, change: (x: number) => number): Input =>
  numbersOf(input).reduce((made, _, i) => {
    const place = numbersOf(made)[i];
    return place ? place.with(change(place.value)) : made;
  }, input);

/** The input with fewer digits, zeros, a shorter d, or moved so that the shape stands at 0. */
function edits(input: Input): Input[] {
  const places = numbersOf(input);
  const single = places.flatMap((place) => {
    const { value: x } = place;
    const wanted = [
      0,
      1,
      -1,
      2,
      Math.round(x),
      Math.trunc(x / 2),
      -x,
      rounded(x, 2),
      rounded(x, 1),
    ];
    return wanted.filter((w) => w !== x).map((w) => place.with(w));
  });
  const whole = [
    everywhere(input, Math.round),
    everywhere(input, (x) => Math.round(2 * x) / 2),
    everywhere(input, Math.trunc),
    ...[1, 2, 3, 6].map((digits) => everywhere(input, (x) => rounded(x, digits))),
  ];
  return [...single, ...whole, ...shorter(input), ...moved(input), ...pairs(input)];
}

/** d divided by its largest component, by 2, or turned into an axis. */
function shorter({ shape, ray }: Input): Input[] {
  const { origin, direction } = ray;
  const largest = Math.max(...direction.map(Math.abs));
  const by = (k: number): Input => ({
    shape,
    ray: { origin, direction: direction.map((x) => x / k) as unknown as Vec3 },
  });
  const axes = AXES.flatMap((_, i) =>
    [1, -1].map(
      (x): Input => ({
        shape,
        ray: { origin, direction: replaced([0, 0, 0], i, x) },
      }),
    ),
  );
  return [...(largest > 0 ? [by(largest), by(2), by(-1)] : []), ...axes];
}

/** Everything moved by whole numbers, or at once, so that the shape's point is 0. */
function moved({ shape, ray }: Input): Input[] {
  const numbers = shape as unknown as Readonly<Record<string, unknown>>;
  const at = definitionOf(shape).anchor(shape).at;
  const by = (off: Vec3): Input => {
    const less = (v: readonly number[]): Vec3 =>
      v.map((x, i) => x - (off[i] ?? 0)) as unknown as Vec3;
    const points = definitionOf(shape).params.flatMap((param) => {
      const value = numbers[param.key];
      const isPoint = param.type === 'vector' && !param.nonZero && Array.isArray(value);
      return isPoint ? [[param.key, less(value as number[])] as const] : [];
    });
    return {
      shape: { ...shape, ...Object.fromEntries(points) } as Input['shape'],
      ray: { ...ray, origin: less(ray.origin) },
    };
  };
  return [by(at), by(at.map(Math.round) as unknown as Vec3)];
}

/** E and the same component of d exchanged for smaller ones: two zeros at a time. */
function pairs(input: Input): Input[] {
  const places = numbersOf(input);
  return places.flatMap((_, i) =>
    places.slice(i + 1).flatMap((__, k) => {
      const first = numbersOf(input)[i]?.with(0) ?? input;
      return numbersOf(first)[i + 1 + k]?.with(0) ?? [];
    }),
  );
}

/** Small whole numbers about a shape of this kind: the same each time. */
function drawn({ shape }: Input): Input[] {
  const random = seeded(1);
  return Array.from({ length: DRAWN }, () => drawInput(random, shape.kind, 1));
}

/** Whether the math module takes it. */
function isValid({ shape, ray }: Input): boolean {
  try {
    intersect(shape, ray, 'exact');
    return true;
  } catch {
    return false;
  }
}
