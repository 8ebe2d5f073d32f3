import { FAMILIES, type Family, type Question } from '../../src/math/families.ts';
import { scale } from '../../src/math/float/bits.ts';
import { nextDown, nextUp } from '../../src/math/float/ulp.ts';
import type { Ray } from '../../src/math/ray.ts';
import { integer, pick, type Random, seeded, wide } from '../../src/math/rng.ts';
import type { Shape } from '../../src/math/shapes/index.ts';
import { disagreement, misplaced } from '../unit/math/against-exact.ts';
import { exactHits } from '../unit/math/exact-hits.ts';
import { aimed, scaled } from '../unit/math/whole-scenes.ts';
import { shrink } from './shrink-ray.ts';
import { unlike } from './unlike.ts';

/*
 * Certified against exact on as many rays as wanted:  npm run fuzz -- --rays 1e7 --seed 1
 * The class and roots as an object and in a batch, the points and normals of the object; and, for
 * one ray in eight, a batch of neighbours by WebAssembly against one without, bit by bit. Hard rays
 * of every family, in turn bent by a few doubles, or given other exponents, so that they land
 * beside what their family aims at; the same as whole scenes in units near the thresholds of the
 * source; and rays for which C, which cancels, is near one of them
 * (tests/unit/math/whole-scenes.ts). --only scaled,aimed asks about these kinds. A failure is
 * shrunk and printed as a line for tests/repro.
 */
const option = (name: string, usual: number): number => {
  const at = process.argv.indexOf(`--${name}`);
  const given = at < 0 ? usual : Number(process.argv[at + 1]);
  if (!(given >= 0))
    throw new RangeError(`--${name} must be a number ≥ 0, got ${process.argv[at + 1]}`);
  return given;
};

type Bend = (x: number, random: Random) => number;
const BENDS: readonly [Bend, ...Bend[]] = [
  (x) => x,
  (x) => nextUp(x),
  (x) => nextDown(x),
  (x, random) => scale(x, integer(random, -60, 60)),
  (x, random) => scale(x, integer(random, -1100, 1000)),
  () => 0,
  (_, random) => wide(random),
  (_, random) => wide(random, -1074, -900),
  (_, random) => integer(random, -3, 3),
];

const MAX = Number.MAX_VALUE;
const finite = (x: number): number => (x > MAX ? MAX : x < -MAX ? -MAX : x);

/** A question with a few of its numbers bent; one in three is left as its family made it. */
function bent({ shape, ray }: Question, random: Random): Question {
  const chance = pick(random, [0, 0.08, 0.3]);
  const touch = (x: number): number =>
    random() < chance ? finite(pick(random, BENDS)(x, random)) : x;
  const entries = Object.entries(shape).map(([key, x]): [string, unknown] => {
    if (Array.isArray(x)) return [key, x.map(touch)];
    if (typeof x !== 'number') return [key, x];
    return [key, key === 'radius' || key === 'side' ? Math.abs(touch(x)) : touch(x)];
  });
  const made = Object.fromEntries(entries) as unknown as Shape;
  const direction = ray.direction.map(touch) as unknown as Ray['direction'];
  return {
    shape: 'normal' in made && made.normal.every((x) => x === 0) ? shape : made,
    ray: {
      origin: ray.origin.map(touch) as unknown as Ray['origin'],
      direction: direction.every((x) => x === 0) ? ray.direction : direction,
    },
  };
}

const KINDS: Readonly<Record<string, (question: Question, random: Random) => Question>> = {
  bent,
  scaled: (question, random) => scaled(random() < 0.5 ? question : bent(question, random), random),
  aimed: (_, random) => aimed(random),
};

/** What certified gets wrong, in words, or null. */
function wrong(question: Question, batches: boolean): string | null {
  const truth = exactHits(question.shape, question.ray);
  const told =
    disagreement(question.shape, question.ray, truth) ?? (batches ? unlike(question) : null);
  if (told) return told;
  const hits = misplaced(question, truth);
  return hits.length ? `misplaced: ${JSON.stringify(hits)}` : null;
}

const count = option('rays', 1e5);
const seed = option('seed', 1);
const at = process.argv.indexOf('--only');
const only = at < 0 ? Object.keys(KINDS) : (process.argv[at + 1] ?? '').split(',');
for (const kind of only) {
  if (!KINDS[kind]) throw new RangeError(`--only must be ${Object.keys(KINDS).join(', ')}`);
}
const random = seeded(seed);
const start = performance.now();
let failures = 0;
let told = start;
let asked = 0;
for (; asked < count && failures < 10; asked++) {
  const family = FAMILIES[Math.floor(asked / only.length) % FAMILIES.length] as Family;
  const kind = only[asked % only.length] as string;
  const question = KINDS[kind]?.(family.make(random), random) as Question;
  if (wrong(question, asked % 8 === 0)) {
    failures += 1;
    const small = shrink(question, (q) => wrong(q, true) !== null);
    console.log(
      `ray ${asked} of seed ${seed}, ${kind}, family ${family.id}: ${wrong(small, true)}`,
    );
    console.log(`  ${JSON.stringify(small)},`);
  }
  // Where a clock costs a call of the system, it is not asked at each ray.
  const now = asked % 256 === 0 ? performance.now() : told;
  if (now - told > 5000) {
    told = now;
    const rate = ((asked + 1) / (now - start)) * 1000;
    console.log(`${asked + 1} rays, ${failures} failures, ${Math.round(rate)} rays a second`);
  }
}
console.log(`${asked} rays of seed ${seed}, ${only.join(', ')}: ${failures} failures`);
process.exitCode = failures ? 1 : 0;
