import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname, join } from 'node:path';
import { batchesOf } from '../../src/lab/plan.ts';
import { qualityOf } from '../../src/lab/quality.ts';
import { accelerate } from '../../src/math/accelerate.ts';
import { FAMILIES, type Family } from '../../src/math/families.ts';
import { METHODS } from '../../src/math/methods/index.ts';
import {
  besides,
  betweenMarks,
  familyTable,
  headline,
  type Ladder,
  type Measured,
  objectLines,
  otherLines,
  quartilesTable,
} from './ladder-report.ts';
import { leftBy } from './left.ts';
import { objectPrices } from './objects.ts';
import { besideOthers } from './others.ts';
import { type Asked, type Form, pricesOf, TARGETS } from './prices.ts';
import { reasonLines, reasonsOf, sampleOf } from './reasons.ts';
import { referencePrices } from './reference.ts';

/*
 * What each method costs, as a ratio to textbook in the same target, and what it gets wrong. Rays
 * are drawn from seed 2026. Writes docs/bench.md, its first table into the README, and the numbers
 * that the Accuracy page starts from. A smaller run, by `--families a,b`, `--rounds 3` or `--rays
 * 4096`, writes all three below test-results/ unless `--write` says otherwise.
 */
const SEED = 2026;
const SHAPES = 6;
/** Of a family, to count mistakes; and to be timed. */
const COUNT = 512;
const MANY = 65_536;

const option = (name: string): string | undefined => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? undefined : process.argv[at + 1];
};
function numberOf(name: string, usual: number): number {
  const given = Number(option(name) ?? usual);
  if (!(given >= 1)) throw new RangeError(`--${name} must be at least 1, got ${option(name)}`);
  return given;
}
const chosen = option('families');
const families = chosen
  ? FAMILIES().filter(({ id }) => chosen.split(',').includes(id))
  : FAMILIES();
const rounds = numberOf('rounds', 15);
const many = numberOf('rays', MANY);
const whole = (!chosen && rounds >= 15 && many >= MANY) || process.argv.includes('--write');
const PLAN = { rounds, least: 4, steps: 100, warmUp: 2 };
const print = (lines: readonly string[]): void => console.log(lines.join('\n'));

accelerate();

const ask = (methods: readonly (typeof METHODS)[number][], form: Form): Asked[] =>
  methods.flatMap((method) => TARGETS.map((target) => ({ method, target, form })));
const named = (...ids: readonly string[]): readonly (typeof METHODS)[number][] =>
  METHODS.filter(({ id }) => ids.includes(id));
const find = (id: string): Family => FAMILIES().find((family) => family.id === id) as Family;

const BIG = { seed: SEED, shapes: SHAPES, count: many };
const typical = pricesOf(
  find('typical'),
  BIG,
  [...ask(METHODS, 'both'), ...ask(METHODS, 'classes'), ...ask(METHODS, 'first')],
  PLAN,
);
const onSurface = pricesOf(
  find('near-surface'),
  BIG,
  ask(named('textbook', 'certified'), 'both'),
  PLAN,
);
const objects = objectPrices(SEED, { ...PLAN, warmUp: 10 });
const others = besideOthers(SEED, many, PLAN);
const byTrees = METHODS.filter(({ id }) => id !== 'exact');
const reasons = reasonLines(reasonsOf(find('typical'), sampleOf(many), byTrees, PLAN), byTrees);

function measured(family: Family): Measured {
  const sample = { seed: SEED, shapes: SHAPES, count: COUNT };
  const batches = batchesOf(family, sample);
  const few = { rounds: Math.min(rounds, 5), least: 1, steps: 100, warmUp: 4 };
  return {
    family,
    quality: new Map(METHODS.map((method) => [method.id, qualityOf(method, batches)])),
    left: new Map(METHODS.map((method) => [method.id, leftBy(method, batches)])),
    prices: pricesOf(family, sample, ask(METHODS, 'both'), few, ['random']),
    rays: SHAPES * COUNT,
  };
}

const all = families.map((family) => {
  const one = measured(family);
  print(familyTable(one));
  return one;
});
const ladder: Ladder = { typical, onSurface, methods: METHODS, measured: all };
const first = headline(ladder);

const about = [
  '# What accuracy costs',
  '',
  `Node ${process.version}, ${cpus()[0]?.model ?? 'unknown processor'}; seed ${SEED}; ` +
    `written by \`npm run bench -- ladder\`. Times are the processor's, of one run in ` +
    `which everything takes turns; each figure is the median of ${rounds} rounds' ratios ` +
    `to \`textbook\` in the same column. Typical rays, both roots, ${SHAPES} shapes × ` +
    `${many} rays, each met once a pass, so that no processor knows by heart which of them ` +
    `hit: in random order, and sorted, hits first and misses then. SIMD is WebAssembly ` +
    `with vectors (src/math/accelerate.ts), a dash: there is no such kernel. Ulps are ` +
    `counted from the correctly rounded root, for rays whose class is right.`,
  '',
];
const lines = [
  ...besides(ladder),
  '## With quartiles',
  '',
  ...quartilesTable(ladder),
  '',
  '## Why',
  '',
  ...reasons,
  '',
  '## One ray at a time',
  '',
  ...objectLines(objects),
  '',
  '## Beside what others use',
  '',
  `A sphere and a plane, ${many} rays each. three.js has d of length 1 before the clock ` +
    `runs; a mesh is not the sphere, which is most of its wrong verdicts.`,
  '',
  ...otherLines(others),
  '',
  '## Every family',
  '',
  `${SHAPES} shapes × ${COUNT} rays, asked again and again: branches are learned, so ` +
    `these prices compare methods, not orders. Mistakes are counted on all of these rays. ` +
    `What a loop leaves, because a number leaves its range, the method answers ray by ray, at ` +
    `many times the loop's price: where that share is large, the price is that of the leaving.`,
  '',
];
print([...first, '', ...lines]);
const into = (path: string): string => {
  const file = whole ? path : join('test-results', path);
  mkdirSync(dirname(file), { recursive: true });
  return file;
};
const tables = all.flatMap(familyTable);
writeFileSync(into('docs/bench.md'), [...about, ...first, '', ...lines, ...tables].join('\n'));
writeFileSync(into('README.md'), betweenMarks(readFileSync('README.md', 'utf8'), first));
const { version } = JSON.parse(readFileSync('package.json', 'utf8')) as { version: string };
const date = new Date().toISOString().slice(0, 10);
const reference = referencePrices(typical, METHODS, { date, version, rounds });
writeFileSync(
  into('src/pages/accuracy/reference-prices.json'),
  `${JSON.stringify(reference, null, 2)}\n`,
);
