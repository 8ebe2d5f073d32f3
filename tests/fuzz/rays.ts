import { FAMILIES, type Question } from '../../src/math/families.ts';
import { scale } from '../../src/math/float/bits.ts';
import { nextDown, nextUp } from '../../src/math/float/ulp.ts';
import type { Ray } from '../../src/math/ray.ts';
import { integer, pick, type Random, seeded, wide } from '../../src/math/rng.ts';
import type { Shape } from '../../src/math/shapes/index.ts';
import { disagreement, misplaced } from '../unit/math/against-exact.ts';
import { shrink } from './shrink-ray.ts';
import { unlike } from './unlike.ts';

/*
 * Certified against exact on as many rays as wanted:  npm run fuzz -- --rays 1e7 --seed 1
 * The class and roots as an object and in a batch, the points and normals of the object; and a batch of neighbours by WebAssembly against one without, bit by bit.
 * Every family of hard rays, each then bent by a few doubles, scaled, or given other exponents, so that it lands beside what its family aims
 * at. A failure is shrunk and printed as a line for tests/repro.
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

/** What certified gets wrong, in words, or null. */
function wrong(question: Question): string | null {
  const told = disagreement(question.shape, question.ray) ?? unlike(question);
  if (told) return told;
  const hits = misplaced(question);
  return hits.length ? `misplaced: ${JSON.stringify(hits)}` : null;
}

const count = option('rays', 1e5);
const seed = option('seed', 1);
const random = seeded(seed);
const start = performance.now();
let failures = 0;
let told = start;
for (let k = 0; k < count && failures < 10; k++) {
  const family = FAMILIES[k % FAMILIES.length] as (typeof FAMILIES)[number];
  const question = bent(family.make(random), random);
  if (wrong(question)) {
    failures += 1;
    const small = shrink(question, (q) => wrong(q) !== null);
    console.log(`ray ${k} of seed ${seed}, family ${family.id}: ${wrong(small)}`);
    console.log(`  ${JSON.stringify(small)},`);
  }
  const now = performance.now();
  if (now - told > 5000) {
    told = now;
    const rate = ((k + 1) / (now - start)) * 1000;
    console.log(`${k + 1} rays, ${failures} failures, ${Math.round(rate)} rays a second`);
  }
}
console.log(`${count} rays of seed ${seed}: ${failures} failures`);
process.exitCode = failures ? 1 : 0;
