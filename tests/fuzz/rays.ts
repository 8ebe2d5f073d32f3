import { FAMILIES, type Family, type Question } from '../../src/math/families.ts';
import { type Random, seeded } from '../../src/math/rng.ts';
import { disagreement, misplaced } from '../unit/math/against-exact.ts';
import { exactHits } from '../unit/math/exact-hits.ts';
import { aimed, scaled } from '../unit/math/whole-scenes.ts';
import { bent } from './bent.ts';
import { atKernelLimits, unlikeTrees } from './kernel-bits.ts';
import { shrink } from './shrink-ray.ts';
import { unlike, unlikeAll } from './unlike.ts';

/*
 * Certified against exact on as many rays as wanted:  npm run fuzz -- --rays 1e7 --seed 1
 * The class and roots as an object and in a batch, the points and normals of the object; and, for
 * one ray in eight, a batch of neighbours by WebAssembly against one without, and the first hit of
 * a prepared shape against the first one of all, bit by bit. Hard rays
 * of every family, in turn bent by a few doubles, or given other exponents, so that they land
 * beside what their family aims at; the same as whole scenes in units near the thresholds of the
 * source; and rays for which C, which cancels, is near one of them
 * (tests/unit/math/whole-scenes.ts). Beside: every kernel that is made of trees against its tree,
 * bit by bit (kernel-bits.ts). --only scaled,kernels asks about these kinds. A failure is shrunk
 * and printed as a line for tests/repro.
 */
const option = (name: string, usual: number): number => {
  const at = process.argv.indexOf(`--${name}`);
  const given = at < 0 ? usual : Number(process.argv[at + 1]);
  if (!(given >= 0))
    throw new RangeError(`--${name} must be a number ≥ 0, got ${process.argv[at + 1]}`);
  return given;
};

interface Kind {
  make(question: Question, random: Random): Question;
  /** What is wrong there, in words, or null; `batches`: long comparisons are wanted too. */
  wrong(question: Question, batches: boolean): string | null;
}

const KINDS: Readonly<Record<string, Kind>> = {
  bent: { make: bent, wrong: certifiedWrong },
  scaled: {
    make: (question, random) => scaled(random() < 0.5 ? question : bent(question, random), random),
    wrong: certifiedWrong,
  },
  aimed: { make: (_, random) => aimed(random), wrong: certifiedWrong },
  kernels: {
    make: (question, random) => atKernelLimits(bent(question, random), random),
    wrong: unlikeTrees,
  },
};

/** What certified gets wrong, in words, or null. */
function certifiedWrong(question: Question, batches: boolean): string | null {
  const truth = exactHits(question.shape, question.ray);
  const told =
    disagreement(question.shape, question.ray, truth) ??
    (batches ? (unlike(question) ?? unlikeAll(question)) : null);
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
  const family = FAMILIES()[Math.floor(asked / only.length) % FAMILIES().length] as Family;
  const name = only[asked % only.length] as string;
  const { make, wrong } = KINDS[name] as Kind;
  const question = make(family.make(random), random);
  if (wrong(question, asked % 8 === 0)) {
    failures += 1;
    const small = shrink(question, (q) => wrong(q, true) !== null);
    console.log(
      `ray ${asked} of seed ${seed}, ${name}, family ${family.id}: ${wrong(small, true)}`,
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
